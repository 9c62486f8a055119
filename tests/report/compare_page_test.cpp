// The page of a comparison in a browser: what its pictures show, and that its controls move them.
#include "report/compare_page.h"

#include <gtest/gtest.h>

#include "support/chromium.h"
#include "support/paths.h"

namespace umbral {
namespace {

class ComparePage : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::chromium()) GTEST_SKIP() << test::no_chromium;
    for (std::size_t i = 0; i < a_.pixels(); ++i)
      for (int c = 0; c < 3; ++c) {
        a_.channels[c][i] = 0.25f;
        b_.channels[c][i] = 0.5f;
      }
    a_.channels[0][0] = 1e6f;  // beyond 16 bits
    b_.channels[2][5] = 0.1f;
    for (float& z : z_.values) z = 2.5f;
    flip_.values[3] = 1;
  }

  nlohmann::json run(const std::string& script, bool with_errors = true) const {
    const Plane none(0, 0);
    CompareView view{"a <1>.exr",
                     "b.exr",
                     "differ",
                     "because",
                     "+100 %",
                     "bad",
                     "the text",
                     "{\"x\": 1}",
                     a_,
                     b_,
                     with_errors ? z_ : none,
                     flip_,
                     {},
                     {}};
    if (with_errors) view.p = {0.01, 0.02, 0.5, 0.99};
    view.labels = std::vector<CompareView::Label>(1);
    view.labels[0].region = {"A1", 0, 0, 4, 4};
    view.labels[0].text = "+100 %";
    const std::string path = (directory_.path() / "page.html").string();
    write_page(path, compare_page(view));
    return test::run_in_page(path, helpers + script);
  }

  // input(id, value): as a user sets a control. pixel(id, x, y): what a canvas shows at a share of its size.
  static constexpr const char* helpers = R"(
    const get = id => document.getElementById(id);
    const input = (id, value) => { get(id).value = value; get(id).dispatchEvent(new Event('input')); };
    const pixel = (id, x, y) => {
      const canvas = get(id);
      return [...canvas.getContext('2d').getImageData(
          Math.floor(x * canvas.width), Math.floor(y * canvas.height), 1, 1).data];
    };
    const pointer = (id, type, x, y, more = {}) => {
      const box = get(id).getBoundingClientRect();
      const options = {clientX: box.left + x * box.width, clientY: box.top + y * box.height, pointerId: 1,
                       bubbles: true, cancelable: true, ...more};
      get(id).dispatchEvent(type === 'wheel' ? new WheelEvent(type, options) : new PointerEvent(type, options));
    };)";

  Planes a_{8, 8}, b_{8, 8};
  Plane z_{8, 8}, flip_{8, 8};
  test::TemporaryDirectory directory_;
};

TEST_F(ComparePage, PixelsComeThroughAndNothingIsAskedFor) {
  const nlohmann::json seen = run(R"(
    return {failures, requests, a: comparison.planes.a[0][1], cut: comparison.planes.a[0][0],
            b: comparison.planes.b[2][5], z: comparison.planes.z[7], flip: comparison.planes.flip[3],
            title: document.title, text: get('text').textContent, json: get('json').textContent,
            bars: document.querySelectorAll('#p-values rect').length};)");
  EXPECT_EQ(seen["failures"], nlohmann::json::array());
  EXPECT_EQ(seen["requests"], nlohmann::json::array());
  EXPECT_EQ(seen["a"], 0.25);
  EXPECT_EQ(seen["cut"], 65504);
  EXPECT_NEAR(seen["b"], 0.1, 1e-4);
  EXPECT_EQ(seen["z"], 2.5);
  EXPECT_EQ(seen["flip"], 1);
  EXPECT_EQ(seen["title"], "a <1>.exr – b.exr");
  EXPECT_EQ(seen["text"], "the text");
  EXPECT_EQ(nlohmann::json::parse(seen["json"].get<std::string>())["x"], 1);
  EXPECT_EQ(seen["bars"], 20);
}

