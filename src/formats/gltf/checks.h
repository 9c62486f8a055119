// What glTF demands of objects together: accessors within buffers, trees of nodes, attributes that fit.
#pragma once

#include "formats/gltf/document.h"
#include "formats/gltf/report.h"

namespace umbral::gltf {

// The structure, without reading the numbers of any accessor. Reported as errors where the image would be wrong or
// undefined, else as warnings. References must be valid.
void check_document(const Document& document, Report& report);

// Parts of it.
void check_data(const Document& document, Report& report);    // buffer views and accessors
void check_meshes(const Document& document, Report& report);  // primitives and what their attributes are
void check_nodes(const Document& document, Report& report);   // hierarchy, transforms, skins, scenes
void check_looks(const Document& document, Report& report);   // materials, textures, images, cameras, lights

}  // namespace umbral::gltf
