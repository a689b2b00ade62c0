#include "app/session/split_reference.h"

#include <algorithm>
#include <array>
#include <span>

#include "app/settings/cloud_tier.h"
#include "app/settings/settings_change.h"
#include "skydrop/core/error.h"
#include "skydrop/core/joined.h"
#include "skydrop/core/message.h"
#include "skydrop/core/nearest_names.h"

namespace skydrop::app {
namespace {

// One for each SplitSubject. What a subject is but for clouds is one row: that of
// assets/studies/land-lod.json, which doubles it, and the model of the sky that assets/studies/sky.json
// compares with the reference in double precision.
struct Subject {
  scene::Effect effect;
  std::string_view row, reference;
  std::string_view absent;  // what a scene without the effect has none of
};
constexpr std::array<Subject, kSplitSubjectNames.size()> kSubjects = {{
    {scene::Effect::clouds, kCloudTierRow, {}, "clouds with thickness"},
    {scene::Effect::terrain, "streaming.pixelError", "0.2", "land"},
    {scene::Effect::sky, "render.sky.model", "shell", "sky"},
}};

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

void takeRow(const core::SettingsTable& table, const Subject& subject, std::string_view what,
             std::string_view name) {
  if (name != kSplitReference)
    throw core::RangeError(std::string(what) + " has no reference '" + core::printable(name) +
                           "'; possible is " + std::string(kSplitReference));
  core::setField(table, std::string(subject.row) + "=" + std::string(subject.reference));
}

// That a tier has another name makes no other picture.
bool isSamePicture(const SettingsChange& change) {
  return std::ranges::all_of(change.paths(), [](const std::string& path) { return path == kCloudTierRow; });
}

}  // namespace

SplitReference splitReference(const Settings& present, const scene::EffectSet& effects, SplitSubject subject,
                              std::string_view name) {
  const auto index = static_cast<std::size_t>(subject);
  const Subject& of = kSubjects[index];
  const std::string what(kSplitSubjectNames[index]);
  if (!effects.contains(of.effect)) throw core::RangeError("the scene has no " + std::string(of.absent));
  SplitReference reference{subject, std::string(name), {}, present};
  Settings before = present;
  const core::SettingsTable table(reference.settings), tableBefore(before);
  const bool ofClouds = subject == SplitSubject::clouds;
  if (ofClouds) {
    takeTier(table, reference.settings, name);
  } else {
    takeRow(table, of, what, name);
  }
  const core::Field& row = tableBefore.at(of.row);
  reference.present = core::fieldText(row) + (subject == SplitSubject::land ? " px" : "");
  const bool wasOff = ofClouds && present.clouds.tier == clouds::CloudTier::off;
  if (!wasOff && isSamePicture(SettingsChange::between(tableBefore, table)))
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
  if (found == kSplitSubjectNames.end())
    throw core::RangeError("'" + core::printable(subject) +
                           "' has no reference that can be drawn; possible are " +
                           core::joined(kSplitSubjectNames));
  return splitReference(present, effects, static_cast<SplitSubject>(found - kSplitSubjectNames.begin()),
                        assignment.substr(equals + 1));
}

}  // namespace skydrop::app
