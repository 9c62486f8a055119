// Checks of each kind of shape.
#include "formats/assembly/shape_faults.h"

#include <fmt/format.h>

namespace umbral {
namespace {

std::optional<ShapeFault> own_fault(const Mesh& mesh) {
  if (mesh.triangles.empty()) return ShapeFault{"file", "the mesh has no triangle with an area"};
  return std::nullopt;
}

std::optional<ShapeFault> own_fault(const Rectangle& rectangle) {
  if (cross(Vec3d(rectangle.edge_u), Vec3d(rectangle.edge_v)) != Vec3d(0)) return std::nullopt;
  return ShapeFault{"edge_v", "'edge_u' and 'edge_v' of 'rectangle' are parallel: it has no area"};
}

std::optional<ShapeFault> own_fault(const Box& box) {
  for (int i = 0; i < 3; ++i)
    if (!(box.low[i] < box.high[i]))
      return ShapeFault{
          "high", fmt::format("'high' of 'box' must be above 'low' in {}: it is {} and 'low' is {}", "xyz"[i],
                              box.high[i], box.low[i])};
  return std::nullopt;
}

std::optional<ShapeFault> own_fault(const Disk& disk) {
  if (disk.normal != Vec3(0)) return std::nullopt;
  return ShapeFault{"normal", "'normal' of 'disk' has no direction"};
}

std::optional<ShapeFault> own_fault(const Cylinder& cylinder) {
  if (cylinder.top != cylinder.bottom) return std::nullopt;
  return ShapeFault{"top", "'top' of 'cylinder' is its 'bottom': it has no axis"};
}

std::optional<ShapeFault> own_fault(const Sphere&) { return std::nullopt; }
std::optional<ShapeFault> own_fault(const Torus&) { return std::nullopt; }

bool stands_well(const Mesh& mesh) {
  const double area = mesh.area();
  return std::isfinite(area) && area > 0;
}

// Whether the shape, put in its place, still has finite numbers and an area.
bool stands_well(const Shape& shape) {
  return std::visit(
      [&](const auto& kind) {
        if constexpr (ParametricShape<std::decay_t<decltype(kind)>>) {
          const Affine placed = shape.to_world * kind.placement();
          const Affine back = inverse(placed);
          const Vec3d sum = placed.offset + placed.linear * Vec3d(1) + back.linear * Vec3d(1);
          return std::isfinite(static_cast<float>(sum.x + sum.y + sum.z));
        } else if constexpr (requires { kind.triangulated(); }) {
          Mesh mesh = kind.triangulated();
          mesh.transform(shape.to_world);
          return stands_well(mesh);
        } else {
          return stands_well(kind);
        }
      },
      shape.kind);
}

}  // namespace

std::optional<ShapeFault> fault_of(const Shape& shape) {
  if (auto fault = std::visit([](const auto& kind) { return own_fault(kind); }, shape.kind)) return fault;
  if (stands_well(shape)) return std::nullopt;
  return ShapeFault{"transform",
                    "the shape is too small, too large or too far away for floating-point numbers"};
}

}  // namespace umbral
