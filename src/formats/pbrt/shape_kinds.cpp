// The geometry of each kind of shape in a pbrt file.
#include <stdexcept>

#include <fmt/format.h>

#include "formats/meshes/bilinear_patch.h"
#include "formats/meshes/loop_subdivision.h"
#include "formats/meshes/mesh_facing.h"
#include "formats/meshes/mesh_file.h"
#include "formats/pbrt/shapes.h"

namespace umbral::pbrt_file {
namespace {

std::vector<Vec3> vectors(const std::vector<double>& numbers) {
  std::vector<Vec3> result;
  result.reserve(numbers.size() / 3);
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    result.push_back(Vec3(numbers[i], numbers[i + 1], numbers[i + 2]));
  return result;
}

std::vector<Vec2> pairs(const std::vector<double>& numbers) {
  std::vector<Vec2> result;
  result.reserve(numbers.size() / 2);
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) result.push_back(Vec2(numbers[i], numbers[i + 1]));
  return result;
}

constexpr std::initializer_list<const char*> points{"point3", "point"}, normals{"normal", "normal3"},
    pairs_of{"point2", "vector2"};

// Positions, normals and uv; those that are not one a vertex are told and left out.
Mesh vertices_of(const Parameters& parameters) {
  Mesh mesh;
  mesh.positions = vectors(parameters.numbers("P", points, 3));
  mesh.normals = vectors(parameters.numbers("N", normals, 3));
  mesh.uvs = pairs(parameters.numbers("uv", pairs_of, 2));
  const auto check = [&](const char* name, auto& list) {
    if (list.empty() || list.size() == mesh.positions.size()) return;
    parameters.error(*parameters.find(name), fmt::format("there are {} of '{}' but {} of 'P'", list.size(),
                                                         name, mesh.positions.size()));
    list.clear();
  };
  check("N", mesh.normals);
  check("uv", mesh.uvs);
  parameters.ignore({"S", "faceIndices"});
  return mesh;
}

}  // namespace

std::optional<ShapeKinds> Shapes::read(const std::string& kind, const Parameters& parameters) {
  if (kind == "sphere") return sphere(parameters);
  if (kind == "disk") return disk(parameters);
  if (kind == "cylinder") return cylinder(parameters);
  if (kind == "trianglemesh") return triangle_mesh(parameters);
  if (kind == "plymesh") return ply_mesh(parameters);
  if (kind == "bilinearmesh") return bilinear_mesh(parameters);
  if (kind == "loopsubdiv") return subdivided(parameters);
  builder_.lacks(parameters.place(), fmt::format("a shape of type '{}'", kind));
  for (const char* name : {"P", "N", "uv", "indices", "radius"}) parameters.find(name);
  return std::nullopt;
}

double Shapes::radius(const Parameters& parameters) {
  const double radius = parameters.number("radius", 1);
  if (radius > 0) return radius;
  builder_.diagnostics.error(parameters.place(), "a radius must be above 0");
  return 1;
}

void Shapes::full_turn(const Parameters& parameters) {
  if (parameters.number("phimax", 360) < 360) parameters.lacks("phimax", "a part of a round shape");
}

std::optional<ShapeKinds> Shapes::sphere(const Parameters& parameters) {
  const double r = radius(parameters);
  full_turn(parameters);
  if (parameters.number("zmin", -r) > -r) parameters.lacks("zmin", "a part of a sphere");
  if (parameters.number("zmax", r) < r) parameters.lacks("zmax", "a part of a sphere");
  return Sphere{{0, 0, 0}, static_cast<float>(r)};
}

std::optional<ShapeKinds> Shapes::disk(const Parameters& parameters) {
  full_turn(parameters);
  if (parameters.number("innerradius", 0) > 0) parameters.lacks("innerradius", "a disk with a hole");
  return Disk{{0, 0, static_cast<float>(parameters.number("height", 0))},
              {0, 0, 1},
              static_cast<float>(radius(parameters))};
}

std::optional<ShapeKinds> Shapes::cylinder(const Parameters& parameters) {
  full_turn(parameters);
  const double low = parameters.number("zmin", -1), high = parameters.number("zmax", 1);
  return Cylinder{{0, 0, static_cast<float>(std::min(low, high))},
                  {0, 0, static_cast<float>(std::max(low, high))},
                  static_cast<float>(radius(parameters))};
}

