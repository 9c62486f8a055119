// Which name was meant.
#include "core/names.h"

#include <gtest/gtest.h>

namespace umbral {
namespace {

const std::vector<std::string> names{"roughness", "radius", "albedo", "eta", "kd", "ks"};

TEST(NearestName, ForgivesTypingErrors) {
  EXPECT_EQ(nearest_name("rougness", names), "roughness");    // a letter less
  EXPECT_EQ(nearest_name("roughnesss", names), "roughness");  // one more
  EXPECT_EQ(nearest_name("eat", names), "eta");               // two swapped: one edit, not two
  EXPECT_EQ(nearest_name("alpedo", names), "albedo");         // another letter
  EXPECT_EQ(nearest_name("albedo", names), "albedo");
  EXPECT_EQ(nearest_name("kx", names), "kd") << "the first of equals";
}

TEST(NearestName, DoesNotGuessWildly) {
  EXPECT_EQ(nearest_name("transmission", names), "");
  EXPECT_EQ(nearest_name("xyz", names), "");
  EXPECT_EQ(nearest_name("", names), "");
  EXPECT_EQ(nearest_name("radius", {}), "");
}

TEST(NearestName, TakesTheNearest) {
  EXPECT_EQ(nearest_name("aldebo", {"alpaca", "albedos", "albedo"}), "albedo");
}

TEST(Suggestion, AsksOrLists) {
  EXPECT_EQ(suggestion("rougness", names), "; did you mean 'roughness'?");
  EXPECT_EQ(suggestion("transmission", {"kd"}), "; known is 'kd'");
  EXPECT_EQ(suggestion("transmission", {"kd", "ks"}), "; known are 'kd' and 'ks'");
  EXPECT_EQ(suggestion("transmission", {"kd", "ks", "p"}), "; known are 'kd', 'ks' and 'p'");
  EXPECT_EQ(suggestion("transmission", {}), "");
}

}  // namespace
}  // namespace umbral
