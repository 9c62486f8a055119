// The one line that shows how a render or its loading goes.
#include "app/progress_bar.h"
#include "app/loading_progress.h"

#include <thread>

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

TEST(ProgressLine, WithoutTerminalSaysNothingOfWhatIsShortAndEverLess) {
  ProgressLine line(0);
  if (line.is_terminal()) GTEST_SKIP() << "standard error is a terminal";
  EXPECT_FALSE(line.is_due(1.9));
  EXPECT_TRUE(line.is_due(2));
  EXPECT_FALSE(line.is_due(7.1));
  EXPECT_TRUE(line.is_due(7.3));
  EXPECT_FALSE(line.is_due(12.9));
  EXPECT_TRUE(line.is_due(13.1));
}

TEST(LoadingProgress, TellsThePhaseOfWhatTakesLongUnlessItIsToBeQuiet) {
  testing::internal::CaptureStderr();
  {
    const LoadingProgress quiet("reading other.toml", true);
    LoadingProgress progress("reading scene.toml", false);
    progress.decoded(12, 40);
    std::this_thread::sleep_for(std::chrono::milliseconds(2500));
  }
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(told.starts_with("textures 12/40  2.")) << told;
  EXPECT_EQ(told.find('\n') + 1, told.size()) << told;
}

}  // namespace
}  // namespace umbral
