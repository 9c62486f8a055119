// What a test of a hard case asserts and what it measured, for the table in docs/stability.md.
#pragma once

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace umbral::test {

/// A row of that table, which tools/make_stability_table collects from the properties of tests.
struct StabilityRow {
  std::string section;  // of docs/stability.md
  std::string guards;   // what goes wrong where this is not so
  std::string asserted, measured;
  std::string reported = {};  // by whom, of other renderers: tracker and number
};

/// Says nothing where the test has failed: the page tells of nothing that is not so.
inline void record(const StabilityRow& row) {
  if (testing::Test::HasFailure()) return;
  testing::Test::RecordProperty("stability: " + row.guards, row.section + " | " + row.asserted + " | " +
                                                                row.measured + " | " + row.reported);
}

}  // namespace umbral::test
