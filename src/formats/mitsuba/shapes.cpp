// Conversion of shapes.
#include "formats/mitsuba/shapes.h"

#include <set>

#include <fmt/format.h>

#include "formats/assembly/place_shape.h"
#include "formats/meshes/mesh_facing.h"
#include "formats/mitsuba/serialized_mesh.h"

namespace umbral::mitsuba_file {
namespace {

// From (−1, −1, −1) to (1, 1, 1), each face with the whole unit square as its uv, as Mitsuba lays it.
Mesh cube() {
  static constexpr std::uint32_t corners[24] = {1, 5, 4, 0, 3, 2, 6, 7, 1, 3, 7, 5,
                                                5, 7, 6, 4, 4, 6, 2, 0, 3, 1, 0, 2};
  static constexpr float uvs[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  Mesh mesh;
  for (std::uint32_t i = 0; i < 24; ++i) {
    const std::uint32_t c = corners[i];
    mesh.positions.push_back({c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1});
    mesh.uvs.push_back({uvs[i % 4][0], uvs[i % 4][1]});
    if (i % 4 == 0) {
      mesh.triangles.push_back({i, i + 1, i + 2});
      mesh.triangles.push_back({i + 3, i, i + 2});
    }
  }
  return mesh;
}

}  // namespace

void Shapes::add(const Element& element, ShapeList& shapes) {
  const Properties properties(builder_, document_, element);
  if (element.type == "shapegroup") return add_group(properties);
  if (element.type == "instance") return add_instance(properties);
  if (element.type == "merge") {
    for (const Element* part : properties.objects("shape")) add(*part, shapes);
    return properties.report_unknown();
  }
  Affine to_world = &shapes == &builder_.world ? properties.placed() : properties.transform("to_world");
  const Element* bsdf = properties.object("bsdf");
  const Element* emitter = properties.object("emitter");
  const MaterialId material = bsdf ? materials_.convert(*bsdf) : materials_.standard();
  const Textured<Spectrum> emission = emitter ? this->emission(*emitter) : Textured<Spectrum>{black};
  std::optional<ShapeKinds> read =
      this->read(properties, attribute_of(material, emission, element.place), to_world);
  const bool turned = properties.flag("flip_normals", false);
  for (const Element* medium : properties.objects("medium")) builder_.lacks(medium->place, "a medium");
  properties.ignore({"bsdf", "emitter", "silhouette_sampling_weight"});
  properties.report_unknown();
  if (!read) return;
  Shape shape{element.id, std::move(*read), to_world, material};
  shape.emission = emission;
  if (material == MaterialId::none) {
    if (shape.emits()) builder_.lacks(element.place, "an emitter that light passes through");
    return;
  }
  if (turned) turn_over(shape, element.place);
  if (const auto fault = place_shape(std::move(shape), element.place, builder_.diagnostics, shapes))
    builder_.diagnostics.error(element.place, fault->message);
}

Textured<Spectrum> Shapes::emission(const Element& emitter) {
  const Properties light(builder_, document_, emitter);
  Textured<Spectrum> emission{black};
  if (emitter.type != "area")
    builder_.lacks(emitter.place, fmt::format("an emitter of type '{}' on a shape", emitter.type));
  else
    emission = textures_.light(light, "radiance", white);
  light.ignore({"sampling_weight"});
  light.report_unknown();
  return emission;
}

std::string Shapes::attribute_of(MaterialId material, const Textured<Spectrum>& emission,
                                 const Place& place) {
  std::set<std::string> asked;
  const auto ask = [&](TextureId texture) {
    if (const std::string* attribute = textures_.attribute(texture)) asked.insert(*attribute);
  };
  ask(emission.map);
  if (material != MaterialId::none)
    for_each_part(builder_.materials[index_of(material)], builder_.materials, [&](const Material& part) {
      ask(part.alpha.map);
      for (const TexturedParameter& map : part.maps) ask(map.texture);
    });
  if (asked.size() > 1) builder_.lacks(place, "two attributes of a mesh on one surface");
  return asked.empty() ? "" : *asked.begin();
}

void Shapes::turn_over(Shape& shape, const Place& place) {
  if (auto* mesh = std::get_if<Mesh>(&shape.kind)) {
    turn_inside_out(*mesh);
  } else if (auto* rectangle = std::get_if<Rectangle>(&shape.kind)) {
    std::swap(rectangle->edge_u, rectangle->edge_v);
  } else if (std::holds_alternative<Disk>(shape.kind)) {
    shape.to_world = shape.to_world * scaling({1, 1, -1});
  } else {
    builder_.lacks(place, "a round shape whose inside is its outside");
  }
}

void Shapes::add_group(const Properties& properties) {
  if (groups_.contains(&properties.element())) return;
  const auto id = static_cast<ObjectId>(builder_.objects.size());
  groups_.emplace(&properties.element(), id);
  builder_.objects.push_back({properties.element().id, {}});
  ShapeList content;
  for (const Element* part : properties.objects("shape")) {
    if (part->type == "shapegroup" || part->type == "instance")
      builder_.lacks(part->place, "a group in a group");
    else
      add(*part, content);
  }
  properties.report_unknown();
  builder_.objects[index_of(id)].content = std::move(content);
}

void Shapes::add_instance(const Properties& properties) {
  const Affine to_world = properties.placed();
  const Element* group = properties.object("shape");
  properties.ignore({"shapegroup"});
  properties.report_unknown();
  if (!group || group->type != "shapegroup") {
    builder_.diagnostics.error(properties.place(),
                               "an instance wants a <ref> to a shape of type 'shapegroup'");
    return;
  }
  add_group(Properties(builder_, document_, *group));
  const ObjectId id = groups_.at(group);
  if (!builder_.objects[index_of(id)].content.shapes.empty()) builder_.instances.push_back({id, to_world});
}

std::optional<ShapeKinds> Shapes::read(const Properties& properties, const std::string& attribute,
                                       Affine& to_world) {
  const std::string& type = properties.element().type;
  if (type == "obj" || type == "ply") return mesh_from_file(properties, attribute);
  if (type == "serialized") return serialized(properties);
  if (type == "sphere") return sphere(properties, to_world);
  if (type == "rectangle") return Rectangle{};
  if (type == "cube") return cube();
  if (type == "disk") return Disk{};
  if (type == "cylinder") return cylinder(properties);
  builder_.lacks(properties.place(), fmt::format("a shape of type '{}'", type));
  for (const Element& child : properties.element().children) properties.find(child.name);
  return std::nullopt;
}

// Mitsuba's v runs from +z to −z: the sphere is turned over without its sides changing.
std::optional<ShapeKinds> Shapes::sphere(const Properties& properties, Affine& to_world) {
  Sphere sphere;
  sphere.center = Vec3(properties.vector("center", Vec3d(0)));
  sphere.radius = static_cast<float>(properties.number("radius", 1));
  if (!(sphere.radius > 0)) {
    builder_.diagnostics.error(properties.place(), "a radius must be above 0");
    return std::nullopt;
  }
  const Vec3d middle(sphere.center);
  to_world = to_world * translation(middle) * scaling({1, 1, -1}) * translation(-middle);
  return sphere;
}

std::optional<ShapeKinds> Shapes::cylinder(const Properties& properties) {
  Cylinder cylinder;
  cylinder.bottom = Vec3(properties.vector("p0", Vec3d(0)));
  cylinder.top = Vec3(properties.vector("p1", {0, 0, 1}));
  cylinder.radius = static_cast<float>(properties.number("radius", 1));
  if (cylinder.radius > 0) return cylinder;
  builder_.diagnostics.error(properties.place(), "a radius must be above 0");
  return std::nullopt;
}

std::optional<Mesh> Shapes::mesh_from_file(const Properties& properties, const std::string& attribute) {
  const std::string& type = properties.element().type;
  const std::string file = properties.text("filename", "");
  const bool flat = properties.flag("face_normals", false);
  const bool turned_uv = properties.flag("flip_tex_coords", type == "obj");
  const bool of_faces = attribute.starts_with("face_");
  const std::string name = attribute.substr(std::min(attribute.size(), attribute.find('_') + 1));
  std::optional<Mesh> mesh = read_mesh_file(builder_, document_.find(file), properties.place(),
                                            {of_faces, name == "color" ? "" : name});
  if (!mesh) return std::nullopt;
  if (!attribute.empty() && mesh->colors.empty()) {
    builder_.diagnostics.error(properties.place(), fmt::format("the mesh has no attribute '{}'", attribute));
    return std::nullopt;
  }
  if (flat) mesh->normals.clear();
  if (turned_uv)
    for (Vec2& uv : mesh->uvs) uv.y = 1 - uv.y;
  return mesh;
}

std::optional<Mesh> Shapes::serialized(const Properties& properties) {
  const std::string file = properties.text("filename", "");
  const int index = properties.integer("shape_index", 0);
  const bool flat = properties.flag("face_normals", false);
  const std::filesystem::path path = document_.find(file);
  try {
    Mesh mesh = read_serialized_mesh(path.string(), builder_.files.read(path), index);
    if (flat) mesh.normals.clear();
    return mesh;
  } catch (const SceneError& error) {
    builder_.diagnostics.error(properties.place(), error);
    return std::nullopt;
  }
}

}  // namespace umbral::mitsuba_file
