// What materials may be made of, and how those of other formats are mixed.
#pragma once

#include <optional>
#include <string>

#include "formats/assembly/scene_builder.h"

namespace umbral {

// What is wrong with the parts of `material`, which are among `materials`; none where it has no parts, or good ones:
// 16 lobes at most, none with an opacity, back side, normal or bump map of its own, none that lets light through under a
// coat, and in a mix none whose inside is another than that of the others.
std::optional<std::string> fault_of_parts(const Material& material, const std::vector<Material>& materials);

// a with the weight 1 − amount and b with the weight amount, both added to the builder. Opacity, back side, normal and bump
// maps are the mix's if both have the same; else the builder is told that umbral lacks this.
Material mix_of(SceneBuilder& builder, Material a, Material b, const Textured<float>& amount,
                const Place& place);

// The material where it is there with a chance of `share` alone; of 1 − share if `inverted`.
Material partly_there(SceneBuilder& builder, Material material, const Textured<float>& share, bool inverted,
                      const Place& place);

}  // namespace umbral
