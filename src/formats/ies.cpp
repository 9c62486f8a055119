// Reading LM-63, and its intensity in any direction.
#include "formats/ies.h"

#include <algorithm>

#include "core/error.h"
#include "formats/input/text_cursor.h"

namespace umbral {
namespace {

constexpr double lumens_per_watt = 179;
constexpr std::size_t most_angles = 1 << 16;

struct Photometry {
  std::vector<double> vertical, horizontal;  // degrees, ascending
  std::vector<double> candela;               // one row of vertical angles after the other

  double at(std::size_t h, std::size_t v) const { return candela[h * vertical.size() + v]; }
};

class IesReader {
 public:
  IesReader(const std::string& text, const std::string& name) : cursor_(text), name_(name) {}

  Photometry read() {
    find_tilt();
    number();  // lamps
    number();  // lumens a lamp
    const double multiplier = number();
    const std::size_t verticals = count("vertical angles"), horizontals = count("horizontal angles");
    if (number() != 1) fail("this is not of photometric type C");
    for (int i = 0; i < 4; ++i) number();  // units and size of the opening
    const double ballast = number(), ballast_lamp = number();
    number();  // watts
    Photometry photometry;
    photometry.vertical = angles(verticals, 180);
    photometry.horizontal = angles(horizontals, 360);
    for (std::size_t i = 0; i < verticals * horizontals; ++i) {
      const double candela = number() * multiplier * ballast * ballast_lamp;
      if (!(candela >= 0) || candela > 1e30) fail("an intensity is negative or beyond all bounds");
      photometry.candela.push_back(candela);
    }
    return photometry;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw SceneError(Where{name_, cursor_.line(), 0}, message);
  }

  // What is before is keywords and their texts.
  void find_tilt() {
    while (!cursor_.at_end()) {
      const std::string_view line = cursor_.rest_of_line();
      if (line.starts_with("TILT")) {
        cursor_.next_line();
        if (line == "TILT=NONE") return;
        if (line != "TILT=INCLUDE") fail("a TILT that is not NONE or INCLUDE is not read");
        number();
        const std::size_t tilts = count("angles of TILT");
        for (std::size_t i = 0; i < 2 * tilts; ++i)
          number();  // how lamps dim that are tilted: these hang as measured
        return;
      }
      cursor_.next_line();
    }
    fail("this is no photometric file of LM-63: it has no line TILT=");
  }

  double number() {
    while (cursor_.at_line_end()) {
      if (cursor_.at_end()) fail("the file ends too early");
      cursor_.next_line();
    }
    double value = 0;
    if (!cursor_.number(value) || !std::isfinite(value))
      fail("'" + std::string(cursor_.word()) + "' is not a number");
    return value;
  }

  std::size_t count(const char* what) {
    const double value = number();
    if (!(value >= 1 && value <= most_angles) || value != std::floor(value))
      fail(std::string("the number of ") + what + " is not one from 1 to 65536");
    return static_cast<std::size_t>(value);
  }

  std::vector<double> angles(std::size_t n, double last) {
    std::vector<double> result;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = number();
      if (angle < 0 || angle > last || (i > 0 && !(angle > result.back())))
        fail("the angles do not ascend within their range");
      result.push_back(angle);
    }
    return result;
  }

  TextCursor cursor_;
  const std::string& name_;
};

// Which of the file's horizontal angles stands for this one, 0 … 360: files leave out what is symmetric.
double unfolded(const Photometry& photometry, double angle) {
  const double first = photometry.horizontal.front(), last = photometry.horizontal.back();
  if (first == 90 && last == 270) return angle < 90 ? 180 - angle : angle > 270 ? 540 - angle : angle;
  if (first != 0 || last > 180) return angle;
  if (last == 180) return std::min(angle, 360 - angle);
  if (last == 90) return std::min(std::fmod(angle, 180), 180 - std::fmod(angle, 180));
  return angle;
}

// Between which two of the ascending angles, and how far; around the circle where asked for.
struct Between {
  std::size_t low, high;
  double share;
};
Between between(const std::vector<double>& angles, double angle, bool around) {
  const auto above = std::upper_bound(angles.begin(), angles.end(), angle);
  const std::size_t last = angles.size() - 1;
  if (above != angles.begin() && above != angles.end()) {
    const auto high = static_cast<std::size_t>(above - angles.begin());
    return {high - 1, high, (angle - angles[high - 1]) / (angles[high] - angles[high - 1])};
  }
  if (!around) return above == angles.begin() ? Between{0, 0, 0} : Between{last, last, 0};
  const double gap = angles.front() + 360 - angles.back();
  const double way = angle >= angles.back() ? angle - angles.back() : angle + 360 - angles.back();
  return {last, 0, gap > 0 ? way / gap : 0};
}

double candela_at(const Photometry& photometry, double vertical, double horizontal) {
  if (vertical < photometry.vertical.front() || vertical > photometry.vertical.back()) return 0;
  const Between v = between(photometry.vertical, vertical, false);
  const Between h = between(photometry.horizontal, unfolded(photometry, horizontal), true);
  const auto along = [&](std::size_t row) {
    return std::lerp(photometry.at(row, v.low), photometry.at(row, v.high), v.share);
  };
  return std::lerp(along(h.low), along(h.high), h.share);
}

}  // namespace

TextureImage luminaire_image(std::string text, const std::string& name) {
  std::replace(text.begin(), text.end(), ',', ' ');
  const Photometry photometry = IesReader(text, name).read();
  constexpr int height = 360;
  const int width = photometry.horizontal.size() == 1 ? 1 : 360;
  TexelGrid<Float4> grid(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double turn = (x + 0.5) * 360 / width - 180;
      const double value =
          candela_at(photometry, (y + 0.5) * 180 / height, turn < 0 ? turn + 360 : turn) / lumens_per_watt;
      grid.set(x, y, Spectrum(Vec3(static_cast<float>(value)), 1));
    }
  return TextureImage(TextureImage::Texels(std::move(grid)));
}

}  // namespace umbral
