// What there is to say of a glTF file, located by the path of the JSON value that it is about.
#pragma once

#include <map>
#include <string>

#include "formats/input/diagnostics.h"

namespace umbral::gltf {

class Report {
 public:
  Report(Diagnostics& diagnostics, std::string file) : diagnostics_(diagnostics), file_(std::move(file)) {}

  // `path` is a JSON pointer, such as "/accessors/3/count"; empty for the file as a whole.
  void error(const std::string& path, const std::string& message);
  // Alike warnings of values that differ in their indices alone are told once, with their number.
  void warning(const std::string& path, const std::string& message);
  // Hands the warnings over; to be called once, at the end.
  void finish();

  std::size_t errors() const { return errors_; }
  const std::string& file() const { return file_; }

 private:
  struct Kept {
    std::string path, message;
    std::size_t count = 0;
  };

  Diagnostics& diagnostics_;
  std::string file_;
  std::size_t errors_ = 0;
  std::map<std::string, std::size_t> known_;  // warnings by what makes them alike
  std::vector<Kept> warnings_;
};

}  // namespace umbral::gltf
