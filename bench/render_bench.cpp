// Renders one benchmark scene and prints a line: paths and rays per second and core, share inside Embree, memory.
#include <sys/resource.h>

#include <cstdlib>

#include <fmt/format.h>

#include "bench_scenes.h"
#include "core/parallel.h"
#include "cpu_seconds.h"
#include "embree_share.h"
#include "integrators/registry.h"
#include "ray_count.h"
#include "render/renderer.h"

namespace umbral::bench {
namespace {

double peak_mebibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

struct NamedScene {
  const char* name;
  SceneDescription (*make)();
};

constexpr NamedScene scenes[]{
    {"cornell-box", cornell_box},
    {"textured-box", [] { return textured_box(); }},
    {"textured-box-stochastic",
     [] {
       return textured_box({2048, TextureFilter::stochastic});
     }},
    {"textured-box-mip",
     [] {
       return textured_box({2048, TextureFilter::mip});
     }},
    {"grey-box", [] { return textured_box({0}); }},
    {"textured-room", [] { return textured_room(); }},
    {"textured-room-2048", [] { return textured_room({2048}); }},
    {"textured-room-mip",
     [] {
       return textured_room({2048, TextureFilter::mip});
     }},
    {"grey-room", [] { return textured_room({0}); }},
    {"instances", instanced_field},
};

SceneDescription scene_by_name(const std::string& name) {
  std::string known;
  for (const NamedScene& scene : scenes) {
    if (name == scene.name) return scene.make();
    known += std::string(known.empty() ? "" : ", ") + scene.name;
  }
  throw std::invalid_argument("scenes are " + known + "; not '" + name + "'");
}

void run(const std::string& name, int threads, int spp) {
  const ThreadLimit limit(threads);
  const Scene scene(scene_by_name(name));
  const std::unique_ptr<Integrator> integrator = make_integrator("path");
  RenderOptions options;
  options.sampling.spp = spp;
  RenderOptions warm_up = options;
  warm_up.sampling.spp = 8;
  count_rays(true);
  const double paths = render(scene, *integrator, warm_up).film->image_error().samples;
  const double rays_a_path = static_cast<double>(rays_counted()) / paths;
  count_rays(false);

  const double before = cpu_seconds();
  const EmbreeShare embree;
  const RenderResult result = render(scene, *integrator, options);
  const double cpu = cpu_seconds() - before;
  const ImageError error = result.film->image_error();
  const double paths_a_second = error.samples / cpu / 1e6;
  fmt::print("{:<18} {:8.3f} {:8.2f} {:8.3f} {:8.1f} {:9.0f} {:11.0f} {:8.2f} {:10.3g}\n", name,
             paths_a_second, paths_a_second * rays_a_path, error.samples / result.seconds / 1e6,
             100 * embree.share(), peak_mebibytes(), static_cast<double>(scene.accel_bytes()) / (1 << 20),
             100 * error.relative(), 1 / (sqr(error.relative()) * cpu));
}

}  // namespace
}  // namespace umbral::bench

int main(int argc, char** argv) {
  if (argc == 2 && std::string(argv[1]) == "--header") {
    fmt::print("{:<18} {:>8} {:>8} {:>8} {:>8} {:>9} {:>11} {:>8} {:>10}\n", "scene", "Mpath/sc", "Mray/sc",
               "Mpath/s", "Embree %", "peak MiB", "Embree MiB", "error %", "eff. /sc");
    return 0;
  }
  try {
    const int threads = argc > 2 ? std::atoi(argv[2]) : umbral::available_threads();
    umbral::bench::run(argc > 1 ? argv[1] : "cornell-box", threads, argc > 3 ? std::atoi(argv[3]) : 32);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_render: {}\n", error.what());
    return 2;
  }
}
