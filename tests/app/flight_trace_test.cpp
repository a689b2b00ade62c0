#include "app/session/flight_trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "skydrop/core/file.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) out.push_back(cell);
  return out;
}

TEST(FlightTrace, namesItsColumnsAndWritesOneFullRowAStep) {
  // The first line names every column once; each row has as many numbers, and they read back as they were.
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "a.csv";
  FlightTrace trace(file);
  game::Snapshot snapshot;
  snapshot.simulatedSeconds = 1.0 / 120;
  snapshot.aircraft.airspeedMps = 0.1 + 0.2;
  snapshot.aircraft.bankRad = -1;
  trace.append(snapshot);
  trace.append(snapshot);
  trace.flush();
  std::istringstream text(core::readTextFile(file));
  std::string head, row, more, end;
  std::getline(text, head), std::getline(text, row), std::getline(text, more);
  EXPECT_FALSE(std::getline(text, end));
  const std::vector<std::string> names = cells(head), numbers = cells(row);
  ASSERT_EQ(names.size(), numbers.size());
  for (const std::string& name : names) EXPECT_EQ(std::ranges::count(names, name), 1) << name;
  const auto value = [&](const std::string& name) {
    return std::stod(numbers.at(static_cast<std::size_t>(std::ranges::find(names, name) - names.begin())));
  };
  EXPECT_EQ(value("time_s"), 1.0 / 120);
  EXPECT_EQ(value("airspeed_mps"), 0.1 + 0.2);
  EXPECT_NEAR(value("bank_deg"), -57.29577951308232, 1e-12);
  EXPECT_EQ(row, more);
}

TEST(FlightTrace, growsOnTheDiskWithEverySimulatedSecond) {
  // Whatever was there is replaced; at any time all whole seconds are in the file, and at the end every row.
  const test::TemporaryFolder folder;
  const std::string file = folder.write("a.csv", "another table");
  const auto lines = [&] {
    const std::string text = core::readTextFile(file);
    return std::ranges::count(text, '\n');
  };
  {
    FlightTrace trace(file);
    for (int i = 1; i <= 300; ++i) {
      trace.append({});
      ASSERT_EQ(lines(), 1 + i / 120 * 120);
    }
  }
  EXPECT_EQ(lines(), 301);
  EXPECT_FALSE(core::readTextFile(file).starts_with("another"));
}

TEST(FlightTrace, aFullDiskEndsTheTableAndIsToldOnce) {
  FlightTrace trace("/dev/full");
  for (int i = 0; i < 500; ++i) trace.append({});
  EXPECT_TRUE(trace.isIncomplete());
  const auto reason = trace.takeReason();
  ASSERT_TRUE(reason);
  EXPECT_TRUE(reason->starts_with("/dev/full: cannot write: ")) << *reason;
  EXPECT_FALSE(trace.takeReason());
}

}  // namespace
}  // namespace skydrop::app
