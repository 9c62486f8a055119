// Settings given outside of a scene file, written and checked as those within one.
#pragma once

#include <functional>
#include <string>

#include "scene/parameter_visitor.h"

namespace umbral {

/// Reads lines "name = value", as the table of `owner` in a scene file holds them, into whatever `describe` shows the
/// visitor. `source` is what messages call the text. Throws SceneError with every error found.
void read_settings(const std::string& source, const std::string& owner, const std::string& text,
                   const std::function<void(ParameterVisitor&)>& describe);

}  // namespace umbral
