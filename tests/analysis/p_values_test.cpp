// Holm's procedure by hand.
#include "analysis/p_values.h"

#include <gtest/gtest.h>

namespace umbral {
namespace {

TEST(Holm, StepsDown) {
  EXPECT_EQ(holm({0.04, 0.012, 0.3, 0.001}, 0.05), (std::vector<std::size_t>{3, 1}));
  EXPECT_EQ(holm({0.02, 0.02}, 0.05), (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(holm({0.03, 0.03}, 0.05).empty());
}

}  // namespace
}  // namespace umbral
