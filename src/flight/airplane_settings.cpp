#include "skydrop/flight/airplane_settings.h"

namespace skydrop::flight {

void describe(core::SettingsVisitor& v, AirplaneSettings& s) {
  v.number("rollFactor", s.rollFactor,
           {.unit = "1",
            .min = 0,
            .max = 3,
            .help = "Weight of the roll key in the roll torque: more rolls faster."});
  v.number(
      "stabilizingRoll", s.stabilizingRoll,
      {.unit = "1",
       .min = 0,
       .max = 3,
       .help =
           "Weight of the stabiliser in the roll torque: more levels the wings sooner; above rollFactor the "
           "aircraft cannot be rolled on its back."});
  v.number(
      "pitchSpeed", s.pitchSpeed,
      {.unit = "1", .min = 0, .max = 60, .help = "Pitch torque in the thesis's units: more pulls tighter."});
  v.number(
      "yawSpeed", s.yawSpeed,
      {.unit = "1", .min = 0, .max = 100, .help = "Yaw torque in the thesis's units: more skids further."});
  v.number("rollSpeed", s.rollSpeed,
           {.unit = "1",
            .min = 0,
            .max = 100,
            .help = "Roll torque in the thesis's units: more rolls and levels faster."});
  v.number(
      "maxThrottle", s.maxThrottle,
      {.unit = "1",
       .min = 0,
       .max = 1000,
       .help = "Full thrust in the thesis's units (50.139 N each): more is faster; 198 tops at 120 m/s."});
  v.number(
      "inducedYawFactor", s.inducedYawFactor,
      {.unit = "1", .min = 0, .max = 1, .help = "Yaw into the bank: more swings the nose into the turn."});
  v.number(
      "pitchFade", s.pitchFade,
      {.unit = "1",
       .min = 0,
       .max = 1,
       .help = "How much of the elevator fades with the sine of the pitch: at 1, the thesis's law, a held "
               "key ends in a climb; less loops."});
  v.number("stabilizingPitch", s.stabilizingPitch,
           {.unit = "1",
            .min = 0,
            .max = 3,
            .help = "Weight of the stabiliser in the pitch torque: more levels the nose sooner and climbs "
                    "less steeply."});
  v.number("inducedPitchFactor", s.inducedPitchFactor,
           {.unit = "1",
            .min = 0,
            .max = 10,
            .help = "Pitch torque that lowers the nose in a bank, in the thesis's units."});
  v.number("mass", s.mass,
           {.unit = "kg", .min = 200, .max = 10000, .help = "More needs more lift and accelerates less."});
  v.number("cruiseSpeed", s.cruiseSpeed,
           {.unit = "m/s",
            .min = 40,
            .max = 110,
            .help = "Airspeed that the throttle returns to with no key held."});
  v.number(
      "throttleRate", s.throttleRate,
      {.unit = "1/s", .min = 0.05, .max = 10, .help = "How fast the throttle moves: more answers sooner."});
  v.number(
      "rollDamping", s.rollDamping,
      {.unit = "1/s", .min = 0.5, .max = 60, .help = "Angular damping about the nose: more rolls slower."});
  v.number("pitchDamping", s.pitchDamping,
           {.unit = "1/s",
            .min = 0,
            .max = 60,
            .help = "Angular damping of pitch: more swings less after a pull."});
  v.number(
      "yawDamping", s.yawDamping,
      {.unit = "1/s", .min = 0, .max = 60, .help = "Angular damping of yaw: more swings less after a skid."});
  v.number("pitchStiffness", s.pitchStiffness,
           {.unit = "1/s^2",
            .min = 0,
            .max = 400,
            .help = "How strongly the tail turns the nose into the flight path, per radian at 70 m/s: more "
                    "limits the pull."});
  v.number("yawStiffness", s.yawStiffness,
           {.unit = "1/s^2",
            .min = 0,
            .max = 400,
            .help = "How strongly the fin turns the nose into the flight path, per radian at 70 m/s: more "
                    "skids less."});
  v.number("wingArea", s.wingArea,
           {.unit = "m^2", .min = 4, .max = 80, .help = "More carries at lower speeds and drags more."});
  v.number("liftSlope", s.liftSlope,
           {.unit = "1/rad",
            .min = 1,
            .max = 8,
            .help = "Lift per angle of attack: more turns the flight path faster."});
  v.number("stallAngleDeg", s.stallAngleDeg,
           {.unit = "deg", .min = 5, .max = 30, .help = "Angle of attack where the lift stops growing."});
  v.number("stallWarning", s.stallWarning,
           {.unit = "1",
            .min = 0.5,
            .max = 1,
            .help = "Share of the stall angle from which the stall is announced: less warns earlier."});
  v.number("stallLiftLoss", s.stallLiftLoss,
           {.unit = "1", .min = 0, .max = 0.9, .help = "Lift lost in a stall: more drops further."});
  v.number("stallNoseDrop", s.stallNoseDrop,
           {.unit = "1/s^2",
            .min = 0,
            .max = 60,
            .help = "How strongly a stall lowers the nose, at 70 m/s: more recovers sooner."});
  v.number(
      "dragCoefficient", s.dragCoefficient,
      {.unit = "1", .min = 0.005, .max = 0.5, .help = "Linear damping: more is slower at the same thrust."});
  v.number(
      "inducedDrag", s.inducedDrag,
      {.unit = "1", .min = 0, .max = 0.5, .help = "Drag that comes with lift: more loses speed in turns."});
  v.number(
      "sideForceSlope", s.sideForceSlope,
      {.unit = "1/rad", .min = 0, .max = 5, .help = "Side force per sideslip: more turns without banking."});
  v.choice("integrator", s.integrator, kIntegratorNames,
           {.help = "How the motion is advanced; docs/flight.md has the error and the cost of each."});
}

}  // namespace skydrop::flight
