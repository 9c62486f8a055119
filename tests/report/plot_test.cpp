// Plots show every point where it belongs, whatever the numbers are.
#include "report/plot.h"

#include <fstream>

#include <gtest/gtest.h>

#include "report/assets.h"
#include "report/log_axis.h"
#include "report/page.h"
#include "support/chromium.h"
#include "support/paths.h"

namespace umbral {
namespace {

// Two curves, the second ten times below and with error bars.
Plot example() {
  Plot plot{
      "a < b", {"samples", PlotAxis::Ticks::powers_of_two}, {"error", {}, true}, {}, {{-0.5, "n^-1/2"}}};
  plot.series = {{"first & \"one\"", {}}, {"second", {}}};
  for (double n = 4; n <= 1024; n *= 2) {
    const double error = 1 / std::sqrt(n);
    plot.series[0].points.push_back({n, error, {n, n}, {error, error}, "n"});
    plot.series[1].points.push_back({n, error / 10, {n, n}, {0.09 * error, 0.12 * error}, "m"});
  }
  return plot;
}

TEST(LogAxis, PlacesByLogarithms) {
  const PlotAxis axis{"x"};
  const LogAxis log(axis, 1, 100, 0, 100);
  EXPECT_NEAR(log.place(10), 50, 1e-9);
  EXPECT_GT(log.place(1), 0);
  EXPECT_LT(log.place(100), 100);
  EXPECT_NEAR(log.place(5) - log.place(1), log.place(50) - log.place(10), 1e-9);
}

TEST(LogAxis, HasSomeNumbersButNotTooMany) {
  for (const auto kind : {PlotAxis::Ticks::decades, PlotAxis::Ticks::powers_of_two})
    for (const double low : {1e-7, 0.3, 4.0, 1e5})
      for (const double span : {1.0, 1.3, 3.0, 100.0, 1e4, 1e7}) {
        const PlotAxis axis{"x", kind};
        int numbers = 0;
        for (const LogAxis::Tick& tick : LogAxis(axis, low, low * span, 0, 1).ticks())
          numbers += !tick.text.empty();
        EXPECT_LE(numbers, 12) << low << " " << span;
        if (span >= 3) {
          EXPECT_GE(numbers, 1) << low << " " << span;
        }
      }
}

TEST(Plot, AnEmptySeriesAndASinglePointAreDrawn) {
  Plot plot{"title", {"x"}, {"y"}, {{"empty", {}}, {"one", {{3, 4, {3, 3}, {4, 4}, ""}}}}, {}};
  const std::string text = svg(plot);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
}

class PlotInBrowser : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::chromium()) GTEST_SKIP() << test::no_chromium;
  }
  nlohmann::json run(const Plot& plot, const std::string& script) const {
    const std::string path = (directory_.path() / "page.html").string();
    Page page{"plot", svg(plot) + svg(plot)};
    page.styles = {assets::plot_css};
    page.scripts = {assets::plot_js};
    write_page(path, page);
    return test::run_in_page(path, script);
  }
  test::TemporaryDirectory directory_;
};

TEST_F(PlotInBrowser, PointsLieWhereTheirNumbersSay) {
  const nlohmann::json seen = run(example(), R"(
    const plot = document.querySelector('.plot');
    const middle = e => { const b = e.getBBox(); return [b.x + b.width / 2, b.y + b.height / 2]; };
    const box = plot.viewBox.baseVal;
    const texts = [...plot.querySelectorAll('text')].map(e => e.getBoundingClientRect());
    const frame = plot.getBoundingClientRect();
    return {
      circles: [...plot.querySelectorAll('.series circle')].map(middle),
      squares: [...plot.querySelectorAll('.series rect')].map(middle),
      bars: plot.querySelectorAll('.bar').length,
      outside: texts.filter(t => t.left < frame.left - 1 || t.right > frame.right + 1 ||
                                 t.top < frame.top - 1 || t.bottom > frame.bottom + 1).length,
      height: box.height, title: plot.querySelector('.title').textContent,
      name: plot.querySelector('.key text').textContent, failures, requests};)");
  const auto &circles = seen["circles"], &squares = seen["squares"];
  ASSERT_EQ(circles.size(), 9u);
  ASSERT_EQ(squares.size(), 9u);
  for (std::size_t i = 1; i < 9; ++i) {
    const auto step = [&](int axis) {
      return circles[i][axis].get<double>() - circles[i - 1][axis].get<double>();
    };
    EXPECT_NEAR(step(0), circles[1][0].get<double>() - circles[0][0].get<double>(), 0.2);
    EXPECT_NEAR(step(1), circles[1][1].get<double>() - circles[0][1].get<double>(), 0.2);
    EXPECT_GT(step(0), 0);
    EXPECT_GT(step(1), 0);  // y down
    EXPECT_NEAR(squares[i][0].get<double>(), circles[i][0].get<double>(), 0.2);
    EXPECT_GT(squares[i][1].get<double>(), circles[i][1].get<double>());
  }
  EXPECT_EQ(seen["bars"], 9);
  EXPECT_EQ(seen["outside"], 0);
  EXPECT_EQ(seen["title"], "a < b");
  EXPECT_EQ(seen["name"], "first & \"one\"");
  EXPECT_EQ(seen["failures"].size() + seen["requests"].size(), 0u) << seen;
}

TEST_F(PlotInBrowser, TheLegendHidesACurveInAllPlots) {
  const nlohmann::json seen = run(example(), R"(
    const visible = () => [...document.querySelectorAll('.series')]
                              .map(e => getComputedStyle(e).display !== 'none');
    const key = document.querySelectorAll('.key')[1];
    const before = visible();
    key.dispatchEvent(new MouseEvent('click'));
    const hidden = visible(), pressed = key.getAttribute('aria-pressed');
    key.dispatchEvent(new KeyboardEvent('keydown', {key: 'Enter'}));
    return {before, hidden, pressed, after: visible()};)");
  EXPECT_EQ(seen["before"], (nlohmann::json{true, true, true, true}));
  EXPECT_EQ(seen["hidden"], (nlohmann::json{true, false, true, false}));
  EXPECT_EQ(seen["pressed"], "false");
  EXPECT_EQ(seen["after"], seen["before"]);
}

}  // namespace
}  // namespace umbral
