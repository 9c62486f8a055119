// Which material a BSDF becomes, and what those that hold others add to them.
#include "formats/mitsuba/materials.h"

#include <fmt/format.h>

#include "formats/assembly/material_parts.h"
#include "formats/translation/material_parameters.h"

namespace umbral::mitsuba_file {

MaterialId Materials::standard() {
  if (overrides_.all) return *overrides_.all;
  if (!standard_) standard_ = builder_.add(one_sided(Lambert{grey(0.5f)}), document_.root.place);
  return *standard_;
}

MaterialId Materials::convert(const Element& bsdf) {
  if (!bsdf.id.empty()) seen_.insert(bsdf.id);
  if (const auto override = overrides_.find(bsdf.id); override && bsdf.type != "null") return *override;
  const auto [at, is_new] = converted_.emplace(&bsdf, MaterialId::none);
  if (!is_new) return at->second;
  Draft draft = this->draft(bsdf);
  draft.material.name = bsdf.id;
  if (!draft.is_null) at->second = builder_.add(std::move(draft.material), bsdf.place);
  return at->second;
}

Materials::Draft Materials::draft(const Element& bsdf) {
  if (!being_drafted_.insert(&bsdf).second) {
    builder_.diagnostics.error(bsdf.place, fmt::format("BSDF '{}' has itself in it", bsdf.id));
    return {with_lobe(Lambert{})};
  }
  Draft result = converted_draft(bsdf);
  being_drafted_.erase(&bsdf);
  return result;
}

Materials::Draft Materials::converted_draft(const Element& bsdf) {
  const Properties properties(builder_, document_, bsdf);
  const std::string& type = bsdf.type;
  Draft result;
  if (type == "diffuse") {
    result = diffuse(properties);
  } else if (type == "twosided") {
    result = nested(properties);
    result.material.back = BackSide::same;
  } else if (type == "blendbsdf") {
    result = blend(properties);
  } else if (type == "mask") {
    result = mask(properties);
  } else if (type == "principled") {
    result = principled(properties);
  } else if (type == "normalmap") {
    result = normal_map(properties);
  } else if (type == "bumpmap") {
    result = bump_map(properties);
  } else if (type == "plastic" || type == "roughplastic") {
    result = plastic(properties, type == "roughplastic");
  } else if (type == "conductor" || type == "roughconductor") {
    result = conductor(properties, type == "roughconductor");
  } else if (type == "dielectric" || type == "roughdielectric") {
    result = dielectric(properties, type == "roughdielectric");
  } else if (type == "thindielectric") {
    result = thin_dielectric(properties);
  } else if (type == "null") {
    result.is_null = true;
  } else {
    builder_.lacks(bsdf.place, fmt::format("a BSDF of type '{}'", type));
    result.material = with_lobe(Lambert{grey(0.5f)});
    return result;
  }
  properties.report_unknown();
  return result;
}

Materials::Draft Materials::nested(const Properties& properties) {
  const std::vector<const Element*> bsdfs = properties.objects("bsdf");
  if (bsdfs.size() == 1) return draft(*bsdfs[0]);
  if (bsdfs.empty())
    builder_.diagnostics.error(properties.place(),
                               fmt::format("'{}' wants a BSDF in it", properties.element().type));
  else
    builder_.lacks(properties.place(), "a surface whose two sides differ");
  return bsdfs.empty() ? Draft{with_lobe(Lambert{grey(0.5f)})} : draft(*bsdfs[0]);
}

// Where one of the two is 'null', the other is there in part.
Materials::Draft Materials::blend(const Properties& properties) {
  const std::vector<const Element*> bsdfs = properties.objects("bsdf");
  const Textured<float> weight = textures_.number(properties, "weight", 0.5f);
  if (bsdfs.size() != 2) {
    builder_.diagnostics.error(properties.place(), "'blendbsdf' wants two BSDFs in it");
    return {with_lobe(Lambert{})};
  }
  Draft a = draft(*bsdfs[0]), b = draft(*bsdfs[1]);
  a.material.name = bsdfs[0]->id;
  b.material.name = bsdfs[1]->id;
  if (a.is_null && b.is_null) return a;
  if (a.is_null || b.is_null)
    return {
        partly_there(builder_, std::move(a.is_null ? b : a).material, weight, b.is_null, properties.place())};
  return {mix_of(builder_, std::move(a.material), std::move(b.material), weight, properties.place())};
}

Materials::Draft Materials::mask(const Properties& properties) {
  Draft result = nested(properties);
  result.material.alpha = textures_.number(properties, "opacity", 0.5f);
  return result;
}

Materials::Draft Materials::normal_map(const Properties& properties) {
  Draft result = nested(properties);
  const Textured<Spectrum> map = textures_.surface(properties, "normalmap", level_normal);
  if (map.is_constant())
    builder_.diagnostics.error(properties.place(), "'normalmap' wants a texture of that name");
  else
    result.material.normal_map = map;
  if (std::holds_alternative<Principled>(result.material.lobe))  // there it bends the coat, too
    result.material.clearcoat_normal_map = result.material.normal_map;
  return result;
}

Materials::Draft Materials::bump_map(const Properties& properties) {
  Draft result = nested(properties);
  const Element* texture = properties.object("texture");
  if (texture) result.material.bump_map = {0, textures_.texture(*texture).value_or(TextureId::none)};
  result.material.bump_scale = static_cast<float>(properties.number("scale", 1));
  return result;
}

}  // namespace umbral::mitsuba_file
