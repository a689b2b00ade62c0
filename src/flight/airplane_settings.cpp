#include "skydrop/flight/airplane_settings.h"

namespace skydrop::flight {

void describe(core::SettingsVisitor& v, AirplaneSettings& s) {
  v.number("rollFactor", s.rollFactor,
           {.unit = "1",
            .min = 0,
            .max = 3,
            .help = "Weight of the roll control in the roll torque: more rolls faster.",
            .aliases = "aileron"});
  v.number(
      "stabilizingRoll", s.stabilizingRoll,
      {.unit = "1",
       .min = 0,
       .max = 3,
       .help =
           "Weight of the stabiliser in the roll torque: more levels the wings sooner; above rollFactor the "
           "aircraft cannot be rolled on its back.",
       .aliases = "wing leveller, self-levelling, stability"});
  v.number("pitchSpeed", s.pitchSpeed,
           {.unit = "1",
            .min = 0,
            .max = 60,
            .help = "Pitch torque of control and stabiliser in the thesis's units: more pulls tighter and "
                    "levels the nose sooner.",
            .aliases = "elevator, pitch rate"});
  v.number("yawSpeed", s.yawSpeed,
           {.unit = "1",
            .min = 0,
            .max = 100,
            .help = "Yaw torque of control and bank in the thesis's units: more skids further.",
            .aliases = "rudder, yaw rate"});
  v.number(
      "rollSpeed", s.rollSpeed,
      {.unit = "1",
       .min = 0,
       .max = 100,
       .help = "Roll torque of control and stabiliser in the thesis's units: more rolls and levels faster.",
       .aliases = "aileron, roll rate"});
  v.number("maxThrottle", s.maxThrottle,
           {.unit = "1",
            .min = 0,
            .max = 1000,
            .help = "Full thrust in the thesis's units (50.139 N each): more is faster; 198 tops at 120 m/s.",
            .aliases = "thrust, engine power, top speed"});
  v.number("inducedYawFactor", s.inducedYawFactor,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "Yaw into the bank: more swings the nose into the turn.",
            .aliases = "turn coordination"});
  v.number("pitchFade", s.pitchFade,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "How much of the elevator fades with the sine of the pitch: at 1, the thesis's law, a "
                    "held control ends in a climb; less loops.",
            .aliases = "elevator"});
  v.number("stabilizingPitch", s.stabilizingPitch,
           {.unit = "1",
            .min = 0,
            .max = 3,
            .help = "Weight of the stabiliser in the pitch torque: more levels the nose sooner and climbs "
                    "less steeply.",
            .aliases = "self-levelling, stability"});
  v.number(
      "inducedPitchFactor", s.inducedPitchFactor,
      {.unit = "1",
       .min = 0,
       .max = 10,
       .help = "Pitch torque that lowers the nose in a bank, in the thesis's units: more drops it further.",
       .aliases = "bank"});
  v.number("mass", s.mass,
           {.unit = "kg",
            .min = 200,
            .max = 10000,
            .help = "More needs more lift and accelerates less.",
            .aliases = "weight"});
  v.number("cruiseSpeed", s.cruiseSpeed,
           {.unit = "m/s",
            .min = 40,
            .max = 110,
            .help = "Airspeed that the throttle returns to with no control held.",
            .aliases = "airspeed"});
  v.number("throttleRate", s.throttleRate,
           {.unit = "1/s",
            .min = 0.05,
            .max = 10,
            .help = "How fast the throttle moves: more answers sooner.",
            .aliases = "spool, engine response"});
  v.number("rollDamping", s.rollDamping,
           {.unit = "1/s",
            .min = 0.5,
            .max = 60,
            .help = "Angular damping about the nose: more rolls slower.",
            .aliases = "drag"});
  v.number("pitchDamping", s.pitchDamping,
           {.unit = "1/s",
            .min = 0,
            .max = 60,
            .help = "Angular damping of pitch: more swings less after a pull.",
            .aliases = "drag"});
  v.number("yawDamping", s.yawDamping,
           {.unit = "1/s",
            .min = 0,
            .max = 60,
            .help = "Angular damping of yaw: more swings less after a skid.",
            .aliases = "drag"});
  v.number("pitchStiffness", s.pitchStiffness,
           {.unit = "1/s^2",
            .min = 0,
            .max = 400,
            .help = "How strongly the tail turns the nose into the flight path, per radian at 70 m/s: more "
                    "limits the pull.",
            .aliases = "tail, weathervane, longitudinal stability"});
  v.number("yawStiffness", s.yawStiffness,
           {.unit = "1/s^2",
            .min = 0,
            .max = 400,
            .help = "How strongly the fin turns the nose into the flight path, per radian at 70 m/s: more "
                    "skids less.",
            .aliases = "fin, weathervane, directional stability"});
  v.number("wingArea", s.wingArea,
           {.unit = "m^2",
            .min = 4,
            .max = 80,
            .help = "More carries at lower speeds and drags more.",
            .aliases = "lift, wing loading"});
  v.number("liftSlope", s.liftSlope,
           {.unit = "1/rad",
            .min = 1,
            .max = 8,
            .help = "Lift per angle of attack: more turns the flight path faster.",
            .aliases = "lift coefficient"});
  v.number("stallAngleDeg", s.stallAngleDeg,
           {.unit = "deg",
            .min = 5,
            .max = 30,
            .help = "Angle of attack where the lift stops growing; the trim that carries the weight counts.",
            .aliases = "AoA, angle of attack"});
  v.number("stallWarning", s.stallWarning,
           {.unit = "1",
            .min = 0.5,
            .max = 1,
            .help = "Share of the stall angle from which the stall is announced and the picture shakes: less "
                    "warns earlier.",
            .aliases = "stick shaker, horn, buffet"});
  v.number("stallLiftLoss", s.stallLiftLoss,
           {.unit = "1",
            .min = 0,
            .max = 0.9,
            .help = "Lift lost in a stall: more drops further.",
            .aliases = "stall"});
  v.number("stallNoseDrop", s.stallNoseDrop,
           {.unit = "1/s^2",
            .min = 0,
            .max = 60,
            .help = "How strongly a stall, and what comes shortly before it, lowers the nose, at 70 m/s: "
                    "more recovers sooner.",
            .aliases = "stall"});
  v.number(
      "dragCoefficient", s.dragCoefficient,
      {.unit = "1",
       .min = 0.005,
       .max = 0.5,
       .help =
           "Drag without lift, which grows with the square of the speed: more is slower at the same thrust.",
       .aliases = "linear damping, air resistance, parasitic drag"});
  v.number("inducedDrag", s.inducedDrag,
           {.unit = "1",
            .min = 0,
            .max = 0.5,
            .help = "Drag that comes with lift: more loses speed in turns.",
            .aliases = "lift drag"});
  v.number("sideForceSlope", s.sideForceSlope,
           {.unit = "1/rad",
            .min = 0,
            .max = 5,
            .help = "Side force per sideslip: more turns without banking.",
            .aliases = "sideslip"});
  v.choice("integrator", s.integrator, kIntegratorNames,
           {.help = "How the motion is advanced; docs/flight.md has the error and the cost of each.",
            .aliases = "RK4, Euler, physics"});
}

}  // namespace skydrop::flight
