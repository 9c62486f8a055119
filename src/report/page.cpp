// The frame of a page.
#include "report/page.h"

#include <fmt/format.h>

#include "image/atomic_file.h"
#include "report/assets.h"

namespace umbral {
namespace {

constexpr std::string_view policy =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data: blob:; "
    "base-uri 'none'; form-action 'none'";

// JSON whose text cannot end the element that holds it: "<" only stands within strings, where it may be escaped.
std::string json_in_html(std::string_view json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json)
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text) switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  return escaped;
}

std::string html(const Page& page) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>\n{}",
      policy, html_text(page.title), assets::page_css);
  for (const std::string_view style : page.styles) text += style;
  text += "</style>\n</head>\n<body>\n" + page.body;
  if (!page.data.empty())
    text += "\n<script type=\"application/json\" id=\"data\">" + json_in_html(page.data) + "</script>";
  for (const std::string_view script : page.scripts)
    text.append("\n<script>\n").append(script).append("</script>");
  return text + "\n</body>\n</html>\n";
}

void write_page(const std::string& path, const Page& page) { write_file(path, html(page)); }

}  // namespace umbral
