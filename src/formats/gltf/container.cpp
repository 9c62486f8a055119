// Chunks of .glb files [Khronos 2021, GLB File Format].
#include "formats/gltf/container.h"

#include <bit>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

namespace umbral::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF's binary numbers are little-endian");

constexpr std::uint32_t magic = 0x46546c67, json_type = 0x4e4f534a, binary_type = 0x004e4942;

std::uint32_t number_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + offset, sizeof(number));
  return number;
}

// Walks over the chunks; the first must be JSON, the second may be binary.
class Chunks {
 public:
  Chunks(std::string_view bytes, Report& report) : bytes_(bytes), report_(report) {}

  std::optional<Container> read() {
    if (!read_header()) return std::nullopt;
    Container container;
    for (int number = 0; at_ < bytes_.size(); ++number) {
      if (!read_chunk(number, container)) return std::nullopt;
    }
    return container;
  }

 private:
  bool refuse(const std::string& message) {
    report_.error("", message);
    return false;
  }

  bool read_header() {
    if (bytes_.size() < 12)
      return refuse(fmt::format("a .glb file begins with 12 bytes of header, but it has {}", bytes_.size()));
    if (number_at(bytes_, 0) != magic) return refuse("it does not begin with \"glTF\", as a .glb file does");
    const std::uint32_t version = number_at(bytes_, 4), length = number_at(bytes_, 8);
    if (version != 2) return refuse(fmt::format("it is of version {} of glTF's container, not 2", version));
    if (length < 20) return refuse(fmt::format("its header gives a length of {} bytes: too few", length));
    if (length > bytes_.size())
      return refuse(fmt::format("the file is cut: it has {} bytes of {}", bytes_.size(), length));
    if (length < bytes_.size())
      report_.warning("", fmt::format("{} bytes behind its end are not used", bytes_.size() - length));
    bytes_ = bytes_.substr(0, length);
    at_ = 12;
    return true;
  }

  bool read_chunk(int number, Container& container) {
    if (bytes_.size() - at_ < 8) return refuse(fmt::format("chunk {} is cut in its header", number));
    const std::uint32_t length = number_at(bytes_, at_), type = number_at(bytes_, at_ + 4);
    at_ += 8;
    if (length > bytes_.size() - at_)
      return refuse(
          fmt::format("chunk {} is cut: it has {} bytes of {}", number, bytes_.size() - at_, length));
    if (length % 4 != 0)
      return refuse(fmt::format("the length of chunk {}, {}, is no multiple of 4", number, length));
    const std::string_view content = bytes_.substr(at_, length);
    at_ += length;
    if (number == 0 && type != json_type) return refuse("its first chunk is not JSON");
    if (number == 0 && content.empty()) return refuse("its chunk of JSON is empty");
    if (number == 0) {
      container.json = content;
    } else if (type == json_type || (type == binary_type && container.binary)) {
      return refuse(fmt::format("chunk {} is another of the kind that there can be one of", number));
    } else if (type == binary_type && number > 1) {
      return refuse("the chunk of binary data is not the second");
    } else if (type == binary_type) {
      container.binary = content;
    } else {
      report_.warning("", fmt::format("chunk {} is of an unknown kind and not used", number));
    }
    return true;
  }

  std::string_view bytes_;
  Report& report_;
  std::size_t at_ = 0;
};

}  // namespace

bool is_container(std::string_view bytes, bool named_glb) {
  return named_glb || (bytes.size() >= 4 && number_at(bytes, 0) == magic);
}

std::optional<Container> read_container(std::string_view bytes, Report& report) {
  return Chunks(bytes, report).read();
}

}  // namespace umbral::gltf
