// Parameters as lines of a scene file.
#pragma once

#include <string>
#include <vector>

#include "app/parameter_text.h"

namespace umbral {

/// TOML text of a string, with quotes.
std::string toml_string(const std::string& text);

/// ParameterTexts whose textures are written by their names.
class TexturedTexts : public ParameterTexts {
 public:
  /// The names of the scene's textures, by their number.
  explicit TexturedTexts(const std::vector<std::string>& textures) : textures_(textures) {}

  using ParameterTexts::operator();
  void operator()(const ParameterInfo&, Textured<float>&) override;
  void operator()(const ParameterInfo&, Textured<Spectrum>&) override;
  void operator()(const ParameterInfo&, std::string&) override;

 private:
  const std::vector<std::string>& textures_;
};

/// "name = value" for each parameter whose value is not its default, a line each. `described` is a struct with a table
/// (core/parameters.h).
std::string changed_lines(const std::vector<ParameterText>& given,
                          const std::vector<ParameterText>& defaults);

template <class T>
std::string changed_lines(T described, const std::vector<std::string>& textures) {
  TexturedTexts given(textures), defaults(textures);
  T fresh{};
  for_each_parameter(described, given);
  for_each_parameter(fresh, defaults);
  return changed_lines(given.texts(), defaults.texts());
}

}  // namespace umbral
