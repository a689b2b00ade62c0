#include "app/settings/split_settings.h"

namespace skydrop::app {

void describe(core::SettingsVisitor& visitor, SplitSettings& settings) {
  visitor.choice("subject", settings.subject, kSplitSubjectNames,
                 {.help = "What the split view draws by its reference on the right of the divider.",
                  .aliases = "compare, reference, accuracy"});
  visitor.number("divider", settings.divider,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "Where the split view is divided, as a share of the width from the left.",
                  .slider = core::Range{0.05, 0.95},
                  .aliases = "compare, wipe"});
  visitor.flag(
      "heat", settings.heat,
      {.help = "Shows on the right of the divider how visible the difference is (FLIP), not the reference.",
       .aliases = "heat map, error, FLIP"});
}

}  // namespace skydrop::app
