// Page: one HTML file that holds all it shows and asks nothing of any network.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace umbral {

/// What a page is made of. Styles and scripts are those of assets.h; page_css comes first, by itself.
struct Page {
  std::string title;
  std::string body;       // HTML
  std::string data = {};  // JSON; scripts find it in the element #data; empty: none
  std::vector<std::string_view> styles = {};
  std::vector<std::string_view> scripts = {};  // run in this order, after the body is there
};

/// The file. Its content security policy forbids the browser every request but to data: and blob: images, so that
/// opening it reaches nothing outside of it.
std::string html(const Page& page);

/// `text` as HTML that shows it, in content and in quoted attributes.
std::string html_text(std::string_view text);

/// Writes html(page), whole or not at all. Throws OutputError.
void write_page(const std::string& path, const Page& page);

}  // namespace umbral
