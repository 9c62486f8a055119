// SourceText: the text of an input file, and places in it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace umbral {

class SourceText {
 public:
  SourceText(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {}

  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }

  // Line `line` with a caret under character `column`, both counted from 1; long lines are cut around the
  // caret.
  std::string excerpt(int line, int column) const;

 private:
  std::string_view line_text(int line) const;

  std::string name_;
  std::string text_;
  mutable std::vector<std::size_t> line_starts_;  // made at the first excerpt
};

// Where something was said; `source` is null where there is no text to show.
struct Place {
  Where where;
  std::shared_ptr<const SourceText> source = nullptr;

  std::string excerpt() const { return source ? source->excerpt(where.line, where.column) : std::string(); }
};

// Characters (not bytes) of UTF-8 text.
std::size_t characters_in(std::string_view text);

}  // namespace umbral
