#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/verbs.h"
#include "app/console/message.h"
#include "app/console/standard_output.h"
#include "skydrop/sky/refraction.h"
#include "skydrop/sky/rise_and_set.h"

namespace skydrop::app {
namespace {

using Json = nlohmann::ordered_json;

Json timeJson(const std::optional<double>& days) {
  return days ? Json(sky::instantText(sky::instantAt(*days))) : Json(nullptr);
}

Json bodyJson(const sky::Body& body, const sky::Events& events) {
  constexpr const char* kHorizons[] = {"risesAndSets", "staysAbove", "staysBelow"};
  return {{"azimuthDegrees", body.horizontal.azimuthDegrees},
          {"elevationDegrees", body.horizontal.elevationDegrees},
          {"apparentElevationDegrees", sky::refracted(body.horizontal).elevationDegrees},
          {"rightAscensionDegrees", body.rightAscensionDegrees},
          {"declinationDegrees", body.declinationDegrees},
          {"hourAngleDegrees", body.hourAngleDegrees},
          {"distanceKm", body.distanceKm},
          {"radiusDegrees", body.radiusDegrees},
          {"rise", timeJson(events.rise)},
          {"transit", timeJson(events.transit)},
          {"set", timeJson(events.set)},
          {"horizon", kHorizons[static_cast<int>(events.horizon)]}};
}

}  // namespace

int sky(const CommandLine& line) {
  const double days = sky::daysSinceJ2000(line.utc);
  const sky::Place& place = line.place;
  const sky::Body sun = sky::sunAt(days, place);
  const sky::MoonPhase phase = sky::moonPhase(days, place);
  Json report = {{"utc", sky::instantText(line.utc)},
                 {"latitudeDegrees", place.latitudeDegrees},
                 {"longitudeDegrees", place.longitudeDegrees},
                 {"julianDate", sky::julianDate(line.utc)},
                 {"deltaTSeconds", sky::deltaTSeconds(days)},
                 {"siderealDegrees", sky::siderealDegrees(days, place.longitudeDegrees)},
                 {"twilight", sky::twilightName(sky::twilightOf(sun.horizontal.elevationDegrees))},
                 {"sun", bodyJson(sun, sky::sunEvents(days, place))}};
  Json moon = bodyJson(sky::moonAt(days, place), sky::moonEvents(days, place));
  moon["phase"] = phase.phase;
  moon["phaseDegrees"] = phase.phase * 360;
  moon["phaseName"] = sky::phaseName(phase.phase);
  moon["illuminatedFraction"] = phase.illuminatedFraction;
  moon["brightLimbDegrees"] = phase.brightLimbDegrees;
  moon["brightLimbTiltDegrees"] = phase.brightLimbTiltDegrees;
  report["moon"] = moon;
  if (!sky::isAccurate(line.utc)) {
    const char* note = "sun and moon are exact from 1950 to 2050 only; this is less sure";
    report["note"] = note;
    warn(note);
  }
  print("%s\n", report.dump(2).c_str());
  return 0;
}

}  // namespace skydrop::app
