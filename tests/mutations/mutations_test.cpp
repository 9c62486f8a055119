// The gate is awake: each of eight known mistakes is found, and nothing is found where there is none.
#include <gtest/gtest.h>

#include <cctype>

#include "analysis/e_process.h"
#include "mutations/experiments.h"
#include "mutations/mutants.h"
#include "render/pixel_sampler.h"

namespace umbral::test {
namespace {

std::string name_of_case(const testing::TestParamInfo<Experiment>& tested) {
  const Experiment& e = tested.param;
  std::string name;
  for (const char c : e.mutation.empty() ? e.oracle : e.mutation)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
  return name;
}

// How often is told by tools/mutation_table.
class Mutation : public testing::TestWithParam<Experiment> {};

TEST_P(Mutation, IsCaught) {
  const Judgement judgement = GetParam().decide(0);
  EXPECT_EQ(judgement.outcome, Outcome::differs) << judgement.text();
}

INSTANTIATE_TEST_SUITE_P(Eight, Mutation, testing::ValuesIn(mutations()), name_of_case);

class NothingWrong : public testing::TestWithParam<Experiment> {};

TEST_P(NothingWrong, IsNoAlarm) {
  const Judgement judgement = GetParam().decide(0);
  EXPECT_EQ(judgement.outcome, Outcome::agrees) << judgement.text();
}

INSTANTIATE_TEST_SUITE_P(Oracles, NothingWrong, testing::ValuesIn(null_experiments()), name_of_case);

// Samples of the furnace, in units of what it must be, until light seems to be made from nothing or `most` are drawn.
EnergyGain watched_furnace(Integrator& integrator, std::uint64_t most) {
  const Experiment furnace = null_experiments().front();
  const int size = furnace.truth.width;
  const Vec3d truth = furnace.truth.at(0, 0);
  integrator.prepare(*furnace.scene);
  SamplingSettings sampling;
  sampling.sampler = SamplerKind::independent;
  const PixelSampler pixels(*furnace.scene, integrator, {size, size, FilterKind::box, 0}, sampling);
  EnergyGain gain(1);
  for (std::uint64_t i = 0; i < most && !gain.rejects(1e-5); ++i) {
    const auto pixel = static_cast<std::uint32_t>(i % 256);
    const Spectrum light = pixels.sample({0, pixel % 16, pixel / 16, 0, i / 256}, {}).radiance;
    gain.add((light.r / truth.r + light.g / truth.g + light.b / truth.b) / 3);
  }
  return gain;
}

// Whatever the number of samples, the chance of a false alarm is 10⁻⁵.
TEST(Energy, IsNotMadeFromNothing) {
  const EnergyGain gain = watched_furnace(*make_unchanged(0, 0), 400'000);
  EXPECT_FALSE(gain.rejects(1e-5)) << gain.p();
}

TEST(Energy, MadeFromNothingIsSeen) {
  for (const auto& make : {make_mis_weight_dropped, make_cosine_missing}) {
    const EnergyGain gain = watched_furnace(*make(0, 0), 400'000);
    EXPECT_TRUE(gain.rejects(1e-5)) << gain.p();
    testing::Test::RecordProperty("samples", std::to_string(gain.count()));
  }
}

// Tables of the binomial distribution: none of 299 misses shows 99 %.
TEST(ClopperPearson, LimitsAreThePublishedOnes) {
  EXPECT_NEAR(clopper_pearson_lower(299, 299), 0.99003, 5e-6);
  EXPECT_NEAR(clopper_pearson_lower(8, 10), 0.4931, 5e-5);
  EXPECT_NEAR(clopper_pearson_upper(0, 200), 0.01487, 5e-6);
  EXPECT_EQ(clopper_pearson_upper(5, 5), 1);
}

}  // namespace
}  // namespace umbral::test
