// JUnit reports are XML of the shape that readers of them expect, whatever the texts hold.
#include "report/junit.h"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/command.h"
#include "support/paths.h"

namespace umbral {
namespace {

// Python's parser turns the file into JSON: [tag, attributes, text, children].
nlohmann::json parsed(const std::string& xml) {
  const test::TemporaryDirectory directory;
  const auto path = directory.path() / "report.xml";
  std::ofstream(path, std::ios::binary) << xml;
  const std::string command =
      "python3 -c 'import json, sys, xml.etree.ElementTree as E\n"
      "def f(e): return [e.tag, e.attrib, e.text, [f(c) for c in e]]\n"
      "print(json.dumps(f(E.parse(sys.argv[1]).getroot())))' '" +
      path.string() + "'";
  return nlohmann::json::parse(test::run_command(command).text);
}

class Junit : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("python3 -c 'import xml.etree' 2>/dev/null") != 0)
      GTEST_SKIP() << "there is no python3 here to parse XML by";
  }
};

TEST_F(Junit, HasTheShapeThatReadersExpect) {
  const nlohmann::json root = parsed(junit_xml({"umbral converge",
                                                {{"scene", "a.toml"}},
                                                {{"path", "slope", JunitStatus::passed, "fine", 1.5},
                                                 {"path", "equal", JunitStatus::failed, "no", 0.25},
                                                 {"path", "faster", JunitStatus::error, "unknown", 0}}}));
  EXPECT_EQ(root[0], "testsuites");
  ASSERT_EQ(root[3].size(), 1u);
  const nlohmann::json& suite = root[3][0];
  EXPECT_EQ(suite[0], "testsuite");
  for (const nlohmann::json* attributes : {&root[1], &suite[1]}) {
    EXPECT_EQ((*attributes)["tests"], "3");
    EXPECT_EQ((*attributes)["failures"], "1");
    EXPECT_EQ((*attributes)["errors"], "1");
    EXPECT_EQ((*attributes)["time"], "1.750000");
  }
  EXPECT_EQ(suite[1]["name"], "umbral converge");
  ASSERT_EQ(suite[3].size(), 4u);
  EXPECT_EQ(suite[3][0][3][0][1], (nlohmann::json{{"name", "scene"}, {"value", "a.toml"}}));
  const std::vector<std::string> inner = {"system-out", "failure", "error"};
  for (std::size_t i = 0; i < 3; ++i) {
    const nlohmann::json& testcase = suite[3][i + 1];
    EXPECT_EQ(testcase[0], "testcase");
    EXPECT_EQ(testcase[1]["classname"], "path");
    ASSERT_EQ(testcase[3].size(), 1u);
    EXPECT_EQ(testcase[3][0][0], inner[i]);
  }
  EXPECT_EQ(suite[3][2][3][0][1]["message"], "no");
}

TEST_F(Junit, TextsSurvive) {
  const std::string text = "<a href=\"x\">'&' ]]> − ±\n\tnext</a>";
  const nlohmann::json root =
      parsed(junit_xml({text, {{text, text}}, {{text, text, JunitStatus::failed, text, 0}}}));
  const nlohmann::json& suite = root[3][0];
  EXPECT_EQ(suite[1]["name"], text);
  EXPECT_EQ(suite[3][0][3][0][1]["value"], text);
  EXPECT_EQ(suite[3][1][1]["name"], text);
  EXPECT_EQ(suite[3][1][3][0][1]["message"], text);
  EXPECT_EQ(suite[3][1][3][0][2], text);
}

TEST_F(Junit, WhatXmlCannotHoldIsReplaced) {
  const nlohmann::json root = parsed(junit_xml({std::string("a\x01\x1b") + "b", {}, {}}));
  EXPECT_EQ(root[3][0][1]["name"], "a\uFFFD\uFFFDb");
}

}  // namespace
}  // namespace umbral
