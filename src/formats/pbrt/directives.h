// The directives of a pbrt file and the state that they change.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "formats/pbrt/settings.h"
#include "formats/pbrt/shapes.h"
#include "formats/pbrt/tokens.h"

namespace umbral::pbrt_file {

// What AttributeBegin keeps and AttributeEnd brings back.
struct GraphicsState {
  Affine to_world;
  bool reversed = false;
  MaterialHandle material;
  AreaLight light;
  std::shared_ptr<const Medium> inside = nullptr;
  std::map<std::string, Parameters> defaults = {};  // by what they are for: "shape", "light", …
};

class Directives {
 public:
  Directives(const std::filesystem::path& path, Inclusion inclusion, const IntegratorKinds& integrators,
             SceneBuilder& builder, SceneFile& result);

  // `text` is what stands in the file. Throws SceneError at mistakes of syntax.
  void read(const std::filesystem::path& path, std::string text);
  // After the whole file.
  void finish();
  // The names of those that shapes asked for.
  std::vector<std::string> materials_seen() const { return materials_.seen(); }

 private:
  using Directive = void (Directives::*)(const Token&);
  static const std::map<std::string_view, Directive>& table();

  [[noreturn]] void fail(const Token& at, const std::string& message) const;
  void run(const Token& directive);
  std::string text();
  double number();
  Vec3d vector() { return {number(), number(), number()}; }  // braces evaluate from left to right
  Affine matrix();
  Parameters parameters(const Token& directive, const char* defaults = nullptr);
  Parameter parameter();
  void values(Parameter& parameter);

  void push(char kind);
  void pop(char kind, const Token& at);
  void transform(const Affine& map) { state_.to_world = state_.to_world * map; }
  // Where things stand: in the world of the whole scene, or in an object.
  Affine placed() const { return open_object_ ? state_.to_world : inclusion_.to_world * state_.to_world; }

  void attribute_begin(const Token&) { push('A'); }
  void attribute_end(const Token& at) { pop('A', at); }
  void transform_begin(const Token&) { push('T'); }
  void transform_end(const Token& at) { pop('T', at); }
  void attribute(const Token&);
  void identity(const Token&) { state_.to_world = {}; }
  void translate(const Token&) { transform(translation(vector())); }
  void scale(const Token&);
  void rotate(const Token&);
  void look_at(const Token&);
  void set_transform(const Token&) { state_.to_world = matrix(); }
  void concat_transform(const Token&) { transform(matrix()); }
  void coordinate_system(const Token&);
  void coord_sys_transform(const Token&);
  void active_transform(const Token&);
  void transform_times(const Token&);
  void reverse_orientation(const Token&) { state_.reversed = !state_.reversed; }
  void color_space(const Token&);
  void option(const Token&);
  void accelerator(const Token&);

  void film(const Token&);
  void filter(const Token&);
  void sampler(const Token&);
  void integrator(const Token&);
  void camera(const Token&);
  void world_begin(const Token&);
  void world_end(const Token&) {}
  void include(const Token&);

  void texture(const Token&);
  void material(const Token&);
  void make_named_material(const Token&);
  void named_material(const Token&);
  void make_named_medium(const Token&);
  void medium_interface(const Token&);
  std::shared_ptr<const Medium> medium(const std::string& name, const Place& place);
  void light_source(const Token&);
  void area_light_source(const Token&);
  void shape(const Token&);
  void object_begin(const Token&);
  void object_end(const Token&);
  void object_instance(const Token&);

  Inclusion inclusion_;
  const IntegratorKinds& integrators_;
  SceneBuilder& builder_;
  std::filesystem::path folder_;
  Tokens* tokens_ = nullptr;  // of the file that is being read
  int depth_ = 0, files_ = 0;
  bool in_world_ = false;

  Settings settings_;
  Textures textures_;
  Materials materials_;
  Lights lights_;
  Shapes shapes_;

  GraphicsState state_;
  std::vector<std::pair<char, GraphicsState>> saved_;
  std::map<std::string, Affine> systems_;
  std::map<std::string, ObjectId> objects_;
  std::map<std::string, Parameters> media_;
  std::optional<std::size_t> open_object_;  // in builder_.objects
};

}  // namespace umbral::pbrt_file
