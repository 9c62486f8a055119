// Cutting a pbrt file into words.
#include "formats/pbrt/tokens.h"

#include <charconv>
#include <cmath>

namespace umbral::pbrt_file {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool ends_word(char c) { return is_space(c) || c == '"' || c == '[' || c == ']' || c == '#'; }

}  // namespace

Tokens::Tokens(std::shared_ptr<const SourceText> source)
    : source_(std::move(source)),
      p_(source_->text().data()),
      end_(source_->text().data() + source_->text().size()) {
  if (source_->text().starts_with("\xef\xbb\xbf")) p_ += 3;
}

void Tokens::skip_space() {
  for (; p_ != end_; ++p_) {
    if (*p_ == '\n') {
      ++line_;
    } else if (*p_ == '#') {
      while (p_ + 1 != end_ && p_[1] != '\n') ++p_;
    } else if (!is_space(*p_)) {
      return;
    }
  }
}

Token Tokens::quoted() {
  Token token{Token::Kind::string, {p_, 1}, line_};
  const char* begin = ++p_;
  while (p_ != end_ && *p_ != '"' && *p_ != '\n') ++p_;
  if (p_ == end_ || *p_ == '\n') {
    const Place at = place(token);
    throw SceneError({{Severity::error, at.where, "this string has no end in its line", at.excerpt()}});
  }
  token.text = {begin, p_};
  ++p_;
  return token;
}

Token Tokens::next() {
  skip_space();
  if (p_ == end_) return {Token::Kind::end, {end_, 0}, line_};
  if (*p_ == '"') return quoted();
  const char* begin = p_++;
  if (*begin == '[') return {Token::Kind::open, {begin, p_}, line_};
  if (*begin == ']') return {Token::Kind::close, {begin, p_}, line_};
  while (p_ != end_ && !ends_word(*p_)) ++p_;
  return {Token::Kind::word, {begin, p_}, line_};
}

Token Tokens::peek() {
  const char* p = p_;
  const int line = line_;
  const Token token = next();
  p_ = p;
  line_ = line;
  return token;
}

bool Tokens::number(double& value) {
  skip_space();
  if (p_ == end_) return false;
  const auto [end, failure] = std::from_chars(*p_ == '+' ? p_ + 1 : p_, end_, value);
  if (failure != std::errc() || (end != end_ && !ends_word(*end)) || !std::isfinite(value)) return false;
  p_ = end;
  return true;
}

Place Tokens::place(const Token& token) const {
  const char* begin = source_->text().data();
  const char* line = token.text.data();
  while (line != begin && line[-1] != '\n') --line;
  const int column = static_cast<int>(characters_in({line, token.text.data()})) + 1;
  return {{source_->name(), token.line, column}, source_};
}

}  // namespace umbral::pbrt_file
