#include "skydrop/ui/instruments.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/vec2.hpp>
#include <numbers>

namespace skydrop::ui {
namespace {

constexpr double kPi = std::numbers::pi, kTurn = 2 * kPi, kEnd = 0.75 * kPi;
constexpr double kClimbReach = kPi * 150 / 180;
constexpr double kPitchReach = 0.6;  // radians of pitch from the middle of the dial to its rim
constexpr int kSegments = 48;

constexpr ImU32 kFace = IM_COL32(10, 14, 18, 190), kRim = IM_COL32(0, 0, 0, 220),
                kInk = IM_COL32(240, 244, 248, 255), kFaint = IM_COL32(240, 244, 248, 130),
                kNeedle = IM_COL32(255, 190, 70, 255), kRed = IM_COL32(255, 96, 72, 255),
                kSky = IM_COL32(70, 130, 200, 235), kGround = IM_COL32(116, 84, 52, 235);

double finiteOr0(double value) { return std::isfinite(value) ? value : 0; }

double turnOf(double angle) {
  const double turns = angle / kTurn;
  const double inside = kTurn * (turns - std::floor(turns));
  return inside < kTurn ? inside : 0;
}

// A dial while it is drawn.
struct Dial {
  ImDrawList& list;
  const Interface& context;
  glm::dvec2 middle;
  double radius;

  ImVec2 at(double angle, double share) const {
    return {static_cast<float>(middle.x + std::sin(angle) * share * radius),
            static_cast<float>(middle.y - std::cos(angle) * share * radius)};
  }
  float width(double share) const { return static_cast<float>(std::max(1.0, share * radius)); }
  ImVec2 centre() const { return {static_cast<float>(middle.x), static_cast<float>(middle.y)}; }

