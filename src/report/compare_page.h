// The page of a comparison: both images, what differs, and the numbers.
#pragma once

#include <string>
#include <vector>

#include "analysis/convolution.h"
#include "analysis/planes.h"
#include "analysis/regions.h"
#include "report/page.h"

namespace umbral {

/// What it shows. Pixels travel as 16-bit floating point numbers, so that the browser can expose them anew; those above
/// 65504 are cut to that, here alone.
struct CompareView {
  std::string name_a, name_b;
  std::string verdict, reason;
  std::string change;  // of the whole image from A to B, in words
  std::string tone;    // "good", "bad" or "unsure": how the verdict looks
  std::string text;    // all numbers, for people
  std::string json;    // and for programs
  const Planes& a;
  const Planes& b;
  const Plane& z;         // (b − a) over its standard error; empty: not shown
  const Plane& flip;      // 0 … 1
  std::vector<double> p;  // of the tiles that were tested
  struct Label {
    Region region;
    std::string text;
  };
  std::vector<Label> labels;  // drawn on the images
  double exposure = 0;        // stops, at first
};

Page compare_page(const CompareView& view);

}  // namespace umbral
