// Another view of a scene.
#include "app/view_arguments.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/arguments.h"
#include "core/names.h"
#include "formats/assembly/number_checks.h"

namespace umbral {
namespace {

void choose_camera(const std::string& name, SceneFile& file) {
  std::vector<std::string> names;
  for (const NamedCamera& camera : file.cameras) names.push_back(camera.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    refuse("there is no camera '" + name + "'" +
           (names.empty() ? ": the file names none" : suggestion(name, names)));
  const NamedCamera& camera = file.cameras[static_cast<std::size_t>(found - names.begin())];
  file.scene.camera = camera.settings;
  if (camera.aspect > 0) take_aspect(camera.aspect, file.film);
}

void replace(const std::vector<float>& given, Vec3& value) {
  if (!given.empty()) value = {given[0], given[1], given[2]};
}

}  // namespace

void add_view_options(CLI::App& command, ViewArguments& view) {
  const auto vector = [&](const char* name, std::vector<float>& value, const char* doc) {
    command.add_option(name, value, doc)->delimiter(',')->expected(3)->check(number_above(-infinity));
  };
  command.add_option("--camera", view.camera, "the camera of that name in the file");
  vector("--position", view.position, "where the camera is, x,y,z");
  vector("--look-at", view.look_at, "the point in the middle of the image, x,y,z");
  vector("--up", view.up, "the way that is up in the image, x,y,z");
  command.add_option("--fov", view.fov, "vertical angle of view, degrees")->check(number_above(0));
}

void apply_view(const ViewArguments& view, SceneFile& file) {
  if (!view.camera.empty()) choose_camera(view.camera, file);
  CameraSettings& camera = file.scene.camera;
  replace(view.position, camera.position);
  replace(view.look_at, camera.look_at);
  replace(view.up, camera.up);
  if (view.fov && *view.fov >= 180) refuse("--fov must be below 180 degrees");
  if (view.fov) {
    camera.fov = *view.fov;
    camera.orthographic_height = 0;
  }
  if (const auto fault = fault_of(camera)) refuse(*fault);
  if (camera.look_at == camera.position)
    refuse("--look-at is where the camera is: there is no direction to look in");
  if (lacks_up(camera)) refuse("the view is along what is up in the image: give another --up");
}

}  // namespace umbral
