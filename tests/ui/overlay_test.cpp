#include "app/window/overlay.h"

#include <gtest/gtest.h>

#include "app/settings/settings.h"

namespace skydrop::app {
namespace {

TEST(Overlay, theMenuFollowsTheEffectsOfASceneThatIsLoadedAnew) {
  // A section for each effect that the scene calls for now, and none for what it no longer names.
  const Size size{800, 600};
  scene::EffectSet effects;
  effects.insert(scene::Effect::aircraft);
  Overlay overlay(effects, size, {});
  overlay.menuOpen = true;
  Settings settings;
  const core::SettingsTable table(settings);
  const game::Snapshot snapshot;
  const auto hasSection = [&](const char* group) {
    for (int i = 0; i < 2; ++i) overlay.build({snapshot, size, 0, table});
    return overlay.menu().place(std::string("section ") + group) != nullptr;
  };
  EXPECT_TRUE(hasSection("aircraft"));
  EXPECT_FALSE(hasSection("clouds"));
  effects.insert(scene::Effect::clouds);
  overlay.showEffects(effects);
  EXPECT_TRUE(hasSection("aircraft"));
  EXPECT_TRUE(hasSection("clouds"));
  EXPECT_TRUE(hasSection("clouds.march"));
  overlay.showEffects({});
  EXPECT_FALSE(hasSection("aircraft"));
  EXPECT_FALSE(hasSection("clouds"));
}

}  // namespace
}  // namespace skydrop::app
