// Looks: glTF materials as materials of a scene.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "formats/assembly/inclusion.h"
#include "formats/assembly/scene_builder.h"
#include "formats/gltf/document.h"
#include "formats/gltf/report.h"
#include "formats/gltf/texture_table.h"

namespace umbral::gltf {

// What the shapes of a primitive get.
struct Look {
  MaterialId material = MaterialId::none;
  Textured<Spectrum> emission{black};
  bool two_sided = false;
};

class Looks {
 public:
  Looks(const Document& document, SceneBuilder& builder, const std::filesystem::path& folder,
        const MaterialOverrides& overrides, Report& report);

  // Has the images decoded that of() will ask for.
  void expect_images(Ref<List::materials> ref);

  // Of the primitive's material, made once however often it is asked for.
  const Look& of(const Primitive& primitive);

  // Of the materials that were asked for.
  const std::set<std::string>& names() const { return names_; }

 private:
  Look converted(Ref<List::materials> ref, bool vertex_colors);

  const Document& document_;
  SceneBuilder& builder_;
  const MaterialOverrides& overrides_;
  Report& report_;
  TextureTable textures_;
  std::map<std::pair<std::uint32_t, bool>, Look> looks_;
  std::set<std::string> names_;
};

}  // namespace umbral::gltf
