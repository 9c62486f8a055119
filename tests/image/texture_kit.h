// Image files for tests, written by OpenImageIO and loaded as textures.
#pragma once

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "files.h"
#include "image/texture_image.h"
#include "support/paths.h"

namespace umbral::test {

template <class T>
void write_image(const std::string& path, int width, int height, int channels, const OIIO::TypeDesc& type,
                 const std::vector<T>& pixels) {
  const auto output = OIIO::ImageOutput::create(path);
  ASSERT_TRUE(output) << OIIO::geterror();
  OIIO::ImageSpec spec(width, height, channels, type);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  ASSERT_TRUE(output->open(path, spec) && output->write_image(OIIO::BaseTypeFromC<T>::value, pixels.data()) &&
              output->close())
      << output->geterror();
}

class TextureLoader : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (directory_.path() / name).string(); }
  TextureImage load(const std::string& name, ColorSpace space = ColorSpace::automatic) {
    return load_texture_image(path(name), space, repairs_);
  }
  std::string refusal(const std::string& name) {
    return message_of<SceneError>([&] { load(name); });
  }

  TemporaryDirectory directory_;
  std::vector<std::string> repairs_;
};

// 2 × 2, rows from the top: red, green / blue, (10, 20, 30)
inline const std::vector<std::uint8_t> four{255, 0, 0, 0, 255, 0, 0, 0, 255, 10, 20, 30};

}  // namespace umbral::test
