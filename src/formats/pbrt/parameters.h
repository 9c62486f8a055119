// The parameters of a directive of a pbrt file: "type name" and values, asked for by name and type.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "core/math.h"
#include "formats/assembly/scene_builder.h"

namespace umbral::pbrt_file {

struct Parameter {
  std::string type, name;
  Place place;
  std::vector<double> numbers;
  std::vector<std::string> strings;  // of strings and names of textures; "true" and "false" of bools
  bool inherited = false;            // from an Attribute directive: nobody need ask for it
};

// What is asked for must have the type that the asker names; where it has another, that is told as an error and the
// default is given. What nobody asks for is an error too, when report_unknown() is called.
class Parameters {
 public:
  Parameters() = default;
  Parameters(SceneBuilder& builder, Place place, std::vector<Parameter> list)
      : builder_(&builder), place_(std::move(place)), list_(std::move(list)) {}

  // Of the directive.
  const Place& place() const { return place_; }

  // None if there is no such parameter; of any type.
  const Parameter* find(const std::string& name) const;
  bool has(const std::string& name) const { return find(name) != nullptr; }
  // Of one of the types; with `count` values, or any number where that is 0.
  const Parameter* find(const std::string& name, std::initializer_list<const char*> types,
                        std::size_t count) const;

  double number(const std::string& name, double otherwise) const;
  int integer(const std::string& name, int otherwise) const;
  bool flag(const std::string& name, bool otherwise) const;
  std::string text(const std::string& name, const std::string& otherwise) const;
  Vec3d point(const std::string& name, const Vec3d& otherwise) const;
  // Empty where there is none. `arity` numbers belong together: their count must be a multiple.
  std::vector<double> numbers(const std::string& name, std::initializer_list<const char*> types,
                              std::size_t arity) const;

  // Those of `defaults` whose names are not given here are added, as pbrt's Attribute directive asks.
  void add_defaults(const Parameters& defaults);

  // What is of no effect on an image.
  void ignore(std::initializer_list<const char*> names) const;
  // What umbral lacks: `what` is told at that parameter, if it is there.
  void lacks(const std::string& name, const std::string& what) const;
  // What umbral shows in its own way, likewise.
  void approximates(const std::string& name, const std::string& what) const;
  void error(const Parameter& at, std::string message) const;
  void report_unknown(const std::string& of) const;

 private:
  SceneBuilder* builder_ = nullptr;
  Place place_;
  std::vector<Parameter> list_;
  mutable std::vector<std::string> asked_;
};

}  // namespace umbral::pbrt_file
