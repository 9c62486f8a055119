// The one line that a running render shows.
#include "app/progress_bar.h"

#include <gtest/gtest.h>

namespace umbral {
namespace {

TEST(ProgressText, ShowsShareTimesAndErrors) {
  EXPECT_EQ(progress_text({0.42, 12.3, 0.018}, 0.01, true),
            "[########            ]  42 %  12.3 s, 17.0 s left  error 1.8 % → 1 %");
}

TEST(ProgressText, WithoutTerminalThereIsNoBar) {
  EXPECT_EQ(progress_text({0.5, 120, infinity}, 0, false), " 50 %  2 min 00 s, 2 min 00 s left");
}

TEST(ProgressText, GuessesNoTimeLeftFromNothing) {
  EXPECT_EQ(progress_text({0.001, 0.1, infinity}, 0, false), "  0 %  0.1 s");
}

}  // namespace
}  // namespace umbral
