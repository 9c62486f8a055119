// The closed list of textures: functions of a surface's point that a material's parameter or an emission takes.
#pragma once

#include <span>
#include <string>
#include <variant>

#include "scene/ids.h"
#include "scene/textures/checker.h"
#include "scene/textures/direction_texture.h"
#include "scene/textures/image_texture.h"
#include "scene/textures/marble_texture.h"
#include "scene/textures/mix_texture.h"
#include "scene/textures/noise_texture.h"
#include "scene/textures/projected_texture.h"
#include "scene/textures/ramp_texture.h"
#include "scene/textures/scale_texture.h"
#include "scene/textures/stone_texture.h"
#include "scene/textures/vertex_color.h"
#include "scene/textures/wood_texture.h"

namespace umbral {

// A new texture joins here.
using TextureKinds = std::variant<ImageTexture, CheckerTexture, ScaleTexture, MixTexture, RampTexture,
                                  ProjectedTexture, DirectionTexture, VertexColorTexture, NoiseTexture,
                                  MarbleTexture, WoodTexture, StoneTexture>;

struct Texture {
  std::string name;
  TextureKinds kind;

  // To be called once, before anything else. `textures` holds those that this one is made from, by their id and
  // prepared: a texture can be made only from those before it.
  void prepare(std::span<const Texture> textures = {});

  Spectrum color(const TexturePoint& point) const;
  float number(const TexturePoint& point) const;  // the chosen channel
  TextureBounds color_bounds() const;
  Range number_bounds() const;

  unsigned needs() const;    // of texture_needs
  TextureStep step() const;  // for slopes
  // The uv that its picture lies in: that of the set it uses, placed. Linear but for an offset.
  Vec2 placed(const TexturePoint& point) const;
};

}  // namespace umbral
