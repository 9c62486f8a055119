// `umbral help`: explains what a scene file may hold, from the tables that read it.
#include <functional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/parameter_text.h"
#include "core/error.h"
#include "core/kinds.h"
#include "core/names.h"
#include "integrators/registry.h"
#include "scene/description.h"
#include "scene/lights/sky.h"
#include "scene/settings.h"

namespace umbral {
namespace {

// One thing that help can explain.
struct Topic {
  std::string group;  // "material", "shape", …
  std::string kind;   // empty where the group has no kinds
  std::string doc;
  std::vector<ParameterText> parameters;
};

template <class T>
Topic topic_of(const std::string& group, T& object) {
  ParameterTexts texts;
  for_each_parameter(object, texts);
  return {group, object.kind == group ? "" : object.kind, object.doc, texts.texts()};
}

template <class Variant>
void add_kinds(const std::string& group, std::vector<Topic>& topics) {
  for_each_kind<Variant>([&](auto&& object) { topics.push_back(topic_of(group, object)); });
}

void add_materials(std::vector<Topic>& topics) {
  for_each_kind<Lobes>([&](const auto& lobe) {
    Material material;
    material.lobe = lobe;
    ParameterTexts texts;
    for_each_material_parameter(material, texts);
    topics.push_back({"material", lobe.kind, lobe.doc, texts.texts()});
  });
}

const ParameterText transform{
    {"transform",
     "steps in order: {translate=[…]}, {scale=…}, {rotate={axis=[…], degrees=…}}, {matrix=[4 rows]}"},
    "list",
    "[]"};

void add_shapes(std::vector<Topic>& topics) {
  const std::vector<ParameterText> common{
      {{"material", "name of a material; required"}, "text", ""},
      {{"emission", "radiance that the outer side emits, W m⁻² sr⁻¹", non_negative},
       "colour or texture",
       "0"},
      {{"two_sided", "emits on the inner side too"}, "true or false", "false"},
      transform,
      {{"name", "for messages"}, "text", "\"\""}};
  const std::vector<ParameterText> written_out{
      {{"vertices", "[[x, y, z], …], instead of a file"}, "list", ""},
      {{"faces", "[[a, b, c, …], …]: vertices from 0; three or more, counter-clockwise outside"}, "list", ""},
      {{"normals", "of each vertex; without them faces are flat"}, "list", ""},
      {{"uvs", "of each vertex; uvs1: the second uv"}, "list", ""},
      {{"colors", "of each vertex, for the texture vertex_color"}, "list", ""}};
  const std::size_t first = topics.size();
  add_kinds<ShapeKinds>("shape", topics);
  for (std::size_t i = first; i < topics.size(); ++i) {
    std::vector<ParameterText>& parameters = topics[i].parameters;
    if (topics[i].kind == Mesh::kind)
      parameters.insert(parameters.end(), written_out.begin(), written_out.end());
    parameters.insert(parameters.end(), common.begin(), common.end());
  }
}

// What puts a scene together; the reader of scene files knows these keys without a table.
void add_structure(std::vector<Topic>& topics) {
  topics.push_back({"object",
                    "",
                    "[objects.NAME]: shapes that stand nowhere by themselves, for instances to place",
                    {{{"shapes", "[[objects.NAME.shapes]]"}, "list of shapes", ""},
                     {{"include", "[[objects.NAME.include]]"}, "list of included files", ""}}});
  topics.push_back({"instance",
                    "",
                    "[[instances]]: an object in one of its places; memory holds it once",
                    {{{"object", "name of an object; required"}, "text", ""}, transform}});
  topics.push_back({"include",
                    "",
                    "[[include]]: what a file of glTF, OBJ, PLY, STL, pbrt or Mitsuba holds",
                    {{{"file", "relative to the scene file; required"}, "text", ""},
                     {{"material", "for all of it, instead of its own"}, "text", ""},
                     {{"materials", "{its_name = \"ours\"}: replaces them by name"}, "table", ""},
                     transform}});
}

std::vector<Topic> all_topics() {
  std::vector<Topic> topics;
  CameraSettings camera;
  FilmSettings film;
  SamplingSettings sampling;
  topics.push_back(topic_of("camera", camera));
  topics.push_back(topic_of("film", film));
  topics.push_back(topic_of("sampling", sampling));
  for (const IntegratorEntry& entry : integrators()) {
    ParameterTexts texts;
    entry.make()->describe(texts);
    topics.push_back({"integrator", entry.kind, entry.doc, texts.texts()});
  }
  add_materials(topics);
  add_kinds<TextureKinds>("texture", topics);
  add_shapes(topics);
  add_kinds<LightKinds>("light", topics);
  EnvironmentLight environment;
  topics.push_back(topic_of("light", environment));
  SkyLight sky;
  topics.push_back(topic_of("light", sky));
  add_structure(topics);
  return topics;
}

void print_topic(const Topic& topic) {
  fmt::print("{}{}{}: {}\n", topic.group, topic.kind.empty() ? "" : " ", topic.kind, topic.doc);
  for (const ParameterText& parameter : topic.parameters) {
    const std::string range = range_text(parameter.info.range);
    const std::string value = parameter.info.required ? "required" : "default " + parameter.value;
    fmt::print("  {:<21} {}\n  {:<21} {}{}{}\n", parameter.info.name, parameter.info.doc, "", parameter.type,
               range.empty() ? "" : ", " + range, parameter.value.empty() ? "" : ", " + value);
  }
}

void print_overview(const std::vector<Topic>& topics, const CLI::App& app) {
  fmt::print("umbral help GROUP [KIND] or umbral help KIND explains what a scene file may hold:\n");
  std::string group;
  for (const Topic& topic : topics) {
    if (topic.group != group)
      fmt::print("{}{}", group.empty() ? "" : "\n", fmt::format("  {:<12}", topic.group));
    fmt::print(" {}", topic.kind.empty() ? topic.doc : topic.kind);
    group = topic.group;
  }
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
  fmt::print("\numbral COMMAND --help explains a command: {}.\n", fmt::join(commands, ", "));
}

// What "GROUP", "GROUP KIND" or "KIND" means: a kind may be one of several groups.
std::vector<const Topic*> chosen_topics(const std::vector<Topic>& topics, const std::string& word,
                                        const std::string& kind) {
  std::vector<const Topic*> chosen;
  std::vector<std::string> groups, kinds, words;
  for (const Topic& topic : topics) {
    if (groups.empty() || groups.back() != topic.group) groups.push_back(topic.group);
    if (topic.group == word) kinds.push_back(topic.kind);
    words.insert(words.end(), {topic.group, topic.kind});
    const bool by_group = topic.group == word && (kind.empty() || topic.kind == kind);
    if (by_group || (topic.kind == word && kind.empty())) chosen.push_back(&topic);
  }
  if (!chosen.empty()) return chosen;
  if (!kinds.empty())
    throw SceneError(Where{}, "there is no " + word + " '" + kind + "'" + suggestion(kind, kinds));
  throw SceneError(Where{}, "there is no help on '" + word + "'" +
                                suggestion(word, nearest_name(word, words).empty() ? groups : words));
}

void print_help(const std::string& word, const std::string& kind, const CLI::App& app) {
  const std::vector<Topic> topics = all_topics();
  if (word.empty()) return print_overview(topics, app);
  bool printed = false;
  for (const Topic* topic : chosen_topics(topics, word, kind)) {
    if (printed) fmt::print("\n");
    print_topic(*topic);
    printed = true;
  }
}

}  // namespace

void add_help_command(CLI::App& app, int& exit_code) {
  CLI::App* help = app.add_subcommand("help", "explain materials, textures, lights, shapes, integrators, …");
  struct Arguments {
    std::string group, kind;
  };
  auto arguments = std::make_shared<Arguments>();
  help->add_option("group", arguments->group,
                   "material, texture, shape, light, integrator, camera, film, sampling, object, instance, "
                   "include, or a kind "
                   "of them, or a command");
  help->add_option("kind", arguments->kind, "one of its kinds");
  help->callback([arguments, &app, &exit_code] {
    exit_code = exit_success;
    for (const CLI::App* command : app.get_subcommands({}))
      if (command->get_name() == arguments->group) return void(fmt::print("{}", command->help("umbral")));
    print_help(arguments->group, arguments->kind, app);
  });
}

}  // namespace umbral
