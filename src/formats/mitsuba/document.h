// A Mitsuba scene file with all that it includes, as a tree of elements.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "formats/assembly/scene_builder.h"

namespace umbral::mitsuba_file {

// Attributes have the values of <default> parameters in them; names are in snake_case, as Mitsuba 3 writes them.
struct Element {
  std::string tag;   // "shape", "float", …
  std::string type;  // the plugin of an object; empty where there is none
  std::string id, name;
  std::map<std::string, std::string> attributes;  // the others
  std::vector<Element> children;
  Place place;
};

struct Document {
  Element root;
  std::map<std::string, const Element*> by_id;
  std::vector<std::filesystem::path> folders;  // where files are looked for, the last one first
  Affine to_world = {};                        // from the document's own world

  // The file of that name in one of the folders, or in the first if it is in none.
  std::filesystem::path find(const std::string& name) const;
};

// Reads the file. `definitions` are values for its <default> parameters; one that no file declares is an error. What is
// wrong throws SceneError with its place.
Document read_document(SceneBuilder& builder, const std::filesystem::path& path,
                       const std::map<std::string, std::string>& definitions);

}  // namespace umbral::mitsuba_file
