// The texts of located errors, to the letter.
#include "core/error.h"

#include <gtest/gtest.h>

namespace umbral {
namespace {

TEST(Diagnostic, TextNamesThePlaceAsFarAsItIsKnown) {
  EXPECT_EQ((Diagnostic{Severity::error, {"a.toml", 12, 9}, "no"}).text(), "a.toml:12:9: error: no");
  EXPECT_EQ((Diagnostic{Severity::warning, {"a.toml", 12}, "no"}).text(), "a.toml:12: warning: no");
  EXPECT_EQ((Diagnostic{Severity::error, {"a.toml"}, "no"}).text(), "a.toml: error: no");
  EXPECT_EQ((Diagnostic{Severity::error, {"a.toml", 0, 9}, "no"}).text(), "a.toml: error: no");
  EXPECT_EQ((Diagnostic{Severity::error, {}, "no"}).text(), "error: no");
  EXPECT_EQ((Diagnostic{Severity::error, {"a", 1, 2}, "no", "x\n^"}).text(), "a:1:2: error: no\nx\n^");
}

TEST(SceneError, TellsOfAllDiagnostics) {
  const SceneError one({"a.obj", 3}, "bad");
  EXPECT_STREQ(one.what(), "a.obj:3: error: bad");
  ASSERT_EQ(one.diagnostics().size(), 1u);
  EXPECT_EQ(one.diagnostics()[0].where.line, 3);
  const SceneError two({{Severity::error, {"a", 1}, "b"}, {Severity::warning, {"c", 2, 3}, "d"}});
  EXPECT_STREQ(two.what(), "a:1: error: b\nc:2:3: warning: d");
  EXPECT_EQ(two.diagnostics().size(), 2u);
}

TEST(Excerpt, PutsTheCaretUnderTheColumn) {
  const std::string text = "first\nkey = 3\r\n\tindented\nlast";
  EXPECT_EQ(excerpt_with_caret(text, 2, 7), "    2 | key = 3\n      |       ^");
  EXPECT_EQ(excerpt_with_caret(text, 1, 1), "    1 | first\n      | ^");
  EXPECT_EQ(excerpt_with_caret(text, 3, 2), "    3 | \tindented\n      | \t^") << "tabs stay tabs";
  EXPECT_EQ(excerpt_with_caret(text, 4, 99), "    4 | last\n      |     ^") << "not beyond the line";
  EXPECT_EQ(excerpt_with_caret(text, 5, 1), "");
  EXPECT_EQ(excerpt_with_caret("", 1, 1), "");
}

}  // namespace
}  // namespace umbral
