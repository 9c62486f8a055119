// The checks, one after the other.
#include "formats/assembly/checks.h"

#include <fmt/format.h>

#include "formats/assembly/number_checks.h"
#include "formats/assembly/scene_bounds.h"
#include "formats/meshes/mesh_topology.h"

namespace umbral {
namespace {

class SceneChecks {
 public:
  SceneChecks(SceneBuilder& scene, const Place& place)
      : scene_(scene), place_(place), numbers_(scene, place) {}

  void run() {
    check_lights();
    check_materials();
    const auto check_list = [&](const ShapeList& list) {
      for (std::size_t i = 0; i < list.shapes.size(); ++i) check_shape(list.shapes[i], list.places[i]);
    };
    check_list(scene_.world);
    for (const ObjectDraft& object : scene_.objects) check_list(object.content);
    for_each_placed([&](const Shape& shape, const Place& place, const Affine& to_world) {
      check_camera(shape, place, to_world);
      check_distance(shape, place, to_world);
    });
    if (far_.count > 0) warn(far_.place, far_.text() + "; move the scene nearer to the origin");
    numbers_.finish();
  }

 private:
  template <class Visit>
  void for_each_placed(Visit&& visit) const;
  void check_lights();
  void check_materials();
  void check_shape(const Shape& shape, const Place& place);
  void check_textures(const Shape& shape, const Place& place, const Material& material);
  void check_camera(const Shape& shape, const Place& place, const Affine& to_world);
  void check_distance(const Shape& shape, const Place& place, const Affine& to_world);
  Spectrum highest_color(const Textured<Spectrum>& value) const;
  bool shines(const Shape& shape) const { return max_component(highest_color(shape.emission)) > 0; }
  void warn(const Place& place, std::string message) {
    scene_.diagnostics.warning(place, std::move(message));
  }

