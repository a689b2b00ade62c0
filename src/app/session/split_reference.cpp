#include "app/session/split_reference.h"

#include <algorithm>
#include <span>

#include "app/settings/cloud_tier.h"
#include "app/settings/settings_change.h"
#include "skydrop/core/error.h"
#include "skydrop/core/joined.h"
#include "skydrop/core/message.h"
#include "skydrop/core/nearest_names.h"

namespace skydrop::app {
namespace {

// Of assets/studies/land-lod.json, which doubles it.
constexpr std::string_view kLandReference = "streaming.pixelError=0.2";
constexpr std::string_view kLandRow = "streaming.pixelError";

void takeTier(const core::SettingsTable& table, Settings& settings, std::string_view name) {
  const auto found = std::ranges::find(clouds::kCloudTierNames, name);
  if (found == clouds::kCloudTierNames.end() || name == "off")
    throw core::RangeError("clouds have no reference '" + core::printable(name) + "'; possible are " +
                           core::joined(std::span(clouds::kCloudTierNames).subspan(1)));
  settings.clouds.tier = static_cast<clouds::CloudTier>(found - clouds::kCloudTierNames.begin());
  Settings defaults;
  const core::SettingsTable defaultTable(defaults);
  for (const core::Field& field : defaultTable.fields()) {
    if (belongsToCloudTier(field.path)) table.at(field.path).set(field.get());
  }
  applyCloudTier(table, readCloudTier(cloudTierPath(settings.clouds.tier)));
}

void takeLand(const core::SettingsTable& table, std::string_view name) {
  if (name != kSplitReference)
    throw core::RangeError("land has no reference '" + core::printable(name) + "'; possible is " +
                           std::string(kSplitReference));
  core::setField(table, kLandReference);
}

// That a tier has another name makes no other picture.
bool isSamePicture(const SettingsChange& change, bool clouds) {
  return std::ranges::all_of(change.paths(),
                             [&](const std::string& path) { return clouds && path == kCloudTierRow; });
}

}  // namespace

SplitReference splitReference(const Settings& present, const scene::EffectSet& effects, SplitSubject subject,
                              std::string_view name) {
  const bool ofClouds = subject == SplitSubject::clouds;
  const std::string what(kSplitSubjectNames[static_cast<std::size_t>(subject)]);
  if (!effects.contains(ofClouds ? scene::Effect::clouds : scene::Effect::terrain))
    throw core::RangeError("the scene has no " + what + (ofClouds ? " with thickness" : ""));
  SplitReference reference{subject, std::string(name), {}, present};
  Settings before = present;
  const core::SettingsTable table(reference.settings), tableBefore(before);
  if (ofClouds) {
    takeTier(table, reference.settings, name);
    reference.present = clouds::kCloudTierNames[static_cast<std::size_t>(present.clouds.tier)];
  } else {
    takeLand(table, name);
    reference.present = core::fieldText(tableBefore.at(kLandRow)) + " px";
  }
  const bool wasOff = ofClouds && present.clouds.tier == clouds::CloudTier::off;
  if (!wasOff && isSamePicture(SettingsChange::between(tableBefore, table), ofClouds))
    throw core::RangeError("'" + std::string(name) + "' is how " + what + (ofClouds ? " are" : " is") +
                           " drawn already: there is nothing to compare");
  return reference;
}

SplitReference splitReference(const Settings& present, const scene::EffectSet& effects,
                              std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string_view subject = assignment.substr(0, equals);
  const auto found = std::ranges::find(kSplitSubjectNames, subject);
  if (equals == std::string_view::npos || equals == 0)
    throw core::RangeError("'" + core::printable(assignment) + "' is not SUBJECT=REFERENCE");
  if (found == kSplitSubjectNames.end()) {
    const std::string why = subject == "sky"
                                ? "the sky's reference integral is not drawn (skydrop accuracy "
                                  "sky-scattering compares it in numbers)"
                                : "'" + core::printable(subject) + "' has no reference that can be drawn";
    throw core::RangeError(why + "; possible are " + core::joined(kSplitSubjectNames));
  }
  return splitReference(present, effects, static_cast<SplitSubject>(found - kSplitSubjectNames.begin()),
                        assignment.substr(equals + 1));
}

}  // namespace skydrop::app
