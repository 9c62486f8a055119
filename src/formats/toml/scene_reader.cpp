// One section of a scene file after the other.
#include "formats/toml/scene_reader.h"

#include <fmt/format.h>

#include "core/kinds.h"
#include "formats/assembly/number_checks.h"
#include "formats/toml/image_files.h"
#include "formats/toml/light_reader.h"
#include "formats/toml/parameter_reader.h"
#include "formats/toml/shape_reader.h"
#include "formats/toml/transform.h"

namespace umbral::toml_file {
namespace {

class SceneReader {
 public:
  SceneReader(const Context& context, const Value& root, const std::filesystem::path& folder,
              SceneBuilder& builder)
      : context_(context),
        root_(context, root.as<Value::Table>(), "scene", context.place(0, 0)),
        builder_(builder),
        textures_(context, builder, folder),
        materials_(context, "material"),
        objects_(context, "object"),
        shapes_(context, builder, textures_, materials_, folder),
        lights_(context, builder, folder) {}

  void read(const IntegratorKinds& integrators, SceneFile& result);

 private:
  TableReader table_of(TableReader& parent, const std::string& name);
  template <class T>
  void read_described(T& described);
  void read_camera();
  void read_integrator(const IntegratorKinds& integrators, std::string& chosen);
  std::optional<MaterialId> read_material(const Entry& entry, const Value::Table& entries);
  void check_detail(TableReader& table, const Material& material) const;
  std::optional<ObjectId> read_object(const Entry& entry, const Value::Table& entries);
  void read_instance(const Value& item, const Value::Table& entries);
  void check_content() const;

