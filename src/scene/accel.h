// Accel: Embree's bounding volume hierarchy over a Geometry.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/ray.h"
#include "scene/geometry.h"

namespace umbral {

class Accel {
 public:
  // Builds in parallel. Everything passed must outlive it and keep its place in memory: Embree reads the vertices
  // where they are. Throws std::runtime_error where Embree runs out of memory.
  Accel(const Geometry& geometry, const std::vector<Material>& materials,
        const std::vector<Texture>& textures);
  ~Accel();
  Accel(const Accel&) = delete;
  Accel& operator=(const Accel&) = delete;

  std::optional<Hit> intersect(const Ray& ray) const;
  bool occluded(const Ray& ray) const;

  Bounds bounds() const;      // of the world; low > high where it is empty
  std::size_t bytes() const;  // that Embree holds

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace umbral
