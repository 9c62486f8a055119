// The colours that a mesh has at its vertices.
#pragma once

#include <tuple>

#include "scene/textures/texture_point.h"
#include "scene/textures/texture_value.h"

namespace umbral {

struct VertexColorTexture {
  TextureChannel channel = TextureChannel::luminance;

  static constexpr const char* kind = "vertex_color";
  static constexpr const char* doc =
      "the colours of a mesh's vertices, interpolated; white where it has none";
  static constexpr auto parameters = std::tuple{
      parameter<&VertexColorTexture::channel>("channel", "what a parameter that takes one number gets")};

  static void prepare() {}
  static Spectrum evaluate(const TexturePoint& point) { return point.color; }
  // Meshes keep their colours within these (Mesh::colors).
  static TextureBounds bounds() { return {Spectrum(0.0f), Spectrum(1.0f)}; }
  static unsigned needs() { return texture_needs::color; }
  static TextureStep step() { return {infinity, infinity, 1e-2f}; }
};

}  // namespace umbral
