// The product of lists of alternatives.
#include "app/variants.h"

#include <algorithm>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/arguments.h"
#include "app/parameter_text.h"
#include "core/names.h"
#include "formats/settings_text.h"

namespace umbral {
namespace {

// One setting and its alternatives, at least one.
struct Axis {
  std::string owner, name;
  std::vector<std::string> values;
};

// At commas outside of brackets and quotes.
std::vector<std::string> split_values(const std::string& text) {
  std::vector<std::string> values(1);
  int depth = 0;
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (!quoted) depth += (c == '[') - (c == ']');
    if (c == ',' && depth == 0 && !quoted)
      values.emplace_back();
    else
      values.back() += c;
  }
  return values;
}

Axis parsed_axis(const std::string& text) {
  const std::size_t dot = text.find('.'), equals = text.find('=');
  if (dot == std::string::npos || equals == std::string::npos || dot > equals || dot == 0 ||
      dot + 1 == equals)
    refuse("--set wants OWNER.NAME=VALUE,…, such as path.strategy=mis,light, not '" + text + "'");
  Axis axis{text.substr(0, dot), text.substr(dot + 1, equals - dot - 1),
            split_values(text.substr(equals + 1))};
  for (const std::string& value : axis.values)
    if (value.empty()) refuse("--set " + text + ": a value is missing");
  return axis;
}

// A word needs no quotes on the command line.
std::string toml_value(const std::string& text) {
  const bool word = std::isalpha(static_cast<unsigned char>(text[0])) && text != "true" && text != "false" &&
                    text != "inf" && text != "nan";
  return word ? '"' + text + '"' : text;
}

void apply(Variant& variant, const Axis& axis, const std::string& value) {
  const std::string text = axis.name + " = " + toml_value(value);
  const std::string source = "--set " + axis.owner + "." + axis.name + "=" + value;
  read_settings(source, axis.owner, text, [&](ParameterVisitor& visitor) {
    if (axis.owner == FilmSettings::kind)
      for_each_parameter(variant.film, visitor);
    else if (axis.owner == SamplingSettings::kind)
      for_each_parameter(variant.sampling, visitor);
    else
      variant.integrator->describe(visitor);
  });
}

// One with the same settings.
std::unique_ptr<Integrator> copy_of(const std::string& kind, Integrator& integrator) {
  ParameterTexts texts;
  integrator.describe(texts);
  std::string text;
  for (const ParameterText& t : texts.texts()) text += fmt::format("{} = {}\n", t.info.name, t.value);
  std::unique_ptr<Integrator> copy = make_integrator(kind);
  read_settings(kind, kind, text, [&](ParameterVisitor& visitor) { copy->describe(visitor); });
  return copy;
}

void require_known(const std::vector<std::string>& names, const std::vector<std::string>& known,
                   const std::string& noun) {
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      refuse(fmt::format("there is no {} '{}'{}", noun, name, suggestion(name, known)));
}

std::vector<Axis> axes_of(const VariantArguments& arguments, const std::vector<std::string>& integrators) {
  std::vector<Axis> axes;
  if (!arguments.samplers.empty()) axes.push_back({SamplingSettings::kind, "sampler", arguments.samplers});
  std::vector<std::string> owners = integrators;
  owners.insert(owners.end(), {SamplingSettings::kind, FilmSettings::kind});
  for (const std::string& text : arguments.settings) {
    axes.push_back(parsed_axis(text));
    require_known({axes.back().owner}, owners, "owner of settings among these variants called");
  }
  return axes;
}

// One variant a combination of the axes' values: the last axis changes fastest.
void add_combinations(const LoadedScene& scene, const std::string& kind, bool named,
                      const std::vector<Axis>& axes, std::vector<Variant>& result) {
  std::size_t count = 1;
  for (const Axis& axis : axes) count *= axis.values.size();
  for (std::size_t i = 0; i < count; ++i) {
    Variant variant{named ? kind : "",  kind, "", copy_of(kind, *scene.integrators.at(kind)), scene.file.film,
                    scene.file.sampling};
    std::size_t rest = i, repeat = count;
    for (const Axis& axis : axes) {
      repeat /= axis.values.size();
      const std::string& value = axis.values[rest / repeat];
      rest %= repeat;
      apply(variant, axis, value);
      if (axis.values.size() < 2) continue;
      const bool plain = axis.name == "sampler";
      variant.name += (variant.name.empty() ? "" : " ") + (plain ? value : axis.name + "=" + value);
    }
    variant.call = integrator_text(kind, *variant.integrator);
    if (variant.name.empty()) variant.name = kind;
    result.push_back(std::move(variant));
  }
}

}  // namespace

void add_variant_options(CLI::App& command, VariantArguments& a) {
  command.add_option("--integrators", a.integrators, "these, instead of the scene's: path,blinn_phong")
      ->delimiter(',');
  command.add_option("--samplers", a.samplers, "these, instead of the scene's: sobol,independent")
      ->delimiter(',');
  command
      .add_option("--set", a.settings,
                  "a setting of an integrator, of sampling or of film, with its alternatives: "
                  "path.strategy=mis,light; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
}

std::vector<Variant> variants(const LoadedScene& scene, const VariantArguments& arguments) {
  std::vector<std::string> known;
  for (const IntegratorEntry& entry : integrators()) known.push_back(entry.kind);
  require_known(arguments.integrators, known, "integrator");
  require_known(arguments.samplers, sampler_names(), "sampler");
  std::vector<std::string> kinds = arguments.integrators;
  if (kinds.empty()) kinds = {scene.file.integrator};
  const std::vector<Axis> axes = axes_of(arguments, kinds);
  std::vector<Variant> result;
  for (const std::string& kind : kinds) {
    std::vector<Axis> own;
    for (const Axis& axis : axes)
      if (std::find(kinds.begin(), kinds.end(), axis.owner) == kinds.end() || axis.owner == kind)
        own.push_back(axis);
    add_combinations(scene, kind, kinds.size() > 1, own, result);
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      if (result[i].name == result[j].name) refuse("'" + result[i].name + "' is asked for twice");
    if (result[i].film.width != result[0].film.width || result[i].film.height != result[0].film.height)
      refuse("the images of all variants must have the same size");
  }
  return result;
}

void require_several(const std::vector<Variant>& variants) {
  if (variants.size() < 2)
    refuse(
        "there is nothing to compare: name two at least, as in --integrators blinn_phong,path, "
        "--samplers sobol,independent or --set path.strategy=mis,light");
}

}  // namespace umbral
