// ImagesAhead: images that will be asked for, decoded in parallel before they are.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "image/texture_image.h"

namespace umbral {

struct DecodedImage {
  TextureImage image;
  std::vector<std::string> repairs = {};  // as load_texture_image() tells them
  std::size_t budget = 0;                 // bytes that it counts for in a TextureMemory
};

// What it holds is what decoding on demand would give, so that it saves time and changes nothing else.
class ImagesAhead {
 public:
  using Key = std::pair<std::string, ColorSpace>;  // the name of a file, or of a part of one
  using Decode = std::function<DecodedImage()>;  // may be called beside others; whatever it throws is dropped
  // Told how many images are decoded, of how many: from any thread, but never from two at a time.
  using Progress = std::function<void(std::size_t done, std::size_t count)>;

  explicit ImagesAhead(Progress progress) : progress_(std::move(progress)) {}

  // A key that it knows is not decoded again.
  void expect(const Key& key, Decode decode);

  // Decodes what is expected, and forgets how.
  void decode_expected();

  // The image, once; decodes what is expected if it is not yet. Nothing where it was not expected, or where decoding failed:
  // whoever then decodes it will meet the error.
  std::optional<DecodedImage> take(const Key& key);

 private:
  struct Entry {
    Decode decode;
    std::optional<DecodedImage> decoded;
  };

  Progress progress_;
  std::map<Key, Entry> entries_;
  std::vector<Entry*> waiting_;  // in the order of expect()
  std::size_t done_ = 0, count_ = 0;
};

}  // namespace umbral
