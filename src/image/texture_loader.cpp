// Image files into texels, by OpenImageIO.
#include "image/texture_loader.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <new>
#include <string_view>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "core/error.h"
#include "image/pfm.h"

namespace umbral {
namespace {

constexpr std::int64_t most_texels = std::int64_t{1} << 29;

void require_sane(const OIIO::ImageSpec& spec, const std::string& path) {
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1)
    throw SceneError({path},
                     fmt::format("the image is empty: it has {} x {} texels", spec.width, spec.height));
  if (spec.depth > 1 || spec.deep)
    throw SceneError({path}, "volumes and deep images cannot be used as textures");
}

void require_few_texels(const OIIO::ImageSpec& spec, const std::string& path) {
  if (std::int64_t{spec.width} * spec.height > most_texels)
    throw SceneError({path}, fmt::format("the image has {} x {} texels, more than the {} supported",
                                         spec.width, spec.height, most_texels));
}

struct Packing {
  std::string_view format;
  std::int64_t texels_per_byte;  // at most
};

constexpr Packing packings[] = {
    {"targa", 128},     // in a packet of its run-length code
    {"jpeg", 512},      // 8 × 8 texels are a bit at least, by Huffman's codes
    {"png", 8 * 1032},  // a texel is a bit at least, and zlib packs to 1/1032 at most
    {"hdr", 8192},      // runs of its older kind, the next one counting 256-fold
    {"pnm", 8},         // a texel is a bit at least
};

// OpenImageIO makes room for all that a damaged header claims, and may take minutes to find out that it is not there.
void require_plausible(const OIIO::ImageInput& input, std::size_t bytes, const std::string& path) {
  const OIIO::ImageSpec& spec = input.spec();
  for (const Packing& packing : packings)
    if (packing.format == input.format_name() &&
        std::int64_t{spec.width} * spec.height / packing.texels_per_byte > static_cast<std::int64_t>(bytes))
      throw SceneError({path}, fmt::format("the image is damaged: its {} bytes cannot hold {} x {} texels",
                                           bytes, spec.width, spec.height));
}

// Some readers fill what a truncated file lacks with grey and leave a message: that is an error too.
void require_complete(bool done, OIIO::ImageInput& input, const std::string& path) {
  const std::string message = input.geterror();
  if (done && message.empty()) return;
  throw SceneError({path}, "the image is damaged" + (message.empty() ? "" : ": " + message));
}

template <class T>
std::vector<T> read_values(OIIO::ImageInput& input, OIIO::TypeDesc type, int count, const std::string& path) {
  const OIIO::ImageSpec& spec = input.spec();
  std::vector<T> values(static_cast<std::size_t>(spec.width) * spec.height * count);
  require_complete(input.read_image(0, 0, 0, count, type, values.data()), input, path);
  return values;
}

// A grid of the texels of the file; `store` makes one from its four values. The file's last row becomes row
// 0.
template <class Format, class T>
TexelGrid<Format> grid_of(OIIO::ImageInput& input, OIIO::TypeDesc type, T one, const std::string& path,
                          auto&& store) {
  const OIIO::ImageSpec& spec = input.spec();
  const FileChannels channels = FileChannels::of(spec.nchannels, spec.alpha_channel);
  const std::vector<T> values = read_values<T>(input, type, channels.count, path);
  TexelGrid<Format> grid(spec.width, spec.height);
  const T* texel = values.data();
  for (int y = spec.height - 1; y >= 0; --y)
    for (int x = 0; x < spec.width; ++x, texel += channels.count)
      grid.set(x, y, store(channels.expanded(texel, one)));
  return grid;
}

// Counts the texels with a bad channel and makes these channels 0.
class Repair {
 public:
  template <class T>
  std::array<T, 4> operator()(std::array<T, 4> texel) {
    bool bad = false;
    for (T& value : texel) {
      if (is_good(value)) continue;
      bad = true;
      value = 0;
    }
    count_ += bad;
    return texel;
  }

  void report(int width, int height, const std::string& path, std::vector<std::string>& repairs) const {
    if (count_ == 0) return;
    repairs.push_back(
        fmt::format("{}: {} of {} texels had values that are not a number, infinite or negative; "
                    "these values were replaced by 0",
                    path, count_, std::int64_t{width} * height));
  }

 private:
  static bool is_good(float value) { return value >= 0 && value < infinity; }
  // binary16: the infinities start at 0x7c00; −0 is fine.
  static bool is_good(std::uint16_t value) { return value < 0x7c00 || value == 0x8000; }

