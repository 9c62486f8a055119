// Excerpts of source texts.
#include "formats/input/source_text.h"

#include <algorithm>

namespace umbral {
namespace {

bool starts_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

// The byte at which character `count` (from 0) starts, or the text's end.
std::size_t byte_of_character(std::string_view text, std::size_t count) {
  std::size_t byte = 0;
  for (; byte < text.size(); ++byte)
    if (starts_character(text[byte]) && count-- == 0) return byte;
  return byte;
}

}  // namespace

std::size_t characters_in(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts_character));
}

std::string_view SourceText::line_text(int line) const {
  if (line_starts_.empty()) {
    line_starts_.push_back(0);
    for (std::size_t i = 0; i < text_.size(); ++i)
      if (text_[i] == '\n') line_starts_.push_back(i + 1);
  }
  const auto index = static_cast<std::size_t>(line - 1);
  if (line < 1 || index >= line_starts_.size()) return {};
  const std::size_t end = index + 1 < line_starts_.size() ? line_starts_[index + 1] - 1 : text_.size();
  std::string_view content = std::string_view(text_).substr(line_starts_[index], end - line_starts_[index]);
  if (content.ends_with('\r')) content.remove_suffix(1);
  return content;
}

std::string SourceText::excerpt(int line, int column) const {
  constexpr std::size_t widest = 100, before_caret = 60;
  if (line < 1 || column < 1) return {};
  std::string_view content = line_text(line);
  auto caret = static_cast<std::size_t>(column);
  if (characters_in(content) > widest) {
    const std::size_t skipped = caret > before_caret ? caret - before_caret : 0;
    content.remove_prefix(byte_of_character(content, skipped));
    content = content.substr(0, byte_of_character(content, widest));
    caret -= skipped;
  }
  std::string text(static_cast<std::size_t>(line - 1), '\n');  // so that the line keeps its number
  text += content;
  std::replace_if(
      text.begin() + (line - 1), text.end(), [](char c) { return c >= 0 && c < ' ' && c != '\t'; }, ' ');
  return excerpt_with_caret(text, line, static_cast<int>(caret));
}

}  // namespace umbral
