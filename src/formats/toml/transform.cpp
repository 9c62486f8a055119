// The steps of a transform.
#include "formats/toml/transform.h"

#include <fmt/format.h>

#include "formats/toml/parameter_reader.h"

namespace umbral::toml_file {
namespace {

std::optional<Affine> read_translation(const TableReader& table, const Value& value) {
  Vec3d offset{0};
  if (!read_vector(table, "translate", value, offset)) return std::nullopt;
  return translation(offset);
}

std::optional<Affine> read_scale(const TableReader& table, const Value& value) {
  Vec3d factors{1};
  if (value.as<Value::Array>()) {
    if (!read_vector(table, "scale", value, factors)) return std::nullopt;
    return scaling(factors);
  }
  const std::optional<double> factor = value.number();
  if (factor && std::isfinite(*factor)) return scaling(Vec3d(*factor));
  table.wrong_type("scale", value, "a finite number or a list of 3");
  return std::nullopt;
}

std::optional<Affine> read_rotation(const TableReader& table, const Value& value) {
  const auto* entries = value.as<Value::Table>();
  if (!entries) {
    table.wrong_type("rotate", value, "a table {axis = [x, y, z], degrees = …}");
    return std::nullopt;
  }
  TableReader reader(table.context(), entries, "rotate", table.context().place(value));
  const Value* axis_value = reader.find("axis");
  const Value* degrees_value = reader.find("degrees");
  reader.finish();
  if (!axis_value) reader.missing("axis");
  if (!degrees_value) reader.missing("degrees");
  Vec3d axis{0, 0, 1};
  bool good = axis_value && read_vector(reader, "axis", *axis_value, axis);
  const double degrees = degrees_value ? degrees_value->number().value_or(std::nan("")) : 0;
  if (!std::isfinite(degrees)) reader.wrong_type("degrees", *degrees_value, "a finite number");
  if (glm::length(axis) == 0) {
    table.context().error(*axis_value, "'axis' of 'rotate' has no direction");
    good = false;
  }
  if (!good || !degrees_value || !std::isfinite(degrees)) return std::nullopt;
  return rotation(glm::normalize(axis), glm::radians(degrees));
}

std::optional<Affine> read_matrix(const TableReader& table, const Value& value) {
  const auto* rows = value.as<Value::Array>();
  bool good = rows && rows->size() == 4;
  double m[4][4] = {};
  for (std::size_t r = 0; good && r < 4; ++r) {
    const auto* row = (*rows)[r].as<Value::Array>();
    good = row && row->size() == 4;
    for (std::size_t c = 0; good && c < 4; ++c) {
      m[r][c] = (*row)[c].number().value_or(std::nan(""));
      good = std::isfinite(m[r][c]);
    }
  }
  if (!good) {
    table.context().error(value, "'matrix' must be 4 rows of 4 finite numbers");
    return std::nullopt;
  }
  if (m[3][0] != 0 || m[3][1] != 0 || m[3][2] != 0 || m[3][3] != 1) {
    table.context().error((*rows)[3], "the last row of 'matrix' must be [0, 0, 0, 1]");
    return std::nullopt;
  }
  Affine map;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) map.linear[c][r] = m[r][c];
    map.offset[r] = m[r][3];
  }
  return map;
}

std::optional<Affine> read_step(const Context& context, const Value& step) {
  const auto* entries = step.as<Value::Table>();
  if (!entries || entries->size() != 1) {
    context.error(step, "a step of 'transform' must be a table with one key, as {translate = [x, y, z]}");
    return std::nullopt;
  }
  TableReader table(context, entries, "transform", context.place(step));
  std::optional<Affine> map;
  if (const Value* value = table.find("translate")) map = read_translation(table, *value);
  if (const Value* value = table.find("scale")) map = read_scale(table, *value);
  if (const Value* value = table.find("rotate")) map = read_rotation(table, *value);
  if (const Value* value = table.find("matrix")) map = read_matrix(table, *value);
  table.finish("step");
  return map;
}

// How far the map is from flattening space, from 0 to 1: |det| over the volume that columns (or rows) of
// these lengths have at a right angle (Hadamard's bound).
double fullness(glm::dmat3 m) {
  double largest = 0;
  for (int i = 0; i < 9; ++i) largest = std::max(largest, std::abs(m[i / 3][i % 3]));
  if (largest == 0) return 0;
  m /= largest;
  const glm::dmat3 t = glm::transpose(m);
  const double columns = glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]);
  const double rows = glm::length(t[0]) * glm::length(t[1]) * glm::length(t[2]);
  const double volume = std::min(columns, rows);
  return volume > 0 ? std::abs(glm::determinant(m)) / volume : 0;
}

}  // namespace

Affine read_transform(TableReader& table) {
  constexpr double flattest = 1e-13;
  const Value* value = table.find("transform");
  if (!value) return {};
  const Context& context = table.context();
  const auto* steps = value->as<Value::Array>();
  if (!steps) {
    table.wrong_type("transform", *value, "a list of steps, as [{scale = 2}, {translate = [x, y, z]}]");
    return {};
  }
  Affine map;
  bool good = true;
  for (const Value& step : *steps) {
    const std::optional<Affine> next = read_step(context, step);
    good &= next.has_value();
    if (!next) continue;
    if (!(fullness(next->linear) > flattest)) {
      context.error(step, "this step of 'transform' flattens the shape and cannot be inverted");
      good = false;
    }
    map = *next * map;
  }
  const Affine back = good ? inverse(map) : Affine{};
  for (int i = 0; i < 3 && good; ++i) {
    const Vec3d sum = map.linear[i] + map.offset + back.linear[i] + back.offset;
    good = std::isfinite(sum.x + sum.y + sum.z);
    if (!good) context.error(*value, "'transform' goes beyond the numbers that can be computed with");
  }
  return good ? map : Affine{};
}

}  // namespace umbral::toml_file
