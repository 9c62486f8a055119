// The signs by which materials are told apart.
#include "formats/obj/mtl_kinds.h"

#include <algorithm>
#include <array>

#include "core/spectrum.h"

namespace umbral {
namespace {

float brightness(const Vec3& color) { return luminance(Spectrum(color, 0)); }

bool is_glass(const MtlMaterial& mtl) {
  if (!(mtl.number("Ni").value_or(1) > 1) || mtl.map("map_d")) return false;
  if (mtl.illum == 6 || mtl.illum == 7) return true;
  const bool lets_through = opacity(mtl) < 1 || mtl.color("Tf", Vec3(1)) != Vec3(1);
  return (mtl.illum == 4 || mtl.illum == 9) && lets_through;
}

bool is_mirror(const MtlMaterial& mtl) {
  const bool outshines = brightness(mtl.color("Ks", Vec3(0))) > brightness(mtl.color("Kd", Vec3(0)));
  return (mtl.illum == 3 || mtl.illum == 5) && outshines && !mtl.map("map_Kd");
}

bool is_glossy(const MtlMaterial& mtl) {
  return mtl.illum != 0 && mtl.illum != 1 && mtl.color("Ks", Vec3(0)) != Vec3(0);
}

// As the extension of MTL for physically based materials has it.
bool is_physical(const MtlMaterial& mtl) {
  static constexpr std::array numbers{"Pr", "Pm", "Ps", "Pc", "Pcr", "aniso", "anisor"};
  static constexpr std::array maps{"map_Pr", "map_Pm", "map_Ps"};
  return std::any_of(numbers.begin(), numbers.end(), [&](const char* key) { return mtl.number(key); }) ||
         std::any_of(maps.begin(), maps.end(), [&](const char* key) { return mtl.map(key); });
}

}  // namespace

float opacity(const MtlMaterial& mtl) {
  if (const auto d = mtl.number("d")) return *d;
  return 1 - mtl.number("Tr").value_or(0);
}

MtlKind kind_of(const MtlMaterial& mtl) {
  if (is_glass(mtl)) return MtlKind::glass;
  if (is_mirror(mtl)) return MtlKind::mirror;
  if (is_physical(mtl)) return MtlKind::physical;
  return is_glossy(mtl) ? MtlKind::glossy : MtlKind::matte;
}

}  // namespace umbral
