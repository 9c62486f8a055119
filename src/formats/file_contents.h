// What a file is that does not hold what its name says.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace umbral {

// What is wrong with a scene file as far as its first bytes tell, for the kind that its name says: text in UTF-16; XML, JSON or
// a binary glTF under another name; a directory, with the scenes in it; that it is not there. None where nothing is, or where it
// cannot be told: of pipes and packed files.
std::optional<std::string> fault_of_contents(const std::filesystem::path& path);

}  // namespace umbral
