// JUnit XML, the form in which continuous integration takes the results of tests.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace umbral {

enum class JunitStatus {
  passed,
  failed,  // what was asserted is not so
  error    // it could not be decided
};

struct JunitCase {
  std::string group, name;  // shown as "group.name"
  JunitStatus status = JunitStatus::passed;
  std::string message;  // one sentence: what was found
  double seconds = 0;
};

struct JunitSuite {
  std::string name;
  std::vector<std::pair<std::string, std::string>> properties;
  std::vector<JunitCase> cases;
};

/// One <testsuite> in <testsuites>, as Jenkins, GitLab, GitHub's reporters and pytest agree on it. Characters that XML
/// cannot hold become U+FFFD.
std::string junit_xml(const JunitSuite& suite);

}  // namespace umbral
