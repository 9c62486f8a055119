// A film in an OpenEXR file and back.
#include "image/film_file.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "files.h"
#include "support/paths.h"
#include "synthetic_film.h"

namespace umbral {
namespace {

using test::add_normal_block, test::message_of;
using testing::HasSubstr;

FilmImage example() {
  Film film({.width = 9,
             .height = 7,
             .x0 = 2,
             .y0 = 1,
             .x1 = 8,
             .y1 = 6,
             .layers = {"direct", "indirect"},
             .auxiliary = true});
  std::mt19937_64 random(5);
  add_normal_block(film, 16, 0.3, random);
  FilmImage image = film_image(film, {.version = "0.1.0",
                                      .scene = "scenes/a b.toml",
                                      .scene_hash = "0123456789abcdef",
                                      .integrator = "path max_depth=8",
                                      .sampler = "sobol",
                                      .filter = "gaussian 1.5",
                                      .seeds = {18446744073709551615ull, 3},
                                      .render_seconds = 12.345678901234,
                                      .stop_reason = "samples",
                                      .bias_notes = {"paths end after 8 bounces", "another"},
                                      .extra = {{"threads", "2"}}});
  image.samples_rejected = 3;
  image.auxiliary[4] = {Vec3(0.5f, 0.25f, 0.125f), Vec3(0, 0.5f, -1), 3.5f};
  image.pixels[5] = {};
  return image;
}

TEST(FilmFile, RoundTrip) {
  const test::TemporaryDirectory directory;
  const std::string path = (directory.path() / "a.exr").string();
  const FilmImage image = example();
  write_film(path, image);
  const FilmImage back = read_film(path);
  ASSERT_EQ(back.pixels.size(), image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    EXPECT_EQ(Vec3(back.pixels[i].mean), Vec3(image.pixels[i].mean));
    EXPECT_EQ(Vec3(back.pixels[i].standard_error), Vec3(image.pixels[i].standard_error));
    EXPECT_EQ(back.pixels[i].samples, image.pixels[i].samples);
    EXPECT_EQ(back.layers[1][i], image.layers[1][i]);
    EXPECT_EQ(back.auxiliary[i].albedo, image.auxiliary[i].albedo);
    EXPECT_EQ(back.auxiliary[i].normal, image.auxiliary[i].normal);
    EXPECT_EQ(back.auxiliary[i].depth, image.auxiliary[i].depth);
  }
  EXPECT_EQ(back.layout.x0, 2);
  EXPECT_EQ(back.layout.y1, 6);
  EXPECT_EQ(back.layout.width, 9);
  EXPECT_EQ(back.layout.replicates, 8);
  EXPECT_EQ(back.layout.layers, image.layout.layers);
  EXPECT_EQ(back.samples_rejected, 3);
  EXPECT_EQ(back.error.mean, image.error.mean);
  EXPECT_EQ(back.error.standard_error, image.error.standard_error);
  EXPECT_EQ(back.error.half_width(), image.error.half_width());
  const Provenance &p = back.provenance, &q = image.provenance;
  EXPECT_EQ(std::tie(p.version, p.scene, p.scene_hash, p.integrator, p.sampler, p.filter, p.seeds,
                     p.render_seconds, p.stop_reason, p.bias_notes, p.extra),
            std::tie(q.version, q.scene, q.scene_hash, q.integrator, q.sampler, q.filter, q.seeds,
                     q.render_seconds, q.stop_reason, q.bias_notes, q.extra));
}

TEST(FilmFile, ChannelsAndAttributesHaveTheNamesThatUsersKnow) {
  const ExrImage exr = to_exr(example());
  std::vector<std::string> names;
  for (const ExrChannel& channel : exr.channels) names.push_back(channel.name);
  EXPECT_THAT(names, testing::UnorderedElementsAre(
                         "R", "G", "B", "stderr.R", "stderr.G", "stderr.B", "samples.Y", "firefly.Y",
                         "direct.R", "direct.G", "direct.B", "indirect.R", "indirect.G", "indirect.B",
                         "albedo.R", "albedo.G", "albedo.B", "N.X", "N.Y", "N.Z", "Z"));
  EXPECT_EQ(*exr.attribute<int>("samplesPerPixel"), 128);
  EXPECT_EQ(*exr.attribute<float>("renderTimeSeconds"), 12.345678901234f);
  EXPECT_EQ(*exr.attribute<std::string>("umbral:seeds"), "18446744073709551615 3");
  EXPECT_EQ(*exr.attribute<std::string>("umbral:biasNotes"), "paths end after 8 bounces\nanother");
}

TEST(FilmFile, WithoutLayersThereAreEightChannels) {
  const ExrImage exr = to_exr(film_image(Film({.width = 2, .height = 2}), {}));
  EXPECT_EQ(exr.channels.size(), 8u);
  const FilmImage back = film_image(exr, "a.exr");
  EXPECT_TRUE(back.layers.empty());
  EXPECT_TRUE(back.auxiliary.empty());
  EXPECT_TRUE(back.provenance.bias_notes.empty());
  EXPECT_EQ(back.pixels[0].samples, 0);
  EXPECT_TRUE(std::isinf(back.pixels[0].standard_error.r));
}

TEST(FilmFile, FirefliesTailsAndPooledErrorsComeBack) {
  FilmImage image = example();
  image.fireflies[7] = true;
  image.tail_index = 0.75;
  image.with_pooled_error = true;
  const ExrImage exr = to_exr(image);
  EXPECT_EQ(exr.find("firefly.Y")->pixels[7], 1);
  EXPECT_EQ(*exr.attribute<int>("umbral:fireflies"), 1);
  EXPECT_GT(exr.find("stderrPooled.G")->pixels[7], 0);
  const FilmImage back = film_image(exr, "a.exr");
  EXPECT_EQ(back.fireflies, image.fireflies);
  EXPECT_EQ(back.tail_index, 0.75);
  EXPECT_TRUE(back.has_heavy_tails());
  EXPECT_TRUE(back.with_pooled_error);
  FilmImage other = example();
  other.provenance.seeds = {4};
  other.fireflies[2] = true;
  const FilmImage both = combined(image, other);
  EXPECT_EQ(both.firefly_count(), 2u);
  EXPECT_EQ(both.tail_index, 0.75);
}

TEST(FilmFile, CombiningFilesEqualsCombiningFilmsUpToFloat) {
  const auto rendered = [](std::uint64_t seed) {
    Film film({.width = 8, .height = 8});
    std::mt19937_64 random(seed);
    add_normal_block(film, 16, 0.3, random);
    return film_image(film, {.seeds = {seed}});
  };
  const auto by_file = [&](std::uint64_t seed) { return film_image(to_exr(rendered(seed)), "a.exr"); };
  const FilmImage a = combined(rendered(1), rendered(2)), b = combined(by_file(1), by_file(2));
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(b.pixels[i].mean[c] / a.pixels[i].mean[c], 1, 1e-7);
      EXPECT_NEAR(b.pixels[i].standard_error[c] / a.pixels[i].standard_error[c], 1, 1e-7);
    }
}

TEST(FilmFile, OtherImagesAreRefused) {
  ExrImage exr = to_exr(example());
  EXPECT_EQ(message_of<SceneError>([&] { film_image(exr, "a.exr"); }), "");
  ExrImage foreign = exr;
  foreign.attributes.clear();
  EXPECT_THAT(
      message_of<SceneError>([&] { film_image(foreign, "a.exr"); }),
      HasSubstr("a.exr: error: it has no attribute 'umbral:version': it was not written by umbral's render"));
  std::erase_if(exr.channels, [](const ExrChannel& channel) { return channel.name == "stderr.G"; });
  EXPECT_THAT(message_of<SceneError>([&] { film_image(exr, "a.exr"); }),
              HasSubstr("a.exr: error: it has no channel 'stderr.G'"));
}

}  // namespace
}  // namespace umbral
