// Numbers that no scene should have, one at a time in every place of a file of every kind: the file is refused, or it renders,
// mended or not, without a rejected sample.
#include <gtest/gtest.h>

#include <bit>
#include <cctype>

#include <fmt/format.h>

#include "app/load_scene.h"
#include "formats/samples.h"
#include "render/renderer.h"
#include "scene/relative_to_camera.h"
#include "support/stability.h"

namespace umbral::test {
namespace {

struct Fates {
  int refused = 0, rendered = 0;
  std::uint64_t rejected = 0;
};

class HostileNumbers : public SceneFolder {
 public:
  HostileNumbers() {
    for (const Sample& sample : samples()) write(sample.file, sample.bytes);
  }

  // Reads and renders the sample with these bytes instead of its own; `what` was done to them.
  void meet(const Sample& sample, const std::string& bytes, const std::string& what) {
    SCOPED_TRACE(fmt::format("{}: {}", sample.file, what));
    write(sample.file, bytes);
    try {
      LoadedScene loaded = load_scene(path(sample.scene));
      RenderOptions options;
      options.film = loaded.file.film;
      options.film.width = 6;
      options.film.height = 4;
      options.sampling.spp = options.sampling.replicates = 4;
      const Scene scene(relative_to_camera(std::move(loaded.file.scene)));
      const RenderResult result = render(scene, loaded.integrator("path"), options);
      EXPECT_EQ(result.film->rejected(), 0u);
      fates_.rejected += result.film->rejected();
      ++fates_.rendered;
    } catch (const SceneError& error) {
      EXPECT_FALSE(error.diagnostics().empty());
      ++fates_.refused;
    }
  }

  void mend(const Sample& sample) const { write(sample.file, sample.bytes); }
  const Fates& fates() const { return fates_; }

 private:
  Fates fates_;
};

bool begins_number(const std::string& text, std::size_t at) {
  const auto is_digit = [&](std::size_t i) {
    return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i]));
  };
  if (at > 0 && !std::strchr(" \t\n[,='\"(/;:", text[at - 1])) return false;
  if (is_digit(at)) return true;
  return (text[at] == '-' || text[at] == '.') && is_digit(at + 1);
}

constexpr const char* text_numbers[] = {"nan",  "inf",  "-inf", "0",     "-1",     "180",  "1e-45", "1e-310",
                                        "1e10", "1e19", "1e30", "-1e30", "3.4e38", "1e39", "1e300"};

void meet_text(HostileNumbers& folder, const Sample& sample) {
  const std::string& text = sample.bytes;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (!begins_number(text, at)) continue;
    const std::size_t end = std::min(text.find_first_not_of("0123456789.eE-+", at), text.size());
    for (const char* number : text_numbers)
      folder.meet(sample, text.substr(0, at) + number + text.substr(end),
                  fmt::format("{} for {} at {}", number, text.substr(at, end - at), at));
    at = end;
  }
  folder.mend(sample);
}

void meet_binary(HostileNumbers& folder, const Sample& sample) {
  const std::size_t step = sample.bytes.size() > 1000 ? 4 : 1;
  for (std::size_t at = 0; at + 4 <= sample.bytes.size(); at += step)
    for (const float number : {std::numeric_limits<float>::quiet_NaN(), infinity, 1e-45f, -1e30f, 3e38f}) {
      std::string bytes = sample.bytes;
      const auto bits = std::bit_cast<std::array<char, 4>>(number);
      std::copy(bits.begin(), bits.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
      folder.meet(sample, bytes, fmt::format("{} at byte {}", number, at));
    }
  folder.mend(sample);
}

class HostileNumbersIn : public testing::TestWithParam<Sample> {};

TEST_P(HostileNumbersIn, EveryPlaceAreRefusedOrMendedOrRender) {
  const Sample& sample = GetParam();
  HostileNumbers folder;
  const bool is_binary = std::any_of(sample.bytes.begin(), sample.bytes.end(),
                                     [](char c) { return c >= 0 && c < 32 && c != '\n' && c != '\t'; });
  is_binary ? meet_binary(folder, sample) : meet_text(folder, sample);
  const Fates& fates = folder.fates();
  EXPECT_GT(fates.rendered, 0);
  record({"Bad input",
          fmt::format("denormal, huge, infinite or no numbers anywhere in {} bring rejected samples",
                      sample.file),
          "0 samples",
          fmt::format("{}; {} files refused, {} rendered", fates.rejected, fates.refused, fates.rendered)});
}

INSTANTIATE_TEST_SUITE_P(Samples, HostileNumbersIn, testing::ValuesIn(samples()), [](const auto& tested) {
  std::string name = tested.param.file;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
});

}  // namespace
}  // namespace umbral::test
