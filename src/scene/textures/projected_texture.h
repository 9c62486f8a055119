// Another texture, laid through the space of the object by a plane, a cylinder or a sphere.
#pragma once

#include <array>
#include <tuple>

#include "scene/textures/texture_input.h"

namespace umbral {

enum class Projection { planar, cylindrical, spherical };

template <>
struct EnumNames<Projection> {
  static constexpr std::array names{"planar", "cylindrical", "spherical"};
};

// The place q of a point has as its coordinates the scalar products of x, y and z with the way from `origin`. The texture is
// looked up at the uv of q:
//   planar       (q.x, q.y)
//   cylindrical  (φ/2π, q.y)
//   spherical    (φ/2π, 1 − θ/π)
// φ is the angle about +y from +z towards +x, in [0, 2π), θ that from +y: seen from outside u grows to the right and v upwards.
struct ProjectedTexture {
  Textured<Spectrum> texture{grey(1)};
  Projection projection = Projection::planar;
  Vec3 origin{0, 0, 0};
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  static constexpr const char* kind = "projected";
  static constexpr const char* doc =
      "another texture, laid through the space of the object (of the world where nothing is instanced) "
      "instead of in uv";
  static constexpr auto parameters = std::tuple{
      parameter<&ProjectedTexture::texture>("texture", "what is laid so"),
      parameter<&ProjectedTexture::projection>(
          "projection", "along z; onto a cylinder about y; from the origin onto a sphere, poles on y"),
      parameter<&ProjectedTexture::origin>("origin", "where x, y and z start, object"),
      parameter<&ProjectedTexture::x>("x",
                                      "an axis, object; twice as long, it makes the picture half as wide"),
      parameter<&ProjectedTexture::y>("y", "likewise, upwards in the picture"),
      parameter<&ProjectedTexture::z>("z", "likewise; in front of the picture's left and right edge")};

  TextureInput texture_input{};

  void prepare(std::span<const Texture> textures) { texture_input = TextureInput(texture, textures); }
  Spectrum evaluate(const TexturePoint& point) const { return texture_input.color(laid(point)); }
  float number(const TexturePoint& point) const { return texture_input.number(laid(point)); }
  TextureBounds bounds() const { return texture_input.color_bounds(); }
  Range number_bounds() const { return texture_input.number_bounds(); }
  unsigned needs() const;
  TextureStep step() const;
  Vec2 placed(const TexturePoint& point) const { return texture_input.placed(laid(point)); }

  // Whether uv is not linear in the place, so that no one frame of it holds for a whole triangle.
  bool bends() const { return projection != Projection::planar; }

 private:
  // Both sets of uv are that of the projection. The widths of look-ups are not known in it: they are 0.
  TexturePoint laid(const TexturePoint& point) const;
};

}  // namespace umbral
