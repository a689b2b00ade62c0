#include "game/state_digest.h"

namespace skydrop::game {

void addTo(core::StateHasher& hash, const glm::dvec3& v) { hash.add(v.x), hash.add(v.y), hash.add(v.z); }

void addTo(core::StateHasher& hash, const flight::BodyState& s) {
  addTo(hash, s.position), addTo(hash, s.velocity), addTo(hash, s.angularVelocity);
  hash.add(s.orientation.w), hash.add(s.orientation.x), hash.add(s.orientation.y), hash.add(s.orientation.z);
}

void HashingVisitor::number(std::string_view, double& value, const core::NumberInfo&) { hash_->add(value); }

void HashingVisitor::integer(std::string_view, std::int64_t& value, const core::NumberInfo&) {
  hash_->add(static_cast<std::uint64_t>(value));
}

void HashingVisitor::flag(std::string_view, bool& value, const core::ChoiceInfo&) {
  hash_->add(std::uint64_t{value});
}

void HashingVisitor::choiceByIndex(std::string_view, std::function<int()> get, std::function<void(int)>,
                                   std::span<const std::string_view>, const core::ChoiceInfo&) {
  hash_->add(static_cast<std::uint64_t>(get()));
}

}  // namespace skydrop::game
