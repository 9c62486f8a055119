// Plot: curves with error bars on logarithmic axes, as SVG.
#pragma once

#include <string>
#include <vector>

#include "analysis/log_estimate.h"

namespace umbral {

/// A measured point; the intervals hold it and are drawn as bars where they are wider than nothing.
struct PlotPoint {
  double x = 0, y = 0;  // > 0
  Interval x_interval, y_interval;
  std::string text;  // said when pointed at
};

struct PlotSeries {
  std::string name;
  std::vector<PlotPoint> points;
};

struct PlotAxis {
  enum class Ticks { decades, powers_of_two };
  std::string label;
  Ticks ticks = Ticks::decades;
  bool percent = false;  // numbers are shares, shown as "1 %"
};

/// A line y ∝ x^slope through the first point of the first series, to judge the others by.
struct PlotGuide {
  double slope;
  std::string name;
};

struct Plot {
  std::string title;
  PlotAxis x, y;
  std::vector<PlotSeries> series;  // the first six have colours of their own
  std::vector<PlotGuide> guides;
};

/// An <svg> element for a page, which takes its colours from page_css and its look from plot_css. It has groups of class
/// "series" and "key" with data-series = 0, 1, …: curves and their entries in the legend. Empty series are left out of
/// the axes; at least one point is needed.
std::string svg(const Plot& plot);

/// A file of its own with the same look, light or dark as its reader has it.
std::string svg_file(const Plot& plot);

}  // namespace umbral
