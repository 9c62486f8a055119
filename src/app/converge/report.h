// A convergence as a page, as plots, as JSON and as tests of JUnit.
#pragma once

#include <string>

#include "app/converge/checks.h"
#include "report/junit.h"
#include "report/page.h"
#include "report/plot.h"

namespace umbral {

Plot samples_plot(const ConvergeReport& report);
Plot seconds_plot(const ConvergeReport& report);

/// Both plots, a table, all sentences, and json_text() as its data.
Page page_of(const ConvergeReport& report);

std::string json_text(const ConvergeReport& report);

/// A test an expectation; without any, one a variant, which tells its slope.
JunitSuite suite_of(const ConvergeReport& report);

}  // namespace umbral
