// TextCursor: walks through a text word by word and knows the line and column.
#pragma once

#include <charconv>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include "formats/input/diagnostics.h"

namespace umbral {

// A byte order mark is skipped. Lines end with \n or \r\n; a backslash right before that joins the next line.
// '#' where a word could begin starts a comment.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text)
      : p_(text.data() + (text.starts_with("\xef\xbb\xbf") ? 3 : 0)),
        end_(text.data() + text.size()),
        line_start_(p_) {}

  bool at_end() const { return p_ == end_; }
  int line() const { return line_; }
  const char* position() const { return p_; }

  // Of the cursor's line; `at` lies in that line. Counts from 1.
  int column(const char* at) const {
    return at < line_start_ ? 1 : static_cast<int>(characters_in({line_start_, at})) + 1;
  }

  // Skips spaces; true if nothing is left in the line but a comment.
  bool at_line_end() {
    while (p_ != end_) {
      if (*p_ == ' ' || *p_ == '\t' || *p_ == '\r')
        ++p_;
      else if (*p_ != '\\' || !skip_joint())
        break;
    }
    return p_ == end_ || *p_ == '\n' || *p_ == '#';
  }

  void next_line() {
    const void* newline = p_ == end_ ? nullptr : std::memchr(p_, '\n', static_cast<std::size_t>(end_ - p_));
    p_ = newline ? static_cast<const char*>(newline) + 1 : end_;
    line_start_ = p_;
    ++line_;
  }

  // Up to the next space; empty at the end of the line.
  std::string_view word() {
    if (at_line_end()) return {};
    const char* begin = p_;
    while (p_ != end_ && !is_space(*p_)) ++p_;
    return {begin, p_};
  }

  // All that is left of the line, without spaces around it or a comment behind it.
  std::string_view rest_of_line() {
    if (at_line_end()) return {};
    const char* begin = p_;
    const char* last = p_;
    for (; p_ != end_ && *p_ != '\n'; ++p_) {
      if (*p_ == '#' && is_space(p_[-1])) break;
      if (!is_space(*p_)) last = p_ + 1;
    }
    return {begin, last};
  }

  // A decimal number, 'nan' and 'inf' among them; false, and nothing read, if the next word is none or is
  // beyond the range of double.
  bool number(double& value) {
    if (at_line_end()) return false;
    const char* begin = *p_ == '+' ? p_ + 1 : p_;
    const auto [end, failure] = std::from_chars(begin, end_, value);
    if (failure != std::errc() || (end != end_ && !is_space(*end))) return false;
    p_ = end;
    return true;
  }

  // A whole number; anything may follow it.
  bool integer(std::int64_t& value) {
    if (at_line_end()) return false;
    const char* begin = *p_ == '+' ? p_ + 1 : p_;
    const auto [end, failure] = std::from_chars(begin, end_, value);
    if (failure != std::errc()) return false;
    p_ = end;
    return true;
  }

  // Steps over `c` if it is next.
  bool skip(char c) {
    if (p_ == end_ || *p_ != c) return false;
    ++p_;
    return true;
  }

  bool at_word_end() const { return p_ == end_ || is_space(*p_); }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

  bool skip_joint() {
    const char* q = p_ + 1;
    if (q != end_ && *q == '\r') ++q;
    if (q == end_ || *q != '\n') return false;
    p_ = line_start_ = q + 1;
    ++line_;
    return true;
  }

  const char* p_;
  const char* end_;
  const char* line_start_;
  int line_ = 1;
};

// Tells the errors of one text file, but no more than the first twenty.
class TextErrors {
 public:
  TextErrors(Diagnostics& diagnostics, std::shared_ptr<const SourceText> source)
      : diagnostics_(diagnostics), source_(std::move(source)) {}

  Place place(int line, int column) const { return {{source_->name(), line, column}, source_}; }
  Place place(const TextCursor& cursor, const char* at) const {
    return place(cursor.line(), cursor.column(at));
  }
  // Without the text, so that it need not be kept.
  Place bare_place(int line) const { return {{source_->name(), line, 0}}; }

  void error(const Place& at, std::string message) {
    constexpr int most = 20;
    if (++count_ > most) return;
    if (count_ == most) message += " (what follows is not read)";
    diagnostics_.error(at, std::move(message));
    full_ = count_ == most;
  }
  void warning(const Place& at, std::string message) { diagnostics_.warning(at, std::move(message)); }

  bool any() const { return count_ > 0; }
  bool full() const { return full_; }  // reading on is of no use

 private:
  Diagnostics& diagnostics_;
  std::shared_ptr<const SourceText> source_;
  int count_ = 0;
  bool full_ = false;
};

}  // namespace umbral