  std::int64_t count_ = 0;
};

TextureImage::Texels read_texels(OIIO::ImageInput& input, bool srgb, Repair& repair,
                                 const std::string& path) {
  const OIIO::TypeDesc type(static_cast<OIIO::TypeDesc::BASETYPE>(input.spec().format.basetype));
  const auto same = [](const std::array<std::uint8_t, 4>& t) { return t; };
  if (type == OIIO::TypeDesc::UINT8) {
    constexpr std::uint8_t one = 255;
    if (srgb) return grid_of<Srgb8>(input, type, one, path, same);
    return grid_of<Linear8>(input, type, one, path, same);
  }
  if (type == OIIO::TypeDesc::HALF && !srgb) {
    constexpr std::uint16_t one = 0x3c00;
    return grid_of<Half4>(input, type, one, path, [&](const std::array<std::uint16_t, 4>& t) {
      return std::bit_cast<Half4::Stored>(repair(t));
    });
  }
  return grid_of<Float4>(input, OIIO::TypeDesc::FLOAT, 1.0f, path, [&](const std::array<float, 4>& t) {
    const auto [r, g, b, a] = repair(t);
    return srgb ? Spectrum(srgb_decode(r), srgb_decode(g), srgb_decode(b), a) : Spectrum(r, g, b, a);
  });
}

void require_file(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw SceneError({path}, "there is no such file");
  if (!std::filesystem::is_regular_file(status)) throw SceneError({path}, "it is not a regular file");
  if (std::filesystem::file_size(path, error) == 0) throw SceneError({path}, "the file is empty");
}

std::unique_ptr<OIIO::ImageInput> opened(const std::string& path) {
  require_file(path);
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // leave straight alpha straight
  std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &config);
  if (!input) throw SceneError({path}, "the image cannot be read: " + OIIO::geterror());
  return input;
}

// Whether the numbers of the file are taken for sRGB codes.
bool is_encoded(const OIIO::ImageSpec& spec, ColorSpace color_space) {
  return color_space == ColorSpace::srgb ||
         (color_space == ColorSpace::automatic && !spec.format.is_floating_point());
}

// As grid_of() will store them.
std::size_t bytes_in_memory(const OIIO::ImageSpec& spec, bool srgb) {
  const std::size_t texels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  if (spec.format == OIIO::TypeDesc::UINT8) return 4 * texels;
  return (spec.format == OIIO::TypeDesc::HALF && !srgb ? 8 : 16) * texels;
}

TextureImage pfm_image(const std::string& path, ColorSpace color_space, std::vector<std::string>& repairs) {
  require_file(path);
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  TexelGrid<Float4> grid = read_pfm(bytes, path, most_texels);
  Repair repair;
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x) {
      const Spectrum texel = grid.at(x, y);
      const auto [r, g, b, a] = repair(std::array<float, 4>{texel.r, texel.g, texel.b, 1});
      grid.set(x, y,
               color_space == ColorSpace::srgb ? Spectrum(srgb_decode(r), srgb_decode(g), srgb_decode(b), a)
                                               : Spectrum(r, g, b, a));
    }
  repair.report(grid.width(), grid.height(), path, repairs);
  return TextureImage(TextureImage::Texels(std::move(grid)));
}

// Read whole, or left in its file `path` where `memory` has no room for it; `bytes` is the size of the file.
TextureImage loaded(OIIO::ImageInput& input, std::size_t bytes, const std::string& path,
                    ColorSpace color_space, std::vector<std::string>& repairs, TextureMemory* memory) {
  const OIIO::ImageSpec spec = input.spec();
  require_sane(spec, path);
  require_plausible(input, bytes, path);
  const bool srgb = is_encoded(spec, color_space);
  try {
    if (memory && !memory->take(bytes_in_memory(spec, srgb)))
      return TextureImage(CachedTexels(memory->cache(), path, srgb));
    require_few_texels(spec, path);
    Repair repair;
    TextureImage image(read_texels(input, srgb, repair, path));
    repair.report(spec.width, spec.height, path, repairs);
    return image;
  } catch (const std::bad_alloc&) {
    throw SceneError(
        {path}, fmt::format("there is not enough memory for its {} x {} texels", spec.width, spec.height));
  }
}

}  // namespace

std::optional<TextureImage> load_where_room(const std::string& path, ColorSpace color_space,
                                            std::vector<std::string>& repairs, std::size_t& bytes,
                                            const std::function<bool(std::size_t)>& take) {
  if (is_pfm(path)) return std::nullopt;
  const std::unique_ptr<OIIO::ImageInput> input = opened(path);
  bytes = bytes_in_memory(input->spec(), is_encoded(input->spec(), color_space));
  if (!take(bytes)) return std::nullopt;
  return loaded(*input, std::filesystem::file_size(path), path, color_space, repairs, nullptr);
}

TextureImage load_texture_image(const std::string& path, ColorSpace color_space,
                                std::vector<std::string>& repairs, TextureMemory* memory) {
  if (is_pfm(path)) return pfm_image(path, color_space, repairs);
  const std::unique_ptr<OIIO::ImageInput> input = opened(path);
  return loaded(*input, std::filesystem::file_size(path), path, color_space, repairs, memory);
}

TextureImage load_texture_image(std::string_view bytes, const std::string& name, ColorSpace color_space,
                                std::vector<std::string>& repairs) {
  OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());  // it only reads
  OIIO::Filesystem::IOProxy* proxy = &memory;
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  // OpenImageIO looks at the ending alone.
  const std::string ending = "texture" + std::filesystem::path(name).extension().string();
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(ending, &config);
  if (!input) throw SceneError({name}, "the image cannot be read: " + OIIO::geterror());
  return loaded(*input, bytes.size(), name, color_space, repairs, nullptr);
}

}  // namespace umbral
