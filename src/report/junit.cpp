// Elements and attributes of the JUnit report.
#include "report/junit.h"

#include <algorithm>

#include <fmt/format.h>

#include "report/page.h"

namespace umbral {
namespace {

// In content and in quoted attributes, where a line's end would become a space.
std::string xml_text(const std::string& text) {
  std::string escaped;
  for (const char c : html_text(text))
    if (c == '\t' || c == '\n')
      escaped += fmt::format("&#{};", static_cast<int>(c));
    else if (static_cast<unsigned char>(c) < 0x20)
      escaped += "\uFFFD";
    else
      escaped += c;
  return escaped;
}

std::string element(const JunitCase& c) {
  std::string text = fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.6f}\">\n",
                                 xml_text(c.group), xml_text(c.name), c.seconds);
  const std::string message = xml_text(c.message);
  if (c.status == JunitStatus::failed)
    text += fmt::format("      <failure type=\"differs\" message=\"{0}\">{0}</failure>\n", message);
  if (c.status == JunitStatus::error)
    text += fmt::format("      <error type=\"undecided\" message=\"{0}\">{0}</error>\n", message);
  if (c.status == JunitStatus::passed) text += fmt::format("      <system-out>{}</system-out>\n", message);
  return text + "    </testcase>\n";
}

}  // namespace

std::string junit_xml(const JunitSuite& suite) {
  const auto count = [&](JunitStatus status) {
    return std::count_if(suite.cases.begin(), suite.cases.end(),
                         [&](const JunitCase& c) { return c.status == status; });
  };
  double seconds = 0;
  for (const JunitCase& c : suite.cases) seconds += c.seconds;
  const std::string counts =
      fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.6f}\"", suite.cases.size(),
                  count(JunitStatus::failed), count(JunitStatus::error), seconds);
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {0}>\n"
      "  <testsuite name=\"{1}\" {0} skipped=\"0\">\n    <properties>\n",
      counts, xml_text(suite.name));
  for (const auto& [name, value] : suite.properties)
    text += fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", xml_text(name), xml_text(value));
  text += "    </properties>\n";
  for (const JunitCase& c : suite.cases) text += element(c);
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace umbral
