// Ranges, tables of parameters, and kinds by name.
#include "core/parameters.h"

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "core/kinds.h"

namespace umbral {
namespace {

TEST(Range, EndsAreOpenOrClosed) {
  EXPECT_TRUE(zero_to_one.contains(0));
  EXPECT_TRUE(zero_to_one.contains(1));
  EXPECT_FALSE(zero_to_one.contains(1 + 1e-12));
  EXPECT_FALSE(positive.contains(0));
  EXPECT_TRUE(positive.contains(1e-300));
  EXPECT_FALSE(positive.contains(HUGE_VAL));
  EXPECT_TRUE(non_negative.contains(0));
  EXPECT_FALSE(non_negative.contains(-1e-300));
  EXPECT_FALSE(any_number.contains(-HUGE_VAL));
  EXPECT_TRUE((Range{0, infinity}).contains(HUGE_VAL));
}

TEST(Range, NothingContainsNan) {
  for (const Range& range : {any_number, positive, non_negative, zero_to_one, Range{}})
    EXPECT_FALSE(range.contains(std::nan("")));
}

struct Ball {
  float radius = 1;
  Vec3 centre{0, 0, 0};
  static constexpr const char* kind = "ball";
  static constexpr auto parameters = std::tuple{required<&Ball::radius>("radius", "world units", positive),
                                                parameter<&Ball::centre>("centre", "world")};
};

TEST(Parameters, AreVisitedInOrderAndCanBeSet) {
  Ball ball;
  std::vector<std::string> names;
  for_each_parameter(ball, [&](const ParameterInfo& info, auto& member) {
    names.emplace_back(info.name);
    if constexpr (std::is_same_v<decltype(member), float&>) {
      EXPECT_TRUE(info.required);
      EXPECT_FALSE(info.range.contains(0));
      member = 3;
    } else {
      EXPECT_FALSE(info.required);
      member.y = 2;
    }
  });
  EXPECT_EQ(names, (std::vector<std::string>{"radius", "centre"}));
  EXPECT_EQ(ball.radius, 3);
  EXPECT_EQ(ball.centre.y, 2);
  const Ball& constant = ball;
  int count = 0;
  for_each_parameter(constant, [&](const ParameterInfo&, const auto&) { ++count; });
  EXPECT_EQ(count, 2);
}

struct Cube {
  float side = 2;
  static constexpr const char* kind = "cube";
};

using Solid = std::variant<Ball, Cube>;

TEST(Kinds, AreListedAndMadeByName) {
  EXPECT_EQ(kind_names<Solid>(), (std::vector<std::string>{"ball", "cube"}));
  const std::optional<Solid> cube = make_kind<Solid>("cube");
  ASSERT_TRUE(cube);
  EXPECT_EQ(std::get<Cube>(*cube).side, 2);
  EXPECT_FALSE(make_kind<Solid>("cone"));
  EXPECT_FALSE(make_kind<Solid>(""));
}

}  // namespace
}  // namespace umbral
