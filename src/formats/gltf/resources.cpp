// Decoding of URIs.
#include "formats/gltf/resources.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

namespace umbral::gltf {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char low = static_cast<char>(c | 0x20);
  return low >= 'a' && low <= 'f' ? low - 'a' + 10 : -1;
}

std::optional<std::string> percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
    if (high < 0 || low < 0) return std::nullopt;
    decoded += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return decoded;
}

constexpr std::array<std::int8_t, 256> base64_values() {
  std::array<std::int8_t, 256> values{};
  for (std::int8_t& value : values) value = -1;
  for (int i = 0; i < 26; ++i) {
    values['A' + i] = static_cast<std::int8_t>(i);
    values['a' + i] = static_cast<std::int8_t>(26 + i);
  }
  for (int i = 0; i < 10; ++i) values['0' + i] = static_cast<std::int8_t>(52 + i);
  values['+'] = values['-'] = 62;
  values['/'] = values['_'] = 63;
  return values;
}

// Nothing where a character is none of the alphabet or the length is impossible. Padding may be absent.
std::optional<std::string> base64_decoded(std::string_view text) {
  static constexpr std::array<std::int8_t, 256> values = base64_values();
  while (text.ends_with('=')) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int value = values[static_cast<unsigned char>(c)];
    if (value < 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  return bytes;
}

std::optional<Uri> data_uri(std::string_view rest, std::string& fault) {
  const std::size_t comma = rest.find(',');
  const std::string_view head = rest.substr(0, std::min(comma, rest.size()));
  fault = "its data: URI is broken";
  if (comma == std::string_view::npos || head.find(";;") != std::string_view::npos) return std::nullopt;
  const std::string_view content = rest.substr(comma + 1);
  auto bytes = head.ends_with(";base64") ? base64_decoded(content) : percent_decoded(content);
  if (!bytes) return std::nullopt;
  Uri uri;
  uri.is_data = true;
  uri.mime_type = std::string(head.substr(0, head.find(';')));
  uri.bytes = std::move(*bytes);
  return uri;
}

bool has_scheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  if (colon == std::string_view::npos) return false;
  return std::all_of(uri.begin(), uri.begin() + static_cast<std::ptrdiff_t>(colon),
                     [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '.' || c == '-'; });
}

}  // namespace

std::optional<Uri> parse_uri(std::string_view uri, std::string& fault) {
  if (uri.starts_with("data:")) return data_uri(uri.substr(5), fault);
  fault = "its URI is neither data: nor the name of a file beside this one";
  if (uri.empty() || has_scheme(uri)) return std::nullopt;
  const auto name = percent_decoded(uri);
  if (!name || name->find('\0') != std::string::npos) {
    fault = "its URI has a wrong percent sign";
    return std::nullopt;
  }
  Uri result;
  result.file = *name;
  if (result.file.is_absolute()) return std::nullopt;
  return result;
}

}  // namespace umbral::gltf