  SceneBuilder& scene_;
  const Place& place_;
  NumberChecks numbers_;
  CountedFault far_;
};

template <class Visit>
void SceneChecks::for_each_placed(Visit&& visit) const {
  const auto visit_list = [&](const ShapeList& list, const Affine& to_world) {
    for (std::size_t i = 0; i < list.shapes.size(); ++i) visit(list.shapes[i], list.places[i], to_world);
  };
  visit_list(scene_.world, Affine{});
  for (const Instance& instance : scene_.instances)
    visit_list(scene_.objects[index_of(instance.object)].content, instance.to_world);
}

Spectrum SceneChecks::highest_color(const Textured<Spectrum>& value) const {
  return value.is_constant() ? value.value : scene_.textures[index_of(value.map)].color_bounds().high;
}

void SceneChecks::check_lights() {
  bool any = !scene_.lights.empty() || scene_.environment;
  for_each_placed([&](const Shape& shape, const Place&, const Affine&) { any = any || shines(shape); });
  if (!any) warn(place_, "there is no light: no shape emits, and there are no 'lights'");
}

// kd and ks where textures may replace them, at their highest.
void SceneChecks::check_materials() {
  for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
    const Material& material = scene_.materials[i];
    if (material.bump_map.is_constant() && material.bump_map.value != 0)
      warn(scene_.material_places[i],
           fmt::format("material '{}': a bump map that is one number has no slope and no effect",
                       material.name));
    const auto* lobe = std::get_if<BlinnPhong>(&material.lobe);
    if (!lobe) continue;
    Textured<Spectrum> kd{lobe->kd}, ks{lobe->ks};
    for (const TexturedParameter& map : material.maps) {
      if (map.set == detail::set_from_texture<&BlinnPhong::kd>) kd.map = map.texture;
      if (map.set == detail::set_from_texture<&BlinnPhong::ks>) ks.map = map.texture;
    }
    const float sum = max_component(highest_color(kd) + highest_color(ks));
    const char* reach = kd.is_constant() && ks.is_constant() ? "is" : "may reach";
    if (sum > 1.0001f)
      warn(
          scene_.material_places[i],
          fmt::format(
              "material '{}': kd + ks {} {:.3g}; where it passes 1 both are scaled down so that no energy is "
              "made",
              material.name, reach, sum));
  }
}

// " 'name'", where it has one.
std::string called(const Material& material) {
  return material.name.empty() ? "" : fmt::format(" '{}'", material.name);
}

void SceneChecks::check_shape(const Shape& shape, const Place& place) {
  const Material& material = scene_.materials[index_of(shape.material)];
  const auto has_inside = [](const Material& part) {
    return part.parts.empty() && interior(part.lobe).has_value();
  };
  if (any_part(material, scene_.materials, has_inside)) {
    const auto* mesh = std::get_if<Mesh>(&shape.kind);
    const bool open = std::holds_alternative<Rectangle>(shape.kind) ||
                      std::holds_alternative<Disk>(shape.kind) ||
                      std::holds_alternative<Cylinder>(shape.kind);
    if (open || (mesh && !is_closed(*mesh)))
      warn(place, fmt::format("{} is of {}{} but is not closed: it has no inside", name_of(shape),
                              kind_of(material.lobe), called(material)));
  }
  check_textures(shape, place, material);
  if (shape.emits() && !shines(shape))
    warn(place, fmt::format("the emission of {} is black", name_of(shape)));
  if (shape.emits() && !material.is_opaque())
    warn(place, fmt::format("{} emits, but its material{} is not opaque", name_of(shape), called(material)));
}

// What the textures of a shape ask for and its mesh has not.
void SceneChecks::check_textures(const Shape& shape, const Place& place, const Material& material) {
  const auto* mesh = std::get_if<Mesh>(&shape.kind);
  if (!mesh) return;
  unsigned needs = 0;
  for_each_part(material, scene_.materials,
                [&](const Material& part) { needs |= part.needs(scene_.textures); });
  if (!shape.emission.is_constant()) needs |= scene_.textures[index_of(shape.emission.map)].needs();
  const auto lacks = [&](const char* what, const char* instead) {
    warn(place, fmt::format("{} has no {}, which textures of '{}' ask for: {}", name_of(shape), what,
                            material.name, instead));
  };
  if ((needs & texture_needs::color) != 0 && mesh->colors.empty()) lacks("vertex colours", "they are white");
  if ((needs & texture_needs::uv1) != 0 && mesh->uvs1.empty()) lacks("second uv", "the first is used");
  if ((material.has_normal_map() || material.has_clearcoat_normal_map()) && mesh->uvs.empty())
    lacks("uv", "the normal map lies on each of its triangles anew");
}

void SceneChecks::check_camera(const Shape& shape, const Place& place, const Affine& to_world) {
  if (!scene_.has_camera) return;
  const Affine map = to_world * shape.to_world;
  const Vec3d eye(scene_.camera.position);
  const bool inside = std::visit(
      [&](const auto& kind) {
        using Kind = std::decay_t<decltype(kind)>;
        if constexpr (std::is_same_v<Kind, Mesh>) {
          return holds(bounds_of(shape, to_world), eye) && encloses(kind, inverse(map).point(eye));
        } else if constexpr (std::is_same_v<Kind, Box>) {
          return holds({Vec3d(kind.low), Vec3d(kind.high)}, inverse(map).point(eye));
        } else if constexpr (std::is_same_v<Kind, Sphere>) {
          return glm::length(inverse(map * kind.placement()).point(eye)) < 1;
        } else if constexpr (std::is_same_v<Kind, Torus>) {
          const Vec3d p = inverse(map).point(eye);
          const double from_ring = glm::length(glm::dvec2(p)) - static_cast<double>(kind.major_radius);
          return glm::length(glm::dvec2(from_ring, p.z)) < static_cast<double>(kind.minor_radius);
        } else {
          return false;
        }
      },
      shape.kind);
  if (inside) warn(place, fmt::format("the camera is inside {}", name_of(shape)));
}

// Points are exact to 32 units in the last place of their coordinates (surface_error()). A simple shape bears
// an error of a hundredth of its size; what a mesh shows is finer than the mesh.
void SceneChecks::check_distance(const Shape& shape, const Place& place, const Affine& to_world) {
  const Bounds bounds = bounds_of(shape, to_world);
  const Vec3d far = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
  const double reach = std::max({far.x, far.y, far.z}), error = 32 * 0x1p-23 * reach;
  numbers_.add(shape, place, reach);
  const double share = error / glm::length(bounds.high - bounds.low);
  if (!(share > (std::holds_alternative<Mesh>(shape.kind) ? 1e-3 : 1e-2))) return;
  if (!far_.is_first()) return;
  far_.place = place;
  far_.example =
      fmt::format("{} is so far from the origin that its points are exact only to {:.2g} of its size",
                  name_of(shape), share);
}

}  // namespace

void check_scene(SceneBuilder& scene, const Place& place) { SceneChecks(scene, place).run(); }

}  // namespace umbral