// Empty where they are wrong, which is told.
std::vector<std::uint32_t> Shapes::indices(const Parameters& parameters, std::size_t vertices,
                                           std::size_t arity) {
  std::vector<std::uint32_t> result;
  const Parameter* found = parameters.find("indices", {"integer"}, 0);
  if (!found) {
    if (!parameters.has("indices") && vertices == arity)
      for (std::uint32_t i = 0; i < arity; ++i) result.push_back(i);
    else if (!parameters.has("indices"))
      builder_.diagnostics.error(parameters.place(), "the mesh wants \"integer indices\"");
    return result;
  }
  result.reserve(found->numbers.size());
  for (const double index : found->numbers) {
    if (!(index >= 0 && index < static_cast<double>(vertices) && index == std::floor(index))) {
      parameters.error(
          *found, fmt::format("index {} names no vertex: there are {}, numbered from 0", index, vertices));
      return {};
    }
    result.push_back(static_cast<std::uint32_t>(index));
  }
  if (result.size() % arity == 0) return result;
  parameters.error(*found, fmt::format("{} indices are no multiple of {}", result.size(), arity));
  return {};
}

std::optional<ShapeKinds> Shapes::triangle_mesh(const Parameters& parameters) {
  Mesh mesh = vertices_of(parameters);
  const std::vector<std::uint32_t> corners = indices(parameters, mesh.positions.size(), 3);
  if (corners.empty()) return std::nullopt;
  mesh.triangles.reserve(corners.size() / 3);
  for (std::size_t i = 0; i < corners.size(); i += 3)
    mesh.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  face_normals(mesh);
  return mesh;
}

std::optional<ShapeKinds> Shapes::ply_mesh(const Parameters& parameters) {
  parameters.lacks("displacement", "a displacement");
  parameters.ignore({"edgelength"});
  const Parameter* file = parameters.find("filename", {"string"}, 1);
  if (!file) {
    builder_.diagnostics.error(parameters.place(), "a mesh from a file wants a \"string filename\"");
    return std::nullopt;
  }
  const std::filesystem::path path = (folder_ / file->strings[0]).lexically_normal();
  std::optional<Mesh> mesh = read_mesh_file(builder_, path, file->place);
  if (!mesh) return std::nullopt;
  face_normals(*mesh);
  return std::move(*mesh);
}

std::optional<ShapeKinds> Shapes::bilinear_mesh(const Parameters& parameters) {
  parameters.lacks("emissionfilename", "an image that a patch emits");
  const Mesh control = vertices_of(parameters);
  const std::vector<std::uint32_t> corners = indices(parameters, control.positions.size(), 4);
  if (corners.empty()) return std::nullopt;
  std::vector<BilinearPatch> patches;
  bool curved = !control.normals.empty();
  for (std::size_t i = 0; i < corners.size(); i += 4) {
    BilinearPatch patch;
    patch.has_normals = !control.normals.empty();
    for (std::size_t k = 0; k < 4; ++k) {
      patch.corners[k] = control.positions[corners[i + k]];
      if (!control.uvs.empty()) patch.uvs[k] = control.uvs[corners[i + k]];
      if (patch.has_normals) patch.normals[k] = control.normals[corners[i + k]];
    }
    curved = curved || !patch.is_parallelogram();
    patches.push_back(patch);
  }
  const int steps = patches.size() > 4096 ? 4 : 16;
  Mesh mesh;
  for (const BilinearPatch& patch : patches) append_patch(mesh, patch, steps, curved);
  if (curved && control.normals.empty())
    builder_.diagnostics.warning(parameters.place(),
                                 fmt::format("patches that are no parallelograms become {0} × {0} pairs of "
                                             "triangles with the patches' own normals",
                                             steps));
  face_normals(mesh);
  return mesh;
}

std::optional<ShapeKinds> Shapes::subdivided(const Parameters& parameters) {
  Mesh control = vertices_of(parameters);
  const int levels = std::max(0, parameters.integer("levels", 3));
  parameters.ignore({"scheme"});
  const std::vector<std::uint32_t> corners = indices(parameters, control.positions.size(), 3);
  if (corners.empty()) return std::nullopt;
  for (std::size_t i = 0; i < corners.size(); i += 3)
    control.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  try {
    return loop_subdivided(control, levels);
  } catch (const std::invalid_argument& reason) {
    builder_.diagnostics.error(parameters.place(), reason.what());
    return std::nullopt;
  }
}

}  // namespace umbral::pbrt_file
