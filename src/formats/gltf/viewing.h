// Lights and cameras of a glTF file.
#pragma once

#include "formats/assembly/scene_builder.h"
#include "formats/gltf/document.h"
#include "formats/gltf/report.h"

namespace umbral::gltf {

// A light of KHR_lights_punctual, whose node stands at `to_world` and shines along its −z.
void add_light(const PunctualLight& light, const Affine& to_world, SceneBuilder& builder, Report& report);

// The camera of that node; the first of a scene is its own, if it has none yet.
void add_camera(const Document& document, std::uint32_t node, const Affine& to_world, SceneBuilder& builder,
                Report& report);

}  // namespace umbral::gltf
