#include <gtest/gtest.h>

#include "skydrop/core/settings_table.h"
#include "skydrop/flight/airplane_settings.h"
#include "skydrop/flight/package_settings.h"
#include "skydrop/game/autopilot.h"
#include "skydrop/game/delivery.h"
#include "skydrop/game/flight_assist.h"
#include "skydrop/game/game_settings.h"

namespace skydrop {
namespace {

template <class Settings>
void expectComplete(std::size_t fields) {
  Settings settings;
  const core::SettingsTable table(settings);
  EXPECT_EQ(table.fields().size(), fields) << "a field is described once, and each is";
  for (const core::Field& field : table.fields()) {
    EXPECT_FALSE(field.help.empty()) << field.path;
    EXPECT_GE(field.defaultValue, field.min) << field.path;
    EXPECT_LE(field.defaultValue, field.max) << field.path;
    EXPECT_GT(field.max, field.min) << field.path;
    EXPECT_TRUE(field.kind == core::FieldKind::choice || field.kind == core::FieldKind::flag ||
                !field.unit.empty())
        << field.path;
  }
}

TEST(FlightSettings, everyTunedNumberIsDescribedWithUnitRangeAndSentence) {
  // The structs of flight and game: one description for each of their fields, defaults inside the ranges.
  expectComplete<flight::AirplaneSettings>(28);
  expectComplete<flight::PackageSettings>(6);
  expectComplete<game::GameSettings>(11);
  expectComplete<game::AutopilotSettings>(5);
  expectComplete<game::DeliverySettings>(4);
  expectComplete<game::AssistSettings>(4);
}

}  // namespace
}  // namespace skydrop