  void face() const {
    list.AddCircleFilled(centre(), static_cast<float>(radius), kRim, kSegments);
    list.AddCircleFilled(centre(), static_cast<float>(radius * 0.95), kFace, kSegments);
  }
  void tick(double angle, bool isLong) const {
    list.AddLine(at(angle, isLong ? 0.74 : 0.82), at(angle, 0.92), isLong ? kInk : kFaint, width(0.035));
  }
  void needle(double angle, double length, double half, ImU32 colour) const {
    const glm::dvec2 along(std::sin(angle), -std::cos(angle)), across(-along.y, along.x);
    const auto point = [&](double a, double b) {
      const glm::dvec2 p = middle + (along * a + across * b) * radius;
      return ImVec2(static_cast<float>(p.x), static_cast<float>(p.y));
    };
    list.AddTriangleFilled(point(length, 0), point(-0.1, half), point(-0.1, -half), colour);
    list.AddCircleFilled(centre(), width(0.09), colour, 16);
  }
  // Text of a share of the radius in height, its middle there.
  void words(const char* text, double x, double y, double share, ImU32 colour) const {
    const Typeface& face = context.text();
    // Smaller than the typeface is blurred: it keeps its size where a dial has room for it.
    const float pixels = std::min(face.pixels, static_cast<float>(share * radius));
    if (pixels < 7) return;
    const ImVec2 size = face.face->CalcTextSizeA(pixels, 1e6f, 0, text);
    list.AddText(face.face, pixels,
                 {std::floor(static_cast<float>(middle.x + x * radius) - size.x / 2),
                  std::floor(static_cast<float>(middle.y + y * radius) - size.y / 2)},
                 colour, text);
  }
};

void drawAirspeed(const Dial& d, const InstrumentReadings& r) {
  d.face();
  for (int speed = 0; speed <= static_cast<int>(kAirspeedEndMps); speed += 10)
    d.tick(airspeedNeedle(speed), speed % 40 == 0);
  d.words("m/s", 0, 0.62, 0.4, kInk);
  d.needle(airspeedNeedle(r.airspeedMps), 0.8, 0.07, r.stallWarning ? kRed : kNeedle);
}

void drawAttitude(const Dial& d, const InstrumentReadings& r) {
  d.face();
  const HorizonLine line = horizonLine(r.pitchRad, r.bankRad);
  const double inside = 0.95;
  const auto rim = [&](double angle) { return d.at(angle, inside); };
  const double half = std::acos(std::clamp(line.below / inside, -1.0, 1.0));  // of the part that is ground
  d.list.AddCircleFilled(d.centre(), static_cast<float>(d.radius * inside), kSky, kSegments);
  // The ground is the segment of the circle below the line, whose middle is straight down, turned.
  const double down = kPi + line.turnRad;
  d.list.PathClear();
  for (int i = 0; i <= kSegments; ++i) d.list.PathLineTo(rim(down - half + 2 * half * i / kSegments));
  if (half > 0.01) {
    d.list.PathFillConvex(kGround);
    d.list.AddLine(rim(down - half), rim(down + half), kInk, d.width(0.05));
  } else {
    d.list.PathClear();
  }
  for (const double bank : {-60.0, -30.0, 0.0, 30.0, 60.0}) d.tick(bank * kPi / 180, bank == 0);
  // The wings stay level, and the pointer shows the bank.
  d.list.AddLine(d.at(-kPi / 2, 0.55), d.at(-kPi / 2, 0.18), kNeedle, d.width(0.09));
  d.list.AddLine(d.at(kPi / 2, 0.18), d.at(kPi / 2, 0.55), kNeedle, d.width(0.09));
  d.list.AddCircleFilled(d.centre(), d.width(0.07), kNeedle, 12);
  d.list.AddTriangleFilled(d.at(line.turnRad, 0.82), d.at(line.turnRad + 0.16, 0.62),
                           d.at(line.turnRad - 0.16, 0.62), kInk);
}

void drawAltimeter(const Dial& d, const InstrumentReadings& r) {
  d.face();
  for (int i = 0; i < 10; ++i) d.tick(kTurn * i / 10, i % 5 == 0);
  d.words("alt", 0, 0.45, 0.4, kInk);
  const AltimeterNeedles needles = altimeterNeedles(r.altitudeM);
  d.needle(needles.thousands, 0.5, 0.1, kInk);
  d.needle(needles.hundreds, 0.84, 0.06, kNeedle);
}

void drawCompass(const Dial& d, const InstrumentReadings& r) {
  d.face();
  const double card = compassCard(r.headingRad);
  for (int i = 0; i < 12; ++i) d.tick(card + kTurn * i / 12, i % 3 == 0);
  const char* const names[] = {"N", "E", "S", "W"};
  for (int i = 0; i < 4; ++i) {
    const double angle = card + kTurn * i / 4;
    d.words(names[i], std::sin(angle) * 0.52, -std::cos(angle) * 0.52, 0.46, i == 0 ? kRed : kInk);
  }
  d.list.AddTriangleFilled(d.at(0, 0.66), d.at(0.12, 0.96), d.at(-0.12, 0.96), kNeedle);
}

void drawVariometer(const Dial& d, const InstrumentReadings& r) {
  d.face();
  for (int climb = -20; climb <= 20; climb += 5) d.tick(variometerNeedle(climb), climb % 10 == 0);
  d.words("+", -0.25, -0.42, 0.45, kInk);
  d.words("-", -0.25, 0.42, 0.45, kInk);
  d.words("m/s", 0.5, 0, 0.36, kInk);
  d.needle(variometerNeedle(r.climbMps), 0.8, 0.07, kNeedle);
}

void drawEngine(const Dial& d, const InstrumentReadings& r) {
  d.face();
  for (int i = 0; i <= 10; ++i) d.tick(engineNeedle(0.1 * i), i % 5 == 0);
  d.words("%", 0, 0.6, 0.42, kInk);
  d.needle(engineNeedle(r.throttle), 0.8, 0.07, kNeedle);
}

}  // namespace

InstrumentReadings readingsOf(const game::Snapshot& snapshot) {
  const game::AircraftSnapshot& a = snapshot.aircraft;
  return {finiteOr0(snapshot.air.present ? snapshot.air.indicatedMps : a.airspeedMps),
          finiteOr0(a.pitchRad),
          finiteOr0(a.bankRad),
          finiteOr0(a.position.y),
          finiteOr0(a.headingRad),
          a.crashed ? 0 : finiteOr0(a.velocity.y),
          finiteOr0(a.throttle),
          a.stallWarning};
}

double airspeedNeedle(double mps) {
  return -kEnd + 2 * kEnd * std::clamp(finiteOr0(mps) / kAirspeedEndMps, 0.0, 1.0);
}

AltimeterNeedles altimeterNeedles(double metres) {
  const double height = finiteOr0(metres);
  return {turnOf(kTurn * (height / 1000)), turnOf(kTurn * (height / 10000))};
}

double compassCard(double headingRad) {
  const double heading = turnOf(finiteOr0(headingRad));
  return heading == 0 ? 0 : -heading;
}

double variometerNeedle(double mps) {
  return -kPi / 2 + kClimbReach * std::clamp(finiteOr0(mps) / kClimbEndMps, -1.0, 1.0);
}

double engineNeedle(double throttle) { return -kEnd + 2 * kEnd * std::clamp(finiteOr0(throttle), 0.0, 1.0); }

HorizonLine horizonLine(double pitchRad, double bankRad) {
  double turn = turnOf(-finiteOr0(bankRad));
  if (turn > kPi) turn -= kTurn;
  return {std::clamp(finiteOr0(pitchRad) / kPitchReach, -1.0, 1.0), turn};
}

void drawInstruments(const Interface& context, const InstrumentReadings& readings,
                     const std::array<ScreenRect, kInstruments>& places) {
  constexpr std::array kDrawers = {drawAirspeed, drawAttitude,   drawAltimeter,
                                   drawCompass,  drawVariometer, drawEngine};
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  for (std::size_t i = 0; i < kInstruments; ++i) {
    const ScreenRect& p = places[i];
    const double radius = std::min(p.right - p.left, p.bottom - p.top) / 2.0;
    if (!(radius > 2)) continue;
    kDrawers[i]({list, context, {(p.left + p.right) / 2.0, (p.top + p.bottom) / 2.0}, radius}, readings);
  }
}

}  // namespace skydrop::ui