  const Context& context_;
  TableReader root_;
  SceneBuilder& builder_;
  TextureLibrary textures_;
  NameTable<MaterialId> materials_;
  NameTable<ObjectId> objects_;
  ShapeReader shapes_;
  LightReader lights_;
};

TableReader SceneReader::table_of(TableReader& parent, const std::string& name) {
  const Entry* entry = parent.find_entry(name);
  if (!entry) return {context_, nullptr, name, parent.place()};
  const auto* entries = entry->value.as<Value::Table>();
  if (!entries)
    context_.error(entry->value, fmt::format("'{}' must be a table, not {}", name, entry->value.type_name()));
  return {context_, entries, name, context_.place(*entry)};
}

template <class T>
void SceneReader::read_described(T& described) {
  TableReader table = table_of(root_, T::kind);
  ParameterReader parameters(table, nullptr);
  for_each_parameter(described, parameters);
  table.finish();
}

void SceneReader::read_camera() {
  TableReader table = table_of(root_, CameraSettings::kind);
  builder_.has_camera = root_.has(CameraSettings::kind);
  CameraSettings& camera = builder_.camera;
  ParameterReader parameters(table, nullptr);
  for_each_parameter(camera, parameters);
  table.finish();
  const auto blame = [&](const char* key, const char* message) {
    const Value* value = table.find(key);
    context_.diagnostics.error(value ? context_.place(*value) : table.place(), message);
  };
  if (camera.look_at == camera.position)
    blame("look_at", "'look_at' of 'camera' is its 'position': there is no direction to look in");
  else if (lacks_up(camera))
    blame("up", "'up' of 'camera' is along the view, or zero: it does not tell what is up");
  if (table.has("focus_distance") && !table.has("lens_radius"))
    context_.error(*table.find_entry("focus_distance"),
                   "'focus_distance' has no effect without 'lens_radius'");
  for (const char* name : {"fov", "lens_radius"})
    if (camera.orthographic_height > 0 && table.has(name))
      context_.diagnostics.warning(
          context_.place(*table.find_entry(name)),
          fmt::format("'{}' has no effect where 'orthographic_height' is given", name));
}

void SceneReader::read_integrator(const IntegratorKinds& integrators, std::string& chosen) {
  chosen = integrators.default_kind;
  TableReader table = table_of(root_, "integrator");
  if (table.has("type"))
    if (const auto kind = table.find_kind("integrator", integrators.kinds)) chosen = *kind;
  table.find("type");
  for (const std::string& kind : integrators.kinds) {
    TableReader settings = table_of(table, kind);
    ParameterReader parameters(settings, nullptr);
    integrators.read(kind, parameters);
    settings.finish();
  }
  table.finish();
}

std::optional<MaterialId> SceneReader::read_material(const Entry& entry, const Value::Table& entries) {
  TableReader table(context_, &entries, "material", context_.place(entry));
  const auto kind = table.find_kind("material", kind_names<Lobes>());
  if (!kind) return std::nullopt;
  table.rename(*kind);
  Material material{entry.key, *make_kind<Lobes>(*kind), {}, {1}};
  ParameterReader parameters(table, &textures_, &materials_);
  textures_.set_asker(fmt::format("material '{}'", entry.key));
  for_each_material_parameter(material, parameters);
  textures_.set_asker("");
  check_detail(table, material);
  table.finish();
  return builder_.add(std::move(material), table.place());
}

// What has no effect is not what was meant.
void SceneReader::check_detail(TableReader& table, const Material& material) const {
  const auto blame = [&](const char* key, const char* message) {
    if (table.has(key)) context_.error(*table.find_entry(key), message);
  };
  const auto* conductor = std::get_if<Conductor>(&material.lobe);
  if (conductor && conductor->metal != Metal::none)
    for (const char* key : {"reflectance", "edge_tint", "eta", "k"})
      blame(key, "'metal' tells the index of a conductor: no other colour has an effect beside it");
  if (material.alpha_mode != AlphaMode::mask)
    blame("alpha_cutoff", "'alpha_cutoff' has no effect unless alpha_mode is \"mask\"");
  if (!table.has("normal_map")) blame("normal_scale", "'normal_scale' has no effect without 'normal_map'");
  if (!table.has("clearcoat_normal_map"))
    blame("clearcoat_normal_scale", "'clearcoat_normal_scale' has no effect without 'clearcoat_normal_map'");
  if (!table.has("bump_map")) blame("bump_scale", "'bump_scale' has no effect without 'bump_map'");
}

std::optional<ObjectId> SceneReader::read_object(const Entry& entry, const Value::Table& entries) {
  TableReader table(context_, &entries, "object", context_.place(entry));
  builder_.objects.push_back({entry.key, {}});
  ShapeList content;
  if (const Value* list = table.find("shapes")) shapes_.read_shapes(*list, content);
  if (const Value* list = table.find("include")) shapes_.read_includes(*list, content);
  table.finish("key");
  if (!table.has("shapes") && !table.has("include"))
    context_.error(entry, fmt::format("object '{}' has no shapes", entry.key));
  builder_.objects.back().content = std::move(content);
  return static_cast<ObjectId>(builder_.objects.size() - 1);
}

void SceneReader::read_instance(const Value& item, const Value::Table& entries) {
  TableReader table(context_, &entries, "instance", context_.place(item));
  std::optional<ObjectId> object;
  if (const Value* value = table.find("object"))
    object = objects_.find(*value);
  else
    table.missing("object");
  const Affine to_world = read_transform(table);
  table.finish();
  if (object) builder_.instances.push_back({*object, to_world});
}

// Things that only the whole document tells. What unread parts would have used is not known.
void SceneReader::check_content() const {
  if (context_.parts_unread) return;
  textures_.report_unused();
  materials_.report_unused();
  objects_.report_unused();
  const bool empty = builder_.world.shapes.empty() && builder_.instances.empty() && !builder_.environment;
  if (empty && !context_.diagnostics.has_errors())
    context_.diagnostics.error(context_.place(0, 0), "there is nothing to see: no shape and no environment");
}

void SceneReader::read(const IntegratorKinds& integrators, SceneFile& result) {
  read_camera();
  read_described(result.film);
  read_described(result.sampling);
  read_integrator(integrators, result.integrator);
  if (const Value* section = root_.find("textures")) textures_.open_section(*section);
  if (const Value* section = root_.find("materials"))
    materials_.read_section(*section,
                            [&](const Entry& e, const Value::Table& t) { return read_material(e, t); });
  if (const Value* section = root_.find("objects"))
    objects_.read_section(*section, [&](const Entry& e, const Value::Table& t) { return read_object(e, t); });
  if (const Value* list = root_.find("shapes")) shapes_.read_shapes(*list, builder_.world);
  if (const Value* list = root_.find("include")) shapes_.read_includes(*list, builder_.world);
  if (const Value* list = root_.find("instances"))
    for_each_table(context_, *list, "instances",
                   [&](const Value& item, const Value::Table& entries) { read_instance(item, entries); });
  if (const Value* list = root_.find("lights")) lights_.read(*list);
  textures_.read_rest();
  root_.finish("section");
  check_content();
}

}  // namespace

void read_scene(const std::shared_ptr<const SourceText>& source, const std::filesystem::path& folder,
                const IntegratorKinds& integrators, SceneBuilder& builder, SceneFile& result) {
  const Value root = parse(source);
  const Context context{builder.diagnostics, source};
  expect_images(root, folder, builder);
  SceneReader(context, root, folder, builder).read(integrators, result);
}

void read_no_settings(const IntegratorKinds& integrators, Diagnostics& diagnostics, SceneFile& result) {
  const Context context{diagnostics, std::make_shared<const SourceText>("", "")};
  result.integrator = integrators.default_kind;
  for (const std::string& kind : integrators.kinds) {
    TableReader empty(context, nullptr, kind, {});
    ParameterReader parameters(empty, nullptr);
    integrators.read(kind, parameters);
  }
}

}  // namespace umbral::toml_file
