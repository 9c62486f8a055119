// Directives of transforms and of the graphics state.
#include <fmt/format.h>

#include "formats/pbrt/directives.h"

namespace umbral::pbrt_file {

void Directives::push(char kind) {
  constexpr std::size_t deepest = 100000;
  if (saved_.size() >= deepest) fail(tokens_->peek(), "attributes are nested without end");
  saved_.emplace_back(kind, state_);
}

void Directives::pop(char kind, const Token& at) {
  if (saved_.empty() || saved_.back().first != kind)
    fail(at, fmt::format("'{}' has no Begin that it ends", at.text));
  if (kind == 'T')
    state_.to_world = saved_.back().second.to_world;
  else
    state_ = std::move(saved_.back().second);
  saved_.pop_back();
}

void Directives::attribute(const Token& at) {
  const std::string target = text();
  Parameters given = parameters(at);
  const auto [entry, is_new] = state_.defaults.emplace(target, given);
  if (is_new) return;
  given.add_defaults(entry->second);
  entry->second = std::move(given);
}

void Directives::scale(const Token& at) {
  const Vec3d factors = vector();
  if (factors.x == 0 || factors.y == 0 || factors.z == 0)
    builder_.diagnostics.error(tokens_->place(at), "a scale of 0 flattens everything");
  else
    transform(scaling(factors));
}

void Directives::rotate(const Token& at) {
  const double degrees = number();
  const Vec3d axis = vector();
  if (glm::length(axis) > 0)
    transform(rotation(glm::normalize(axis), glm::radians(degrees)));
  else
    builder_.diagnostics.error(tokens_->place(at), "the axis of a rotation has no direction");
}

// From the world to a camera at `eye` that looks along +z with y up, left-handed as pbrt has it.
void Directives::look_at(const Token& at) {
  const Vec3d eye = vector(), target = vector(), up = vector();
  const Vec3d view = target - eye;
  const Vec3d right = cross(up, view);
  if (!(glm::length(view) > 0) || !(glm::length(right) > 1e-9 * glm::length(view) * glm::length(up))) {
    builder_.diagnostics.error(tokens_->place(at), "LookAt has no direction, or looks along its up");
    return;
  }
  const Vec3d z = glm::normalize(view), x = glm::normalize(right);
  transform(inverse(Affine{glm::dmat3(x, cross(z, x), z), eye}));
}

void Directives::coordinate_system(const Token&) { systems_[text()] = state_.to_world; }

void Directives::coord_sys_transform(const Token& at) {
  const std::string name = text();
  if (const auto found = systems_.find(name); found != systems_.end())
    state_.to_world = found->second;
  else
    builder_.diagnostics.error(tokens_->place(at), fmt::format("there is no coordinate system '{}'", name));
}

void Directives::active_transform(const Token& at) {
  const Token which = tokens_->next();
  if (which.text != "All" && which.text != "StartTime" && which.text != "EndTime")
    fail(which, "ActiveTransform wants All, StartTime or EndTime");
  if (which.text != "All") builder_.lacks(tokens_->place(at), "movement while the shutter is open");
}

void Directives::transform_times(const Token&) {
  number();
  number();
}

void Directives::color_space(const Token& at) {
  const std::string name = text();
  if (name != "srgb") builder_.lacks(tokens_->place(at), fmt::format("the colour space '{}'", name));
}

void Directives::option(const Token&) { parameter(); }

void Directives::accelerator(const Token& at) {
  text();
  parameters(at);
}

void Directives::film(const Token& at) {
  const std::string kind = text();
  settings_.film(kind, parameters(at));
}

void Directives::filter(const Token& at) {
  const std::string kind = text();
  settings_.filter(kind, parameters(at));
}

void Directives::sampler(const Token& at) {
  const std::string kind = text();
  settings_.sampler(kind, parameters(at));
}

void Directives::integrator(const Token& at) {
  const std::string kind = text();
  settings_.integrator(kind, parameters(at));
}

void Directives::camera(const Token& at) {
  std::string kind = text();
  settings_.camera(std::move(kind), parameters(at), state_.to_world * inverse(inclusion_.to_world));
  systems_["camera"] = inverse(state_.to_world);
}

void Directives::world_begin(const Token& at) {
  if (in_world_) fail(at, "there is a second WorldBegin");
  in_world_ = true;
  state_.to_world = {};
  systems_["world"] = {};
  settings_.finish(integrators_);
}

}  // namespace umbral::pbrt_file
