// The properties of an object of a Mitsuba file, asked for by name.
#pragma once

#include <initializer_list>
#include <set>
#include <string>

#include "formats/mitsuba/document.h"

namespace umbral::mitsuba_file {

// Numbers out of "1, 2 3"; empty where something else stands there.
std::vector<double> numbers_in(const std::string& text);

// What is asked for under a name must have the tag that the asker names. What nobody asks for is an error when
// report_unknown() is called.
class Properties {
 public:
  Properties(SceneBuilder& builder, const Document& document, const Element& element)
      : builder_(builder), document_(document), element_(element) {}

  const Element& element() const { return element_; }
  const Place& place() const { return element_.place; }

  bool has(const std::string& name) const { return find(name) != nullptr; }
  // The property of that name, a <ref> followed to what it names; none if there is no such.
  const Element* find(const std::string& name) const;
  // The first child object or <ref> of the tag, whatever its name; a nested one is preferred.
  const Element* object(const std::string& tag) const;
  std::vector<const Element*> objects(const std::string& tag) const;

  double number(const std::string& name, double otherwise) const;
  int integer(const std::string& name, int otherwise) const;
  bool flag(const std::string& name, bool otherwise) const;
  std::string text(const std::string& name, const std::string& otherwise) const;
  Vec3d vector(const std::string& name, const Vec3d& otherwise) const;
  // To the world, as its operations follow each other; the identity where there is none.
  Affine transform(const std::string& name) const;
  // That named "to_world", and on to where the document's world stands in the scene's.
  Affine placed() const { return document_.to_world * transform("to_world"); }

  void ignore(std::initializer_list<const char*> names) const;
  void lacks(const std::string& name, const std::string& what) const;
  void report_unknown() const;

 private:
  const Element* find(const std::string& name, std::initializer_list<const char*> tags) const;
  const Element* followed(const Element& element) const;
  void error(const Place& place, std::string message) const {
    builder_.diagnostics.error(place, std::move(message));
  }

  SceneBuilder& builder_;
  const Document& document_;
  const Element& element_;
  mutable std::set<const Element*> used_;
  mutable std::set<std::string> asked_;
};

// The map that the operations in a <transform> make, the first one first. None if one is wrong, which is told.
std::optional<Affine> transform_of(SceneBuilder& builder, const Element& element);

}  // namespace umbral::mitsuba_file
