// The brightest replicate against the others, and the median against the mean.
#include "image/replicate_tails.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/statistics.h"

namespace umbral {
namespace {

constexpr double false_alarms = 1e-5;  // a pixel
constexpr double least_share = 0.05;   // of the mean

double total(const Vec3d& v) { return v.x + v.y + v.z; }

double median(std::vector<double>& values) {
  const std::size_t half = values.size() / 2;
  std::nth_element(values.begin(), values.begin() + half, values.end());
  if (values.size() % 2 == 1) return values[half];
  return (values[half] + *std::max_element(values.begin(), values.begin() + half)) / 2;
}

}  // namespace

FireflyTest::FireflyTest(int replicates)
    : least_(replicates < replicates_for_tails
                 ? infinity
                 : student_quantile(1 - 2 * false_alarms / replicates, replicates - 2)) {}

bool FireflyTest::operator()(std::span<const Vec3d> means) const {
  const auto n = static_cast<double>(means.size());
  double brightest = 0, sum = 0;
  for (const Vec3d& mean : means) {
    sum += total(mean);
    brightest = std::max(brightest, total(mean));
  }
  const double others = (sum - brightest) / (n - 1), distance = brightest - others;
  if (!(distance > least_share * sum)) return false;
  double squares = -sqr(distance);  // without the brightest
  for (const Vec3d& mean : means) squares += sqr(total(mean) - others);
  const double deviation = std::sqrt(std::max(0.0, squares) / (n - 2) * n / (n - 1));
  return distance > least_ * deviation;
}

void TailSums::add(std::span<const Vec3d> means) {
  const std::size_t size = std::max<std::size_t>(1, means.size() / 8), groups = means.size() / size;
  std::vector<double> values(groups);
  for (int c = 0; c < 3; ++c) {
    Moments moments;
    for (std::size_t g = 0; g < groups; ++g) {
      double sum = 0;
      for (const Vec3d& mean : means.subspan(g * size, size)) sum += mean[c];
      moments.add(values[g] = sum / static_cast<double>(size));
    }
    gaps += 6.0 / static_cast<double>(groups) * (moments.mean - median(values));
    errors += moments.standard_error();
  }
}

}  // namespace umbral
