// Conversion of shapes: their kind, their side and what they emit.
#include "formats/pbrt/shapes.h"

#include <fmt/format.h>

#include "formats/assembly/place_shape.h"
#include "formats/meshes/mesh_facing.h"

namespace umbral::pbrt_file {
namespace {

// The area of a shape as it stands in the world; none where it is stretched by different factors.
std::optional<double> placed_area(const Shape& shape) {
  return std::visit(
      [&](const auto& kind) -> std::optional<double> {
        if constexpr (requires { kind.placement(); }) {
          const glm::dmat3 m = shape.to_world.linear * kind.placement().linear;
          const double s = glm::length(m[0]);
          if (std::abs(glm::length(m[1]) - s) > 1e-5 * s || std::abs(glm::length(m[2]) - s) > 1e-5 * s)
            return std::nullopt;
          return kind.area() * s * s;
        } else if constexpr (requires { kind.area(); }) {
          return kind.area();
        } else {
          return std::nullopt;
        }
      },
      shape.kind);
}

Mesh one_triangle(const Mesh& mesh, const glm::uvec3& t) {
  Mesh one;
  for (int k = 0; k < 3; ++k) {
    one.positions.push_back(mesh.positions[t[k]]);
    if (!mesh.normals.empty()) one.normals.push_back(mesh.normals[t[k]]);
    if (!mesh.uvs.empty()) one.uvs.push_back(mesh.uvs[t[k]]);
  }
  one.triangles = {{0, 1, 2}};
  return one;
}

}  // namespace

void Shapes::add(const std::string& kind, const Parameters& parameters, const Surroundings& around,
                 ShapeList& shapes) {
  std::optional<ShapeKinds> read = this->read(kind, parameters);
  const Textured<float> alpha = textures_.number(parameters, "alpha", 1);
  parameters.report_unknown(fmt::format("shape '{}'", kind));
  if (!read) return;
  if (Materials::is_interface(*around.material)) {
    // Light passes; a surface that shines is beyond that.
    if (!around.light.is_dark()) builder_.lacks(parameters.place(), "an emitter that light passes through");
    if (around.inside)
      builder_.lacks(parameters.place(),
                     fmt::format("the medium '{}' without a surface", around.inside->name));
    return;
  }
  Shape shape{"", std::move(*read), around.to_world,
              materials_.convert(around.material, alpha, around.inside.get(), parameters.place())};
  if (around.reversed) reverse(shape, parameters, around.light);
  if (auto* mesh = std::get_if<Mesh>(&shape.kind)) {
    mesh->transform(shape.to_world);
    shape.to_world = Affine{};
    if (around.light.power > 0) return place_by_triangles(std::move(shape), parameters, around.light, shapes);
  }
  place(std::move(shape), parameters, around.light, shapes);
}

void Shapes::place(Shape shape, const Parameters& parameters, const AreaLight& light, ShapeList& shapes) {
  shine(shape, parameters, light);
  if (const auto fault = place_shape(std::move(shape), parameters.place(), builder_.diagnostics, shapes))
    builder_.diagnostics.error(parameters.place(), fault->message);
}

// To pbrt each triangle is a light of its own, and so each has the power.
void Shapes::place_by_triangles(Shape shape, const Parameters& parameters, const AreaLight& light,
                                ShapeList& shapes) {
  const Mesh mesh = std::move(std::get<Mesh>(shape.kind));
  for (const glm::uvec3& triangle : mesh.triangles) {
    Shape part{"", one_triangle(mesh, triangle), Affine{}, shape.material};
    if (std::get<Mesh>(part.kind).area() > 0) place(std::move(part), parameters, light, shapes);
  }
}

// Φ = π A L of one side [its luminance being that of L = 1, as pbrt-v4 counts it].
void Shapes::shine(Shape& shape, const Parameters& parameters, const AreaLight& light) {
  shape.emission = light.emission;
  shape.two_sided = light.two_sided && shape.emits();
  if (!(light.power > 0)) return;
  const std::optional<double> area = placed_area(shape);
  if (!area) return builder_.lacks(parameters.place(), "the power of a shape that its transform stretches");
  const double sides = light.two_sided ? 2 : 1;
  const auto factor = static_cast<float>(light.power / (sides * pi_d * *area * light.mean_luminance));
  shape.emission.value *= factor;
  if (shape.emission.is_constant()) return;
  Texture scaled = builder_.textures[index_of(shape.emission.map)];
  std::get<ImageTexture>(scaled.kind).factor *= factor;
  shape.emission.map = builder_.add(std::move(scaled));
}

// Meshes and disks can be turned; a sphere's inside cannot become its outside, which matters to light and glass alone.
void Shapes::reverse(Shape& shape, const Parameters& parameters, const AreaLight& light) {
  const auto is_glass = [](const Material& part) { return std::holds_alternative<Dielectric>(part.lobe); };
  if (auto* mesh = std::get_if<Mesh>(&shape.kind)) {
    turn_inside_out(*mesh);
  } else if (std::holds_alternative<Disk>(shape.kind)) {
    shape.to_world = shape.to_world * translation(Vec3d(std::get<Disk>(shape.kind).center)) *
                     scaling({1, 1, -1}) * translation(-Vec3d(std::get<Disk>(shape.kind).center));
  } else if (any_part(builder_.materials[index_of(shape.material)], builder_.materials, is_glass) ||
             !light.is_dark()) {
    builder_.lacks(parameters.place(), "a round shape whose inside is its outside");
  }
}

}  // namespace umbral::pbrt_file
