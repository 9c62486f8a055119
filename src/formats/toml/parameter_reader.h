// ParameterReader: reads the parameters of anything described from a table of a TOML document.
#pragma once

#include <string>

#include "formats/toml/name_table.h"
#include "formats/toml/table_reader.h"
#include "scene/parameter_visitor.h"

namespace umbral::toml_file {

class TextureLibrary;

class ParameterReader final : public ParameterVisitor {
 public:
  // Textures are looked up in `textures` and materials in `materials`; without them, what names one is an error.
  ParameterReader(TableReader& table, TextureLibrary* textures, NameTable<MaterialId>* materials = nullptr)
      : table_(table), textures_(textures), materials_(materials) {}

  // A value that is wrong is told and leaves what it would have replaced.
  void operator()(const ParameterInfo& info, bool& value) override;
  void operator()(const ParameterInfo& info, int& value) override;
  void operator()(const ParameterInfo& info, std::uint64_t& value) override;
  void operator()(const ParameterInfo& info, float& value) override;
  void operator()(const ParameterInfo& info, Vec2& value) override;
  void operator()(const ParameterInfo& info, Vec3& value) override;
  void operator()(const ParameterInfo& info, Spectrum& value) override;
  void operator()(const ParameterInfo& info, std::string& value) override;
  void operator()(const ParameterInfo& info, ColorStops& value) override;
  void operator()(const ParameterInfo& info, Textured<float>& value) override;
  void operator()(const ParameterInfo& info, Textured<Spectrum>& value) override;
  void operator()(const ParameterInfo& info, MaterialId& value) override;
  void choice(const ParameterInfo& info, int& index, std::span<const char* const> names) override;
  using ParameterVisitor::operator();

 private:
  const Value* find(const ParameterInfo& info);
  std::optional<std::int64_t> integer(const ParameterInfo& info);
  void wrong_number(const ParameterInfo& info, const Value& value, double number,
                    const std::string& wanted) const;
  bool read_number(const ParameterInfo& info, const Value& value, float& number);
  bool read_color(const ParameterInfo& info, const Value& value, Spectrum& color);
  bool read_hex_color(const ParameterInfo& info, const Value& value, const std::string& text,
                      Spectrum& color);
  template <int N>
  bool read_numbers(const ParameterInfo& info, const Value& value, glm::vec<N, float>& numbers);
  bool read_stop(const ParameterInfo& info, const Value& value, ColorStop& stop);
  bool names_texture(const Value& value) const;
  template <class T>
  void read_texture(const ParameterInfo& info, const Value& value, Textured<T>& textured);

  TableReader& table_;
  TextureLibrary* textures_;
  NameTable<MaterialId>* materials_;
};

// "between 0 and 1", "above 0", "at least 0", "finite", …
std::string range_text(const Range& range);

// A list of three finite numbers; false, and told, if it is anything else.
bool read_vector(const TableReader& table, std::string_view key, const Value& value, Vec3d& vector);

}  // namespace umbral::toml_file
