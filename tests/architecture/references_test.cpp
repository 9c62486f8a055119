// Every paper that code, tests and documents cite is in docs/references.md.
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "support/contents.h"
#include "support/paths.h"

namespace umbral {
namespace {

// "[Duff et al. 2017]", "[Welch 1947; Veach 1997, §9.2]" → "Duff et al. 2017", "Veach 1997", "Welch 1947".
std::set<std::string> citations(const std::string& text) {
  static const std::regex pattern(R"((?:\[|; )([A-Z][A-Za-z' -]+(?: et al\.)? [12][0-9]{3})(?=[,;\]]))");
  std::set<std::string> found;
  for (auto match = std::sregex_iterator(text.begin(), text.end(), pattern); match != std::sregex_iterator();
       ++match)
    found.insert((*match)[1]);
  return found;
}

TEST(References, ACitationIsRecognised) {
  EXPECT_EQ(citations("x [Duff et al. 2017] y[3] [Welch 1947; Veach 1997, §9.2] [Blinn]"),
            (std::set<std::string>{"Duff et al. 2017", "Veach 1997", "Welch 1947"}));
}

TEST(References, EveryCitationResolves) {
  const std::string references = test::contents(test::source_path("docs/references.md"));
  std::size_t count = 0;
  for (const char* room : {"src", "tests", "docs"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::source_path(room))) {
      const std::set<std::string> file_types{".h", ".cpp", ".md"};
      if (!file_types.contains(entry.path().extension().string())) continue;
      for (const std::string& citation : citations(test::contents(entry.path()))) {
        ++count;
        EXPECT_NE(references.find("**" + citation + "**"), std::string::npos)
            << entry.path() << " cites " << citation;
      }
    }
  EXPECT_GT(count, 20u);
}

}  // namespace
}  // namespace umbral
