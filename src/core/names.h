// Finding the name that a user probably meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace umbral {

// The candidate nearest to `name` by edit distance (insert, delete, replace, swap neighbours), if it is near
// enough to have been meant: at most a third of its length away. Empty if none is.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

// "; did you mean 'roughness'?" for nearest_name(), or, where none is near, "; known are 'a', 'b' and 'c'".
std::string suggestion(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace umbral
