#include "skydrop/game/delivery.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace skydrop::game {
namespace {

constexpr double kLeastPathMps = 1;

}  // namespace

void describe(core::SettingsVisitor& v, DeliverySettings& s) {
  v.number("mostPoints", s.mostPoints,
           {.unit = "points",
            .min = 1,
            .max = 100000,
            .help = "Points of a package that lands in the centre at once.",
            .slider = core::Range{100, 10000},
            .aliases = "score, bonus"});
  v.number("edgeShare", s.edgeShare,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "Share of the points that a landing at the edge of the target earns.",
            .aliases = "score, precision"});
  v.number("fadeSeconds", s.fadeSeconds,
           {.unit = "s",
            .min = 1,
            .max = 3600,
            .help = "Time beyond that of the way after which half of the points are left: less hurries more.",
            .slider = core::Range{10, 600},
            .aliases = "score, bonus, hurry"});
  v.flag("startFacesTarget", s.startFacesTarget,
         {.help = "A flight begins, and begins again, with the target ahead, wherever the scene points.",
          .aliases = "start heading"});
}

bool isUsable(const DeliverySettings& s) {
  return std::isfinite(s.mostPoints) && s.mostPoints >= 0 && std::isfinite(s.edgeShare) && s.edgeShare >= 0 &&
         s.edgeShare <= 1 && std::isfinite(s.fadeSeconds) && s.fadeSeconds > 0;
}

std::int64_t pointsOf(const DeliverySettings& s, double distanceM, double radiusM, double seconds,
                      double waySeconds) {
  const bool isRead = isUsable(s) && std::isfinite(distanceM) && std::isfinite(radiusM) &&
                      std::isfinite(seconds) && std::isfinite(waySeconds);
  if (!isRead || radiusM <= 0 || distanceM < 0 || distanceM > radiusM || seconds < 0) return 0;
  const double precision = 1 - (1 - s.edgeShare) * (distanceM / radiusM);
  const double fade = s.fadeSeconds + std::max(waySeconds, 0.0);
  return static_cast<std::int64_t>(std::floor(s.mostPoints * precision * (fade / (fade + seconds)) + 0.5));
}

MissReason missReason(const glm::dvec2& path, const glm::dvec2& miss, const glm::dvec2& stillMiss,
                      double radiusM) {
  const auto length = [](const glm::dvec2& way) { return std::sqrt(way.x * way.x + way.y * way.y); };
  if (!(length(miss) > radiusM)) return MissReason::none;
  if (length(stillMiss) <= radiusM) return MissReason::wind;
  const double speed = length(path);
  if (!(speed >= kLeastPathMps)) return MissReason::away;
  const double along = (miss.x * path.x + miss.y * path.y) / speed;
  const double across = (miss.y * path.x - miss.x * path.y) / speed;  // right of the path: south of east
  if (std::abs(along) >= std::abs(across)) return along > 0 ? MissReason::tooLate : MissReason::tooEarly;
  return across > 0 ? MissReason::right : MissReason::left;
}

std::string_view reasonText(MissReason reason) {
  switch (reason) {
    case MissReason::none:
      return "";
    case MissReason::tooEarly:
      return "dropped too early";
    case MissReason::tooLate:
      return "dropped too late";
    case MissReason::left:
      return "flown past it on the left";
    case MissReason::right:
      return "flown past it on the right";
    case MissReason::wind:
      return "the wind took it";
    case MissReason::away:
      return "dropped elsewhere";
  }
  return "";
}

std::string sentenceOf(const Delivery& d) {
  std::array<char, 128> text{};
  if (d.hit) {
    std::snprintf(text.data(), text.size(), "On target, %.0f m from the centre: %lld points", d.distanceM,
                  static_cast<long long>(d.points));
    return text.data();
  }
  std::snprintf(text.data(), text.size(), "Missed by %.0f m", d.distanceM - d.radiusM);
  std::string sentence = text.data();
  if (const std::string_view reason = reasonText(d.reason); !reason.empty())
    sentence.append(": ").append(reason);
  if (d.onWater) sentence += ", into the water";
  return sentence;
}

}  // namespace skydrop::game
