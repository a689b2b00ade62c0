#include "app/session/preparations.h"

namespace skydrop::app {

void Preparations::begin(const scene::EffectSet& effects, Preparation::Maker maker,
                         const Settings& settings) {
  for (const EffectDescriptor& row : table_) {
    if (!row.prepare || !effects.contains(row.effect) || preparations_.contains(row.effect)) continue;
    preparations_.emplace(row.effect, row.prepare(maker, settings));
  }
}

void Preparations::keepOnly(const scene::EffectSet& effects) {
  std::erase_if(preparations_, [&](const auto& entry) { return !effects.contains(entry.first); });
}

const Preparation* Preparations::pending() const {
  for (const auto& [effect, preparation] : preparations_) {
    if (!preparation->isReady()) return preparation.get();
  }
  return nullptr;
}

double Preparations::progress() const {
  if (preparations_.empty()) return 1;
  double sum = 0;
  for (const auto& [effect, preparation] : preparations_) sum += preparation->progress();
  return sum / static_cast<double>(preparations_.size());
}

void Preparations::waitUntilReady() const {
  for (const auto& [effect, preparation] : preparations_) preparation->waitUntilReady();
}

void Preparations::makeParts(render::gl::Context& context) {
  for (const auto& [effect, preparation] : preparations_) {
    if (!preparation->isReady()) preparation->makePart(context);
  }
}

PreparedResources Preparations::results(const scene::EffectSet& effects) const {
  PreparedResources results;
  for (const auto& [effect, preparation] : preparations_) {
    if (effects.contains(effect) && preparation->isReady()) preparation->putResult(results);
  }
  return results;
}

std::vector<std::string> Preparations::takeMessages() {
  std::vector<std::string> all;
  for (const auto& [effect, preparation] : preparations_) {
    const std::vector<std::string> messages = preparation->takeMessages();
    all.insert(all.end(), messages.begin(), messages.end());
  }
  return all;
}

}  // namespace skydrop::app
