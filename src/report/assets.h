// The styles and scripts of the pages: the text of the files in assets/, built into the program by umbral_embed().
#pragma once

#include <string_view>

namespace umbral::assets {

extern const std::string_view page_css;  // of every page
extern const std::string_view compare_css;
extern const std::string_view compare_js;
extern const std::string_view plot_css;
extern const std::string_view plot_js;

}  // namespace umbral::assets
