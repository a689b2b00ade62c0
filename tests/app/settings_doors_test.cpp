// The doors of all settings: what no code behind them has to be ready for is refused there.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "app/settings/settings.h"
#include "skydrop/core/error.h"
#include "skydrop/core/settings_table.h"
#include "support/margin.h"

namespace skydrop::app {
namespace {

TEST(Stability, X56_noSettingTakesWhatItsRangeDoesNotHold) {
  // NaN, infinities, 1e30 and the neighbours outside both ends are refused with the row's path, and change
  // nothing; both ends are taken.
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  Settings settings;
  const core::SettingsTable table(settings);
  int taken = 0, rows = 0;
  for (const core::Field& field : table.fields()) {
    ++rows;
    const double before = field.get();
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), kEndless, -kEndless, 1e30, -1e30,
                             std::nextafter(field.max, kEndless), std::nextafter(field.min, -kEndless)}) {
      if (bad >= field.min && bad <= field.max) continue;
      try {
        setField(field, bad);
        ++taken;
        ADD_FAILURE() << field.path << " takes " << bad;
      } catch (const core::RangeError& error) {
        EXPECT_NE(std::string(error.what()).find(field.path), std::string::npos) << error.what();
      }
      EXPECT_EQ(field.get(), before) << field.path;
    }
    for (const double end : {field.min, field.max})
      EXPECT_NO_THROW(setField(field, end)) << field.path << " " << end;
    field.set(before);
  }
  EXPECT_GT(rows, 200);
  EXPECT_TRUE(test::holds("X56", taken, test::atMost(0), "values taken"));
}

}  // namespace
}  // namespace skydrop::app
