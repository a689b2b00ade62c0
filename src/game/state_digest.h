// How vectors, body states and settings enter World::stateHash.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>

#include "skydrop/core/hash.h"
#include "skydrop/core/settings.h"
#include "skydrop/flight/rigid_body.h"

namespace skydrop::game {

void addTo(core::StateHasher& hash, const glm::dvec3& v);
void addTo(core::StateHasher& hash, const flight::BodyState& state);

// Feeds every described value into a digest.
class HashingVisitor final : public core::SettingsVisitor {
 public:
  explicit HashingVisitor(core::StateHasher& hash) : hash_(&hash) {}
  void number(std::string_view, double& value, const core::NumberInfo&) override;
  void integer(std::string_view, std::int64_t& value, const core::NumberInfo&) override;
  void flag(std::string_view, bool& value, const core::ChoiceInfo&) override;
  void choiceByIndex(std::string_view, std::function<int()> get, std::function<void(int)>,
                     std::span<const std::string_view>, const core::ChoiceInfo&) override;
  void enterGroup(std::string_view, std::string_view) override {}
  void leaveGroup() override {}

 private:
  core::StateHasher* hash_;
};

}  // namespace skydrop::game
