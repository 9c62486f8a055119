// Descriptions of parameters as people read them.
#include "app/parameter_text.h"

#include <gtest/gtest.h>

#include "integrators/registry.h"
#include "scene/settings.h"

namespace umbral {
namespace {

TEST(ParameterText, RangesReadAsInequalities) {
  EXPECT_EQ(range_text(any_number), "");
  EXPECT_EQ(range_text(zero_to_one), "0 … 1");
  EXPECT_EQ(range_text(positive), "> 0");
  EXPECT_EQ(range_text(non_negative), "≥ 0");
  EXPECT_EQ(range_text(Range{0, 180, true, true}), "> 0, < 180");
  EXPECT_EQ(range_text(Range{0.1f, 1 << 20}), "0.1 … 1048576");
}

TEST(ParameterText, TellsTypeAndDefaultOfEachParameter) {
  SamplingSettings sampling;
  ParameterTexts texts;
  for_each_parameter(sampling, texts);
  ASSERT_EQ(texts.texts().size(), 4u);
  EXPECT_EQ(texts.texts()[2].type, "one of independent, sobol");
  EXPECT_EQ(texts.texts()[2].value, "\"sobol\"");
}

TEST(ParameterText, EveryIntegratorDescribesItself) {
  for (const IntegratorEntry& entry : integrators()) {
    ParameterTexts texts;
    entry.make()->describe(texts);
    EXPECT_EQ(call_text(entry.kind, texts.texts()).rfind(entry.kind + "(", 0), 0u);
    for (const ParameterText& text : texts.texts()) EXPECT_GT(std::string(text.info.doc).size(), 5u);
  }
}

}  // namespace
}  // namespace umbral
