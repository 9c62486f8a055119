// Reading and writing by the OpenEXR library.
#include "image/exr.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTestFile.h>
#include <fmt/format.h>

#include "core/error.h"
#include "image/atomic_file.h"

namespace umbral {
namespace {

constexpr std::int64_t largest_image = std::int64_t{1} << 28;  // pixels

// OpenEXR's own stream does not notice a disk that is full when the file is closed.
class AtomicStream : public Imf::OStream {
 public:
  AtomicStream(AtomicFile& file, const std::string& name) : Imf::OStream(name.c_str()), file_(file) {}

  void write(const char bytes[], int n) override { file_.write({bytes, static_cast<std::size_t>(n)}); }
  std::uint64_t tellp() override { return file_.position(); }
  void seekp(std::uint64_t position) override { file_.seek(position); }

 private:
  AtomicFile& file_;
};

void insert(Imf::Header& header, const std::string& name, const ExrAttribute& value) {
  std::visit(
      [&]<class T>(const T& v) {
        if constexpr (std::is_same_v<T, int>)
          header.insert(name, Imf::IntAttribute(v));
        else if constexpr (std::is_same_v<T, float>)
          header.insert(name, Imf::FloatAttribute(v));
        else if constexpr (std::is_same_v<T, double>)
          header.insert(name, Imf::DoubleAttribute(v));
        else
          header.insert(name, Imf::StringAttribute(v));
      },
      value);
}

Imf::Header header_of(const ExrImage& image) {
  const Imath::Box2i display({0, 0}, {image.width - 1, image.height - 1});
  const Imath::Box2i data({image.x0, image.y0}, {image.x1 - 1, image.y1 - 1});
  Imf::Header header(display, data);
  header.compression() = Imf::ZIP_COMPRESSION;
  header.zipCompressionLevel() =
      2;  // noise hardly compresses: the default, 4, takes 1.6 times as long for 1 % less
  Imf::addChromaticities(header, Imf::Chromaticities());  // the default is Rec. 709
  for (const ExrChannel& channel : image.channels)
    header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
  for (const auto& [name, value] : image.attributes) insert(header, name, value);
  return header;
}

// The pixels of `channel`; OpenEXR has one type of slice for reading and writing, hence not const.
Imf::Slice slice(const ExrChannel& channel, const Imath::Box2i& data) {
  return Imf::Slice::Make(Imf::FLOAT, const_cast<float*>(channel.pixels.data()), data);
}

Imf::FrameBuffer frame_buffer(const ExrImage& image, const Imath::Box2i& data) {
  Imf::FrameBuffer buffer;
  for (const ExrChannel& channel : image.channels) buffer.insert(channel.name, slice(channel, data));
  return buffer;
}

void require_readable(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw SceneError({path}, "there is no such file");
  if (!std::filesystem::is_regular_file(status)) throw SceneError({path}, "it is not a regular file");
  if (!Imf::isOpenExrFile(path.c_str()))
    throw SceneError({path}, "it is not an OpenEXR image, or cannot be read");
}

void require_plain(const Imf::Header& header, const std::string& path) {
  if (header.hasType() && Imf::isDeepData(header.type()))
    throw SceneError({path}, "it holds deep data, which are not supported");
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
    if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
      throw SceneError({path},
                       fmt::format("its channel '{}' is subsampled, which is not supported", channel.name()));
  const Imath::Box2i& data = header.dataWindow();
  const std::int64_t width = std::int64_t{data.max.x} - data.min.x + 1;
  const std::int64_t height = std::int64_t{data.max.y} - data.min.y + 1;
  if (width * height > largest_image)
    throw SceneError({path}, fmt::format("it has {} x {} pixels, more than the {} supported", width, height,
                                         largest_image));
}

// What OpenEXR itself needs is no news to the reader of the file.
bool is_standard(std::string_view name) {
  constexpr std::array<std::string_view, 8> names{
      "pixelAspectRatio", "screenWindowWidth",  "type", "name", "view", "chunkCount",
      "version",          "dwaCompressionLevel"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

void read_attributes(const Imf::Header& header, ExrImage& image) {
  for (auto a = header.begin(); a != header.end(); ++a) {
    if (is_standard(a.name())) continue;
    const Imf::Attribute* const any = &a.attribute();
    if (const auto* i = dynamic_cast<const Imf::IntAttribute*>(any)) image.attributes[a.name()] = i->value();
    if (const auto* f = dynamic_cast<const Imf::FloatAttribute*>(any))
      image.attributes[a.name()] = f->value();
    if (const auto* d = dynamic_cast<const Imf::DoubleAttribute*>(any))
      image.attributes[a.name()] = d->value();
    if (const auto* s = dynamic_cast<const Imf::StringAttribute*>(any))
      image.attributes[a.name()] = s->value();
  }
}

ExrImage read_first_part(const std::string& path, const std::function<bool(const std::string&)>& wanted) {
  Imf::MultiPartInputFile file(path.c_str());
  const Imf::Header& header = file.header(0);
  require_plain(header, path);
  if (!file.partComplete(0)) throw SceneError({path}, "it is truncated");
  const Imath::Box2i &display = header.displayWindow(), &data = header.dataWindow();
  ExrImage image;
  image.width = display.max.x - display.min.x + 1;
  image.height = display.max.y - display.min.y + 1;
  image.x0 = data.min.x - display.min.x;
  image.y0 = data.min.y - display.min.y;
  image.x1 = data.max.x + 1 - display.min.x;
  image.y1 = data.max.y + 1 - display.min.y;
  const auto pixels = static_cast<std::size_t>(image.x1 - image.x0) * (image.y1 - image.y0);
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
    if (!wanted || wanted(channel.name()))
      image.channels.push_back(
          {channel.name(), std::vector<float>(pixels), channel.channel().type == Imf::HALF});
  if (!image.channels.empty()) {
    Imf::InputPart part(file, 0);
    part.setFrameBuffer(frame_buffer(image, data));
    part.readPixels(data.min.y, data.max.y);
  }
  read_attributes(header, image);
  return image;
}

}  // namespace

const ExrChannel* ExrImage::find(std::string_view name) const {
  const auto found =
      std::find_if(channels.begin(), channels.end(), [&](const auto& c) { return c.name == name; });
  return found == channels.end() ? nullptr : &*found;
}

void write_exr(const std::string& path, const ExrImage& image) {
  AtomicFile file(path);
  try {
    AtomicStream stream(file, path);
    const Imf::Header header = header_of(image);
    Imf::OutputFile output(stream, header);
    output.setFrameBuffer(frame_buffer(image, header.dataWindow()));
    output.writePixels(header.dataWindow().max.y - header.dataWindow().min.y + 1);
  } catch (const std::exception& error) {
    file.check();
    throw OutputError(fmt::format("cannot write '{}': {}", path, error.what()));
  }
  file.commit();
}

ExrImage read_exr(const std::string& path, const std::function<bool(const std::string&)>& wanted) {
  require_readable(path);
  try {
    return read_first_part(path, wanted);
  } catch (const SceneError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw SceneError({path}, "there is not enough memory for its pixels");
  } catch (const std::exception& error) {
    throw SceneError({path}, fmt::format("it cannot be read: {}", error.what()));
  }
}

}  // namespace umbral
