// The header and the rows, which go from the bottom up as texels do.
#include "image/pfm.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>

#include "core/error.h"

namespace umbral {
namespace {

class Header {
 public:
  Header(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  // The next word; words are parted by white space.
  std::string_view word() {
    const auto is_space = [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; };
    while (at_ < bytes_.size() && is_space(bytes_[at_])) ++at_;
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && !is_space(bytes_[at_])) ++at_;
    return bytes_.substr(begin, at_ - begin);
  }

  template <class T>
  T number() {
    const std::string_view text = word();
    T value{};
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || parsed.ec != std::errc() || parsed.ptr != text.data() + text.size())
      fail(fmt::format("'{}' is not a number", text));
    return value;
  }

  // What follows the one character after the header.
  std::string_view rest() const { return bytes_.substr(std::min(at_ + 1, bytes_.size())); }

  [[noreturn]] void fail(const std::string& message) const {
    throw SceneError({name_}, "the PFM file is damaged: " + message);
  }

 private:
  std::string_view bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
};

float value_at(const char* bytes, bool little) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, bytes, 4);
  if (little != (std::endian::native == std::endian::little)) bits = __builtin_bswap32(bits);
  return std::bit_cast<float>(bits);
}

}  // namespace

bool is_pfm(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".pfm";
}

TexelGrid<Float4> read_pfm(std::string_view bytes, const std::string& name, std::int64_t most) {
  Header header(bytes, name);
  const std::string_view kind = header.word();
  if (kind != "PF" && kind != "Pf") header.fail("it does not begin with PF or Pf");
  const std::size_t channels = kind == "PF" ? 3 : 1;
  const int width = header.number<int>(), height = header.number<int>();
  const auto scale = header.number<float>();
  if (width < 1 || height < 1 || !(scale != 0)) header.fail("its size or its scale is 0");
  const std::int64_t texels = std::int64_t{width} * height;
  if (texels > most)
    header.fail(fmt::format("it has {} x {} texels, more than the {} supported", width, height, most));
  const std::string_view data = header.rest();
  if (data.size() < static_cast<std::size_t>(texels) * channels * 4)
    header.fail(fmt::format("it ends before its {} x {} texels", width, height));
  TexelGrid<Float4> grid(width, height);
  const char* next = data.data();
  const auto value = [&] {
    const float read = value_at(next, scale < 0) * std::abs(scale);
    next += 4;
    return read;
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float r = value();
      const float g = channels == 3 ? value() : r;
      const float b = channels == 3 ? value() : r;
      grid.set(x, y, {r, g, b, 1});
    }
  return grid;
}

}  // namespace umbral
