// Text of parameters that differ from their defaults.
#include "app/convert/parameter_lines.h"

#include <fmt/format.h>

namespace umbral {

std::string toml_string(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      result += fmt::format("\\u{:04X}", static_cast<unsigned char>(c));
    else
      result += c;
  }
  return result + '"';
}

void TexturedTexts::operator()(const ParameterInfo& info, Textured<float>& v) {
  if (v.is_constant()) return ParameterTexts::operator()(info, v);
  std::string name = textures_[index_of(v.map)];
  (*this)(info, name);
}

void TexturedTexts::operator()(const ParameterInfo& info, Textured<Spectrum>& v) {
  if (v.is_constant()) return ParameterTexts::operator()(info, v);
  std::string name = textures_[index_of(v.map)];
  (*this)(info, name);
}

void TexturedTexts::operator()(const ParameterInfo& info, std::string& v) {
  add(info, "text", toml_string(v));
}

std::string changed_lines(const std::vector<ParameterText>& given,
                          const std::vector<ParameterText>& defaults) {
  std::string lines;
  for (std::size_t i = 0; i < given.size(); ++i)
    if (given[i].value != defaults[i].value)
      lines += fmt::format("{} = {}\n", given[i].info.name, given[i].value);
  return lines;
}

}  // namespace umbral
