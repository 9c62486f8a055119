// RGB, black bodies, tabulated and named spectra.
#include "formats/pbrt/colors.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "formats/translation/spectral_colors.h"

namespace umbral::pbrt_file {
namespace {

// Pairs of wavelength and value, interpolated and constant beyond their ends.
std::optional<SpectralCurve> table_of(const Parameters& parameters, const Parameter& parameter) {
  const std::vector<double>& v = parameter.numbers;
  if (v.size() < 2 || v.size() % 2 != 0) {
    parameters.error(parameter, "a spectrum is pairs of a wavelength in nm and a value");
    return std::nullopt;
  }
  for (std::size_t i = 2; i < v.size(); i += 2)
    if (!(v[i] > v[i - 2])) {
      parameters.error(parameter, "the wavelengths of a spectrum must grow");
      return std::nullopt;
    }
  return [v](double nanometres) {
    if (nanometres <= v[0]) return v[1];
    for (std::size_t i = 2; i < v.size(); i += 2)
      if (nanometres <= v[i]) {
        const double t = (nanometres - v[i - 2]) / (v[i] - v[i - 2]);
        return v[i - 1] + t * (v[i + 1] - v[i - 1]);
      }
    return v.back();
  };
}

Spectrum rgb_of(const Parameter& parameter) {
  return rgb(static_cast<float>(parameter.numbers[0]), static_cast<float>(parameter.numbers[1]),
             static_cast<float>(parameter.numbers[2]));
}

const Parameter* find_spectrum(const Parameters& parameters, const std::string& name) {
  const Parameter* found = parameters.find(name, spectrum_types, 0);
  if (!found) return nullptr;
  const std::size_t wanted = found->type == "rgb" ? 3 : found->type == "blackbody" ? 1 : 0;
  if (wanted == 0 || found->numbers.size() == wanted) return found;
  parameters.error(*found, fmt::format("\"{} {}\" wants {} numbers, not {}", found->type, name, wanted,
                                       found->numbers.size()));
  return nullptr;
}

Spectrum non_negative_rgb(const Parameters& parameters, const Parameter& parameter) {
  const Spectrum color = rgb_of(parameter);
  if (min_component(color) >= 0 && is_finite(color)) return color;
  parameters.error(parameter, fmt::format("'{}' must not be negative", parameter.name));
  return white;
}

// n_d of the glasses that pbrt knows by name, from their makers' catalogues.
constexpr std::array<std::pair<const char*, double>, 7> glasses{{{"glass-BK7", 1.5168},
                                                                 {"glass-BAF10", 1.67003},
                                                                 {"glass-FK51A", 1.48656},
                                                                 {"glass-LASF9", 1.85025},
                                                                 {"glass-F5", 1.60342},
                                                                 {"glass-SF10", 1.72825},
                                                                 {"glass-SF11", 1.78472}}};

}  // namespace

Spectrum albedo_of(SceneBuilder& builder, const Parameters& parameters, const Parameter& parameter) {
  if (parameter.type == "spectrum" && parameter.strings.empty()) {
    const auto table = table_of(parameters, parameter);
    return table ? reflectance_color(*table) : grey(0.5f);
  }
  if (parameter.type != "rgb" || parameter.numbers.size() != 3) {
    builder.lacks(parameter.place, fmt::format("a reflectance by \"{}\"", parameter.type));
    return grey(0.5f);
  }
  const Spectrum color = rgb_of(parameter);
  const Spectrum kept = glm::clamp(color, Spectrum(0.0f), Spectrum(1.0f));
  if (color != kept)
    builder.diagnostics.warning(parameter.place,
                                fmt::format("'{}' is cut to the range 0 … 1", parameter.name));
  return kept;
}

Spectrum albedo(SceneBuilder& builder, const Parameters& parameters, const std::string& name,
                const Spectrum& otherwise) {
  const Parameter* found = find_spectrum(parameters, name);
  return found ? albedo_of(builder, parameters, *found) : otherwise;
}

Spectrum light(SceneBuilder& builder, const Parameters& parameters, const std::string& name) {
  const Parameter* found = find_spectrum(parameters, name);
  if (!found) return white;
  if (found->type == "rgb") return non_negative_rgb(parameters, *found);
  if (found->type == "blackbody") {
    if (found->numbers[0] > 0) return black_body_color(found->numbers[0]);
    parameters.error(*found, "a black body's temperature must be above 0");
    return white;
  }
  if (found->strings.empty()) {
    const auto table = table_of(parameters, *found);
    return table ? light_color(*table) : white;
  }
  if (found->strings[0] != "stdillum-D65")
    builder.lacks(found->place, fmt::format("the spectrum '{}' of a light", found->strings[0]));
  return white;
}

std::optional<Spectrum> unbounded(SceneBuilder& builder, const Parameters& parameters,
                                  const std::string& name) {
  const Parameter* found = find_spectrum(parameters, name);
  if (!found) return std::nullopt;
  if (found->type == "rgb") return non_negative_rgb(parameters, *found);
  builder.lacks(found->place, fmt::format("'{}' by \"{}\", which is not RGB", name, found->type));
  return std::nullopt;
}

double index_of_refraction(SceneBuilder& builder, const Parameters& parameters, const std::string& name,
                           double otherwise) {
  const Parameter* found = parameters.find(name);
  if (!found) return otherwise;
  double index = otherwise;
  if (found->type == "spectrum" && !found->strings.empty()) {
    for (const auto& [glass, n_d] : glasses)
      if (found->strings[0] == glass) return n_d;
    builder.lacks(found->place, fmt::format("the spectrum '{}' as an index", found->strings[0]));
  } else {
    index = parameters.number(name, otherwise);
  }
  if (index >= 1 && index <= 10) return index;
  builder.lacks(found->place, fmt::format("an index of refraction of {}; it must be 1 … 10", index));
  return otherwise;
}

}  // namespace umbral::pbrt_file
