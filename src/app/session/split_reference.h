// What a picture is compared with in the split view: the settings that are drawn now but for what makes the
// reference of one subject. Pure functions.
#pragma once

#include <string>
#include <string_view>

#include "app/settings/settings.h"
#include "skydrop/scene/effect.h"

namespace skydrop::app {

struct SplitReference {
  SplitSubject subject = SplitSubject::clouds;
  std::string name = "reference";
  std::string present;  // what is drawn now, in a word or two: "medium", "2 px"
  Settings settings;
};

inline constexpr std::string_view kSplitReference = "reference";

// `name`: kSplitReference, or for clouds any tier. Of land it is the reference of the study land-lod. Throws
// core::RangeError in one line where the scene does not have the subject, there is no reference of this name,
// or it is what is drawn anyway.
SplitReference splitReference(const Settings& present, const scene::EffectSet& effects, SplitSubject subject,
                              std::string_view name = kSplitReference);

// The same of "SUBJECT=NAME". Throws core::RangeError for a subject that cannot be compared too.
SplitReference splitReference(const Settings& present, const scene::EffectSet& effects,
                              std::string_view assignment);

}  // namespace skydrop::app
