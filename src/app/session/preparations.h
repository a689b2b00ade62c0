// The preparations that the effects of a scene call for, under way at the same time. Main thread.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/session/effect_table.h"
#include "app/session/preparation.h"

namespace skydrop::app {

class Preparations {
 public:
  // The table says what each effect prepares; it must outlive this.
  explicit Preparations(const std::vector<EffectDescriptor>& table = effectTable()) : table_(table) {}

  // Starts what these effects need with these settings, unless it is under way or done.
  void begin(const scene::EffectSet& effects, Preparation::Maker maker, const Settings& settings);
  // Ends or forgets what none of these effects needs.
  void keepOnly(const scene::EffectSet& effects);

  // The first one that is not ready, null when all are. Throws what ended one early.
  const Preparation* pending() const;
  // All in all, 0 .. 1; 1 where there is nothing to prepare.
  double progress() const;
  // Waits for all. For Maker::processor.
  void waitUntilReady() const;
  // A part of each that is not ready (Preparation::makePart).
  void makeParts(render::gl::Context& context);

  // Of those that are ready and that these effects need.
  PreparedResources results(const scene::EffectSet& effects) const;
  // What to warn of since the last call, a line each.
  std::vector<std::string> takeMessages();

 private:
  const std::vector<EffectDescriptor>& table_;
  std::map<scene::Effect, std::unique_ptr<Preparation>> preparations_;
};

}  // namespace skydrop::app
