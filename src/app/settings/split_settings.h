// The split view: the picture as it is drawn beside one of a reference.
#pragma once

#include <array>
#include <string_view>

#include "skydrop/core/settings.h"

namespace skydrop::app {

// What is compared. Only what has a justified reference that can be drawn.
enum class SplitSubject { clouds, land, sky };
inline constexpr std::array<std::string_view, 3> kSplitSubjectNames = {"clouds", "land", "sky"};

struct SplitSettings {
  SplitSubject subject = SplitSubject::clouds;
  double divider = 0.5;  // of the width, 0 .. 1
  bool heat = false;
};

void describe(core::SettingsVisitor& visitor, SplitSettings& settings);

}  // namespace skydrop::app
