#include "app/session/split_reference.h"

#include <gtest/gtest.h>

#include "app/settings/cloud_tier.h"
#include "app/settings/settings_change.h"
#include "skydrop/core/error.h"
#include "support/refusal.h"

namespace skydrop::app {
namespace {

scene::EffectSet everything() {
  scene::EffectSet effects;
  effects.insert(scene::Effect::clouds);
  effects.insert(scene::Effect::terrain);
  effects.insert(scene::Effect::sky);
  return effects;
}

std::string refusalOf(const Settings& present, const std::string& words,
                      const scene::EffectSet& effects = everything()) {
  return test::refusalOf<core::RangeError>([&] { splitReference(present, effects, words); });
}

TEST(SplitReference, differsFromThePresentSettingsInItsSubjectAlone) {
  Settings present;
  present.view.interfaceScale = 2;
  present.clouds.tier = clouds::CloudTier::low;
  const core::SettingsTable before(present);
  SplitReference ofClouds = splitReference(present, everything(), "clouds=reference");
  EXPECT_EQ(ofClouds.settings.clouds.tier, clouds::CloudTier::reference);
  EXPECT_EQ(ofClouds.present, "low");
  const SettingsChange clouds = SettingsChange::between(before, core::SettingsTable(ofClouds.settings));
  EXPECT_GT(clouds.paths().size(), 3u);
  for (const std::string& path : clouds.paths())
    EXPECT_TRUE(path == kCloudTierRow || belongsToCloudTier(path)) << path;
  SplitReference ofLand = splitReference(present, everything(), "land=reference");
  const SettingsChange land = SettingsChange::between(before, core::SettingsTable(ofLand.settings));
  EXPECT_EQ(land.paths(), std::vector<std::string>{"streaming.pixelError"});
  EXPECT_EQ(ofLand.present, "2 px");
  present.render.sky.model = sky::SkyModel::closedForm;
  const core::SettingsTable beforeSky(present);
  SplitReference ofSky = splitReference(present, everything(), "sky=reference");
  const SettingsChange sky = SettingsChange::between(beforeSky, core::SettingsTable(ofSky.settings));
  EXPECT_EQ(sky.paths(), std::vector<std::string>{"render.sky.model"});
  EXPECT_EQ(ofSky.present, "closedForm");
}

TEST(SplitReference, aTierIsTheWholeTierWhateverRowsWereChanged) {
  // Rows that the player had turned do not go into the reference.
  Settings plain, turned;
  turned.clouds.march.transmittanceCutoff = 0.5;
  SplitReference a = splitReference(plain, everything(), "clouds=reference"),
                 b = splitReference(turned, everything(), "clouds=reference");
  EXPECT_TRUE(
      SettingsChange::between(core::SettingsTable(a.settings), core::SettingsTable(b.settings)).empty());
}

TEST(SplitReference, whatCannotBeComparedIsRefusedWithWhatIsPossible) {
  const Settings present;
  for (const auto& [words, names] : std::initializer_list<std::pair<const char*, const char*>>{
           {"birds=reference", "possible are clouds, land, sky"},
           {"sky=fine", "possible is reference"},
           {"clouds=best", "low, medium, high, ultra, reference"},
           {"clouds=off", "low, medium, high, ultra, reference"},
           {"land=fine", "possible is reference"},
           {"clouds", "SUBJECT=REFERENCE"},
           {"=reference", "SUBJECT=REFERENCE"},
           {"clouds=\n", "clouds"}}) {
    const std::string line = refusalOf(present, words);
    EXPECT_TRUE(test::isOneLineAbout(line, names)) << words << ": " << line;
  }
  EXPECT_TRUE(test::isOneLineAbout(refusalOf(present, "clouds=reference", {}), "the scene has no clouds"));
  EXPECT_TRUE(test::isOneLineAbout(refusalOf(present, "land=reference", {}), "the scene has no land"));
}

TEST(SplitReference, whatIsDrawnAlreadyIsNoReference) {
  Settings present = splitReference(Settings(), everything(), "clouds=ultra").settings;
  EXPECT_TRUE(test::isOneLineAbout(refusalOf(present, "clouds=ultra"), "nothing to compare"));
  EXPECT_EQ(refusalOf(present, "clouds=reference"), "");
  present.streaming.pixelError = 0.2;
  EXPECT_TRUE(test::isOneLineAbout(refusalOf(present, "land=reference"), "nothing to compare"));
  EXPECT_TRUE(test::isOneLineAbout(refusalOf(present, "sky=reference"), "nothing to compare"));
  present.clouds.tier = clouds::CloudTier::off;  // no clouds at all against some
  EXPECT_EQ(refusalOf(present, "clouds=ultra"), "");
}

}  // namespace
}  // namespace skydrop::app
