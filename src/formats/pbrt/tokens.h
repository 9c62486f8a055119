// The words of a pbrt file: directives, quoted strings, numbers and brackets.
#pragma once

#include <memory>
#include <string_view>

#include "formats/input/source_text.h"

namespace umbral::pbrt_file {

struct Token {
  enum class Kind { end, word, string, open, close };
  Kind kind = Kind::end;
  std::string_view text;  // without quotes
  int line = 1;
};

class Tokens {
 public:
  explicit Tokens(std::shared_ptr<const SourceText> source);

  // Throws SceneError at a string without an end.
  Token next();
  Token peek();

  // Reads the next token if it is a number of finite value; nothing is read otherwise.
  bool number(double& value);

  Place place(const Token& token) const;

 private:
  void skip_space();
  Token quoted();

  std::shared_ptr<const SourceText> source_;
  const char* p_;
  const char* end_;
  int line_ = 1;
};

}  // namespace umbral::pbrt_file
