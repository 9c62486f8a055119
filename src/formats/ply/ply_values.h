// The numbers in the body of a PLY file, one after the other.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

#include "formats/ply/ply_header.h"

namespace umbral {

// Both kinds of values have
//   bool next(PlyType, double&)   false where the file ends or holds no number there
//   void fail(message)            throws SceneError that tells where the last number was

class AsciiPlyValues {
 public:
  AsciiPlyValues(const TextCursor& in, const std::shared_ptr<const SourceText>& source)
      : in_(in), source_(source) {}

  bool next(PlyType, double& value) {
    while (in_.at_line_end() && !in_.at_end()) in_.next_line();
    last_ = in_.position();
    return in_.number(value);
  }

  [[noreturn]] void fail(std::string message) const {
    throw_at(source_, in_.line(), in_.column(last_), std::move(message));
  }

 private:
  TextCursor in_;
  const std::shared_ptr<const SourceText>& source_;
  const char* last_ = in_.position();
};

template <std::endian file_order>
class BinaryPlyValues {
 public:
  BinaryPlyValues(const TextCursor& in, const std::shared_ptr<const SourceText>& source)
      : p_(in.position()), end_(source->text().data() + source->text().size()), source_(source) {}

  bool next(PlyType type, double& value) {
    switch (type) {
      case PlyType::int8:
        return get<std::int8_t, std::uint8_t>(value);
      case PlyType::uint8:
        return get<std::uint8_t, std::uint8_t>(value);
      case PlyType::int16:
        return get<std::int16_t, std::uint16_t>(value);
      case PlyType::uint16:
        return get<std::uint16_t, std::uint16_t>(value);
      case PlyType::int32:
        return get<std::int32_t, std::uint32_t>(value);
      case PlyType::uint32:
        return get<std::uint32_t, std::uint32_t>(value);
      case PlyType::float32:
        return get<float, std::uint32_t>(value);
      case PlyType::float64:
        return get<double, std::uint64_t>(value);
    }
    return false;
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw_at(source_, 0, 0, message + " (byte " + std::to_string(last_ - source_->text().data()) + ")");
  }

 private:
  template <class Bits>
  static Bits swapped(Bits bits) {
    Bits result = 0;
    for (std::size_t i = 0; i < sizeof(Bits); ++i, bits = static_cast<Bits>(bits >> 7 >> 1))
      result = static_cast<Bits>(result << 7 << 1 | (bits & 0xff));
    return result;
  }

  template <class T, class Bits>
  bool get(double& value) {
    last_ = p_;
    if (static_cast<std::size_t>(end_ - p_) < sizeof(Bits)) return false;
    Bits bits = 0;
    std::memcpy(&bits, p_, sizeof(Bits));
    p_ += sizeof(Bits);
    if constexpr (file_order != std::endian::native) bits = swapped(bits);
    value = static_cast<double>(std::bit_cast<T>(bits));
    return true;
  }

  const char* p_;
  const char* end_;
  const char* last_ = p_;
  const std::shared_ptr<const SourceText>& source_;
};

}  // namespace umbral
