// Placing and mending of shapes.
#include "formats/assembly/place_shape.h"

#include <fmt/format.h>

#include "formats/meshes/mesh_cleanup.h"

namespace umbral {

std::optional<ShapeFault> place_shape(Shape shape, const Place& place, Diagnostics& diagnostics,
                                      ShapeList& shapes) {
  if (auto* mesh = std::get_if<Mesh>(&shape.kind)) {
    mesh->transform(shape.to_world);
    shape.to_world = Affine{};
    if (!has_finite_positions(*mesh))
      return ShapeFault{"transform", "the mesh is too large or too far away for floating-point numbers"};
    const std::string repairs = clean(*mesh).text();
    const std::string of = shape.name.empty() ? "" : fmt::format(" '{}'", shape.name);
    if (!repairs.empty()) diagnostics.warning(place, fmt::format("mesh{}: {}", of, repairs));
  }
  if (auto fault = fault_of(shape)) return fault;
  shapes.add(std::move(shape), place);
  return std::nullopt;
}

}  // namespace umbral
