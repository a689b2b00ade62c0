#include "skydrop/game/game_settings.h"

namespace skydrop::game {

void describe(core::SettingsVisitor& v, GameSettings& s) {
  v.number("targetRadius", s.targetRadius,
           {.unit = "m",
            .min = 5,
            .max = 1000,
            .help = "A package that lands this close to the centre scores; from the next target on.",
            .aliases = "drop zone"});
  v.number("targetNearest", s.targetNearest,
           {.unit = "m",
            .min = 200,
            .max = 20000,
            .help = "The next target is at least this far from the aircraft.",
            .aliases = "distance"});
  v.number("targetFarthest", s.targetFarthest,
           {.unit = "m",
            .min = 300,
            .max = 40000,
            .help = "The next target is at most this far from the aircraft, if there is land for it.",
            .aliases = "distance"});
  v.number("targetSlopeDeg", s.targetSlopeDeg,
           {.unit = "deg",
            .min = 1,
            .max = 80,
            .help = "Steepest ground on which the next target may lie.",
            .slider = core::Range{1, 45},
            .aliases = "terrain"});
  v.number("dropCooldown", s.dropCooldown,
           {.unit = "s",
            .min = 0,
            .max = 60,
            .help = "Time from one drop to the next.",
            .aliases = "reload time"});
  v.number("landedPackageSeconds", s.landedPackageSeconds,
           {.unit = "s",
            .min = 0,
            .max = 600,
            .help = "How long a package lies before it is removed; from the next landing on.",
            .slider = core::Range{0, 60},
            .aliases = "lifetime"});
  v.number("crashSeconds", s.crashSeconds,
           {.unit = "s",
            .min = 0.1,
            .max = 30,
            .help = "Time from the next crash to the respawn.",
            .aliases = "respawn time"});
  v.number("contactHeight", s.contactHeight,
           {.unit = "m",
            .min = 0,
            .max = 20,
            .help = "Height of the aircraft's middle above its belly: more crashes earlier.",
            .aliases = "collision"});
  v.number("safeHeight", s.safeHeight,
           {.unit = "m",
            .min = 5,
            .max = 1000,
            .help = "A place lower above the ground is not one to respawn at, and the way ahead of it is "
                    "cleared by as much.",
            .aliases = "respawn height"});
  v.number("respawnBackSeconds", s.respawnBackSeconds,
           {.unit = "s",
            .min = 0,
            .max = 30,
            .help = "The respawn goes back at least this long before the crash.",
            .aliases = "rewind"});
  v.number("messageSeconds", s.messageSeconds,
           {.unit = "s",
            .min = 0.5,
            .max = 30,
            .help = "How long the next message shows.",
            .aliases = "text, notification"});
}

}  // namespace skydrop::game
