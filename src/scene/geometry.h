// Geometry: the shapes of a scene sorted for tracing, and the way from a hit back to a surface.
#pragma once

#include <variant>
#include <vector>

#include "scene/local_chart.h"
#include "scene/material.h"
#include "scene/shapes/shapes.h"
#include "scene/surface.h"
#include "scene/traced_mesh.h"

namespace umbral {

struct SceneDescription;

// An analytic shape with its canonical space placed in its group.
struct PlacedShape {
  AnalyticShape shape;
  Affine to_group, from_group;
};

// One geometry of a group: a mesh or an analytic shape, the other index being no_index.
struct Piece {
  std::uint32_t mesh = no_index;
  std::uint32_t analytic = no_index;
  MaterialId material = MaterialId::none;
  std::uint32_t emitter = no_index;  // its number among the group's emitting pieces
  unsigned needs = 0;                // of its textures, beside uv (texture_needs)
  unsigned detail = 0;               // of its material (surface_detail)
};

struct Group {
  std::vector<Piece> pieces;
};

// One place of a group other than the world.
struct Placement {
  std::uint32_t group;
  Affine to_world, from_world;
  std::uint32_t first_light;  // the light of the group's emitter 0, here
};

// What an emitting piece gives, until it becomes an AreaLight.
struct Emitter {
  std::uint32_t instance, group, piece;
  Textured<Spectrum> emission;
  bool two_sided;
  std::optional<Rectangle>
      rectangle;  // in group space; where the piece was one. Its triangles say where it faces
};

// Group 0 is the world; its pieces' emitters are the lights 0, 1, …
struct Geometry {
  std::vector<TracedMesh> meshes;
  std::vector<PlacedShape> analytics;
  std::vector<Group> groups;
  std::vector<Placement> instances;
  std::vector<Emitter> emitters;  // in the order of their lights

  const Piece& piece(std::uint32_t instance, std::uint32_t geometry) const {
    const std::uint32_t group = instance == no_index ? 0 : instances[instance].group;
    return groups[group].pieces[geometry];
  }
  const Piece& piece(const Hit& hit) const { return piece(hit.instance, hit.geometry); }

  // `hit` must have come from `ray`.
  Surface surface(const Ray& ray, const Hit& hit) const;

  // Around the hit; textures see in it what the piece's `needs` say.
  LocalChart chart(const Ray& ray, const Hit& hit) const;
};

// Moves the shapes out of the description; meshes are transformed to their group.
Geometry sorted_geometry(SceneDescription& description);

}  // namespace umbral
