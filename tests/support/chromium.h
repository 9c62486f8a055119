// Pages of the program opened in a headless Chromium.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace umbral::test {

/// The browser: the program that the environment variable UMBRAL_CHROMIUM names, else chromium, chromium-browser or
/// google-chrome on the path. Nothing if there is none:
///
///   if (!chromium()) GTEST_SKIP() << no_chromium;
std::optional<std::string> chromium();

inline constexpr const char* no_chromium =
    "no browser here: install the Debian package chromium, or set UMBRAL_CHROMIUM to its program";

/// What `script`, the body of an asynchronous JavaScript function, returns once the page is loaded. If it throws:
/// {"error": "…"}. Beside the page's own names it finds
///   requests    addresses that the page asked for, and was given or not
///   failures    texts of the errors that the page's own scripts threw
///   next_frame  () → a promise for the next drawn frame
nlohmann::json run_in_page(const std::filesystem::path& page, const std::string& script);

}  // namespace umbral::test
