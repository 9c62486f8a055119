// Inflating by zlib.
#include "formats/input/gzip.h"

#include <zlib.h>

#include <algorithm>

#include "core/error.h"

namespace umbral {
namespace {

[[noreturn]] void refuse(const std::string& name, const char* reason) {
  throw SceneError(Where{name}, reason);
}

class Inflater {
 public:
  Inflater(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {
    constexpr int gzip_alone = 16 + MAX_WBITS;
    if (inflateInit2(&stream_, gzip_alone) != Z_OK) refuse(name_, "zlib does not start");
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  std::string all() {
    std::string result;
    while (true) {
      if (stream_.avail_in == 0) feed();
      if (result.size() == used_) result.resize(std::max<std::size_t>(1 << 16, 2 * used_));
      const std::size_t room = std::min<std::size_t>(result.size() - used_, 1u << 30);
      stream_.next_out = reinterpret_cast<Bytef*>(result.data() + used_);
      stream_.avail_out = static_cast<uInt>(room);
      const int state = inflate(&stream_, Z_NO_FLUSH);
      used_ += room - stream_.avail_out;
      if (used_ > largest_unpacked) refuse(name_, "what is compressed in it is larger than 1 GiB");
      if (state == Z_STREAM_END) {
        if (stream_.avail_in == 0 && rest_.empty()) break;
        if (inflateReset(&stream_) != Z_OK) refuse(name_, "zlib does not start");
      } else if (state != Z_OK) {
        refuse(name_, "the compressed file is broken or ends too early");
      }
    }
    result.resize(used_);
    return result;
  }

 private:
  void feed() {
    const std::size_t count = std::min<std::size_t>(rest_.size(), 1u << 30);
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(rest_.data()));
    stream_.avail_in = static_cast<uInt>(count);
    rest_.remove_prefix(count);
  }

  std::string_view rest_;
  const std::string& name_;
  z_stream stream_{};
  std::size_t used_ = 0;
};

}  // namespace

std::string unpacked(std::string_view bytes, const std::string& name) { return Inflater(bytes, name).all(); }

}  // namespace umbral
