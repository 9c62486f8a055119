// JUnit reports are XML of the shape that readers of them expect, whatever the texts hold.
#include "report/junit.h"

#include <gtest/gtest.h>
#include <pugixml.hpp>

namespace umbral {
namespace {

// The root's element; the parser folds white space in attributes as XML says.
pugi::xml_document parsed(const std::string& xml) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(
      xml.data(), xml.size(), pugi::parse_default | pugi::parse_ws_pcdata_single, pugi::encoding_utf8);
  EXPECT_TRUE(result) << result.description();
  return document;
}

std::vector<pugi::xml_node> elements(const pugi::xml_node& parent) {
  std::vector<pugi::xml_node> found;
  for (const pugi::xml_node& child : parent.children())
    if (child.type() == pugi::node_element) found.push_back(child);
  return found;
}

std::string attribute(const pugi::xml_node& node, const char* name) { return node.attribute(name).value(); }

TEST(Junit, HasTheShapeThatReadersExpect) {
  const pugi::xml_document document =
      parsed(junit_xml({"umbral converge",
                        {{"scene", "a.toml"}},
                        {{"path", "slope", JunitStatus::passed, "fine", 1.5},
                         {"path", "equal", JunitStatus::failed, "no", 0.25},
                         {"path", "faster", JunitStatus::error, "unknown", 0}}}));
  const pugi::xml_node root = document.document_element();
  EXPECT_STREQ(root.name(), "testsuites");
  ASSERT_EQ(elements(root).size(), 1u);
  const pugi::xml_node suite = elements(root).front();
  EXPECT_STREQ(suite.name(), "testsuite");
  for (const pugi::xml_node& node : {root, suite}) {
    EXPECT_EQ(attribute(node, "tests"), "3");
    EXPECT_EQ(attribute(node, "failures"), "1");
    EXPECT_EQ(attribute(node, "errors"), "1");
    EXPECT_EQ(attribute(node, "time"), "1.750000");
  }
  EXPECT_EQ(attribute(suite, "name"), "umbral converge");
  const std::vector<pugi::xml_node> children = elements(suite);
  ASSERT_EQ(children.size(), 4u);
  const pugi::xml_node property = children[0].first_child();
  EXPECT_EQ(attribute(property, "name") + "=" + attribute(property, "value"), "scene=a.toml");
  const std::vector<std::string> inner = {"system-out", "failure", "error"};
  for (std::size_t i = 0; i < 3; ++i) {
    const pugi::xml_node testcase = children[i + 1];
    EXPECT_STREQ(testcase.name(), "testcase");
    EXPECT_EQ(attribute(testcase, "classname"), "path");
    ASSERT_EQ(elements(testcase).size(), 1u);
    EXPECT_EQ(elements(testcase).front().name(), inner[i]);
  }
  EXPECT_EQ(attribute(children[2].child("failure"), "message"), "no");
}

TEST(Junit, TextsSurvive) {
  const std::string text = "<a href=\"x\">'&' ]]> − ±\n\tnext</a>";
  const pugi::xml_document document =
      parsed(junit_xml({text, {{text, text}}, {{text, text, JunitStatus::failed, text, 0}}}));
  const pugi::xml_node suite = document.document_element().child("testsuite");
  EXPECT_EQ(attribute(suite, "name"), text);
  EXPECT_EQ(attribute(suite.child("properties").child("property"), "value"), text);
  const pugi::xml_node testcase = suite.child("testcase");
  EXPECT_EQ(attribute(testcase, "name"), text);
  EXPECT_EQ(attribute(testcase.child("failure"), "message"), text);
  EXPECT_EQ(testcase.child("failure").text().get(), text);
}

TEST(Junit, WhatXmlCannotHoldIsReplaced) {
  const pugi::xml_document document = parsed(junit_xml({std::string("a\x01\x1b") + "b", {}, {}}));
  EXPECT_EQ(attribute(document.document_element().child("testsuite"), "name"), "a\uFFFD\uFFFDb");
}

}  // namespace
}  // namespace umbral
