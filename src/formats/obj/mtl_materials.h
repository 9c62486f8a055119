// MTL materials as materials of ours.
#pragma once

#include <filesystem>

#include "formats/assembly/scene_builder.h"
#include "formats/obj/mtl_reader.h"

namespace umbral {

// What an MTL material becomes:
//   dielectric   where 'illum' is 6 or 7 (refraction) and Ni > 1, or 4 or 9 (glass) and some light also passes (d,
//                Tr, Tf); clear but for the hue of Tf: Fresnel's equations say how much is reflected
//   mirror       where 'illum' is 3 or 5 (ray-traced reflection) and Ks outshines Kd; reflects Ks
//   principled   where one of Pr Pm Ps Pc Pcr aniso anisor is given, or a map of them
//   blinn_phong  where Ks is not black and 'illum' not 0 or 1
//   matte        else; Ka has no part in it
// d or Tr, map_d or the alpha of map_Kd give its opacity, norm and bump its normals. A map is multiplied by the colour that
// it belongs to. All that is approximated or left out is told in one warning a material.
struct MtlLook {
  MaterialId material;
  Textured<Spectrum> emission{black};
};

// Has the builder expect the images that look_of() will ask for.
void expect_images(const MtlMaterial& mtl, std::optional<MaterialId> override, SceneBuilder& builder,
                   const std::filesystem::path& folder);

// Texture files are relative to `folder`. Where `override` stands in for the material only its emission is
// read.
MtlLook look_of(const MtlMaterial& mtl, std::optional<MaterialId> override, SceneBuilder& builder,
                const std::filesystem::path& folder);

}  // namespace umbral
