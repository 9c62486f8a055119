// Pages hold what they are given, whatever it is, and ask for nothing else.
#include "report/page.h"

#include <fstream>

#include <gtest/gtest.h>

#include "core/error.h"
#include "report/assets.h"
#include "support/chromium.h"
#include "support/paths.h"

namespace umbral {
namespace {

TEST(Page, TextIsShownAndNotObeyed) {
  EXPECT_EQ(html_text("<b class=\"x\">'&'</b>"), "&lt;b class=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/b&gt;");
}

TEST(Page, AFileIsEmbeddedToTheLastByte) {
  std::ifstream stream(test::source_path("src/report/assets/page.css"), std::ios::binary);
  const std::string file(std::istreambuf_iterator<char>(stream), {});
  EXPECT_EQ(file, assets::page_css);
}

TEST(Page, AnUnwritablePathIsAnOutputError) {
  EXPECT_THROW(write_page("/nonexistent/page.html", {"title", "body"}), OutputError);
}

class PageInBrowser : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::chromium()) GTEST_SKIP() << test::no_chromium;
  }
  nlohmann::json run(const Page& page, const std::string& script) const {
    const std::string path = (directory_.path() / "page.html").string();
    write_page(path, page);
    return test::run_in_page(path, script);
  }
  test::TemporaryDirectory directory_;
};

TEST_F(PageInBrowser, DataReachScriptsUnchangedWhateverTheyHold) {
  const nlohmann::json data = {{"name", "</script><script>boom()</script> <!-- \" ' & ü"}, {"x", 0.1}};
  Page page{"a < b & \"c\"", "<p id=\"text\">" + html_text("1 < 2 && '3'") + "</p>", data.dump()};
  page.scripts = {"const data = JSON.parse(document.getElementById('data').textContent);\n",
                  "const twice = 2 * data.x;\n"};
  const nlohmann::json seen = run(page,
                                  "return {data, twice, title: document.title, failures, requests,"
                                  " text: document.getElementById('text').textContent};");
  EXPECT_EQ(seen["data"], data);
  EXPECT_EQ(seen["twice"], 0.2);
  EXPECT_EQ(seen["title"], page.title);
  EXPECT_EQ(seen["text"], "1 < 2 && '3'");
  EXPECT_EQ(seen["failures"], nlohmann::json::array());
  EXPECT_EQ(seen["requests"], nlohmann::json::array());
}

// That requests of every kind are stopped, and that run_in_page() would have told.
TEST_F(PageInBrowser, NoRequestLeaves) {
  const Page page{"requests",
                  "<img src=\"https://example.org/a.png\"><link rel=\"stylesheet\" "
                  "href=\"https://example.org/b.css\"><script src=\"https://example.org/c.js\"></script>"
                  "<img id=\"own\" src=\"data:image/gif;base64,"
                  "R0lGODlhAQABAIAAAAAAAP///yH5BAEAAAAALAAAAAABAAEAAAIBRAA7\">"};
  const nlohmann::json seen = run(page, R"(
    const refused = await fetch('https://example.org/d').then(() => false, () => true);
    await next_frame();
    return {refused, requests, width: document.getElementById('own').naturalWidth};)");
  EXPECT_TRUE(seen["refused"].get<bool>());
  EXPECT_EQ(seen["width"], 1);
  for (const char* end : {"a.png", "b.css", "c.js", "d"}) {
    bool found = false;
    for (const std::string address : seen["requests"]) found |= address.ends_with(end);
    EXPECT_TRUE(found) << end << " in " << seen["requests"];
  }
}

}  // namespace
}  // namespace umbral