// Linear 0.25 and 0.5 are the sRGB codes 137 and 188.
TEST_F(ComparePage, SplitSliderMovesTheEdge) {
  const nlohmann::json seen = run(R"(
    const middle = [pixel('split', 0.4, 0.6)[0], pixel('split', 0.6, 0.6)[0]];
    input('divider', 0.9);
    const right = pixel('split', 0.6, 0.6)[0];
    input('divider', 0.1);
    return {middle, right, left: pixel('split', 0.4, 0.6)[0]};)");
  EXPECT_EQ(seen["middle"], (nlohmann::json{137, 188}));
  EXPECT_EQ(seen["right"], 137);
  EXPECT_EQ(seen["left"], 188);
}

TEST_F(ComparePage, ExposureIsOfLinearValues) {
  const nlohmann::json seen = run(R"(
    const before = pixel('a', 0.6, 0.6)[0];
    input('exposure', 1);
    return {before, after: pixel('a', 0.6, 0.6)[0], told: get('exposure-value').textContent};)");
  EXPECT_EQ(seen["before"], 137);
  EXPECT_EQ(seen["after"], 188);
  EXPECT_EQ(seen["told"], "+1.0 EV");
}

// Zooming about a point of one picture moves all of them and keeps that point.
TEST_F(ComparePage, ZoomAndPanAreLinked) {
  const nlohmann::json seen = run(R"(
    pointer('b', 'wheel', 0.25, 0.25, {deltaY: -400 * Math.log(8)});
    const zoomed = {...comparison.view};
    const black = pixel('flip', 0.9, 0.5)[0];
    // Pixel (3, 0) of FLIP is white; drag it to the middle of another picture.
    comparison.fit();
    pointer('a', 'pointerdown', 3.5 / 8, 0.5 / 8);
    pointer('a', 'pointermove', 0.5, 0.5);
    pointer('a', 'pointerup', 0.5, 0.5);
    const panned = {...comparison.view};
    const white = pixel('flip', 0.5, 0.5)[0];
    get('fit').click();
    return {zoomed, panned, black, white, fitted: comparison.view};)");
  EXPECT_NEAR(seen["zoomed"]["zoom"], 8, 1e-6);
  EXPECT_NEAR(seen["zoomed"]["x"], 2 + 2.0 / 8, 0.05);
  EXPECT_EQ(seen["black"], 0);
  EXPECT_NEAR(seen["panned"]["x"], 3.5, 0.05);
  EXPECT_NEAR(seen["panned"]["y"], 0.5, 0.05);
  EXPECT_EQ(seen["white"], 255);
  EXPECT_EQ(seen["fitted"]["zoom"], 1);
}

// B is brighter and so red in the difference; z = 2.5 is half-way to full red.
TEST_F(ComparePage, DifferenceAndZAreSigned) {
  const nlohmann::json seen =
      run("return {difference: pixel('difference', 0.9, 0.9), z: pixel('z', 0.5, 0.5)};");
  EXPECT_GT(seen["z"][0], seen["z"][2]);
  EXPECT_GE(seen["difference"][0], seen["difference"][2]);
}

TEST_F(ComparePage, RegionsAreDrawnWhenAsked) {
  const nlohmann::json seen = run(R"(
    const sum = () => {
      const canvas = get('split'), data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
      let sum = 0;
      for (let i = 0; i < data.length; i += 4) sum += data[i];
      return sum;
    };
    const before = sum();
    get('show-labels').checked = true;
    get('show-labels').dispatchEvent(new Event('input'));
    return {before, after: sum()};)");
  EXPECT_NE(seen["before"], seen["after"]);
}

TEST_F(ComparePage, WithoutErrorsThereIsNoZAndNoHistogram) {
  const nlohmann::json seen =
      run("return {failures, z: !!get('z'), histogram: !!get('p-values'), shown: pixel('b', 0.5, 0.9)[0]};",
          false);
  EXPECT_EQ(seen["failures"], nlohmann::json::array());
  EXPECT_FALSE(seen["z"].get<bool>());
  EXPECT_FALSE(seen["histogram"].get<bool>());
  EXPECT_EQ(seen["shown"], 188);
}

}  // namespace
}  // namespace umbral
