// The figures by which an hour becomes a state of the air; docs/forecasts.md gives their reasons.
#pragma once

namespace skydrop::forecast {

// Where there are no figures of the moisture the base of low cloud lies so high above the ground, m.
inline constexpr double kUsualLowBaseM = 1200;
// Of the lifted condensation level, m per degree between temperature and dew point (Espy 1836; Lawrence
// 2005), and within what limits, m above the ground.
inline constexpr double kBaseMPerDegree = 125, kLeastBaseM = 150, kMostBaseM = 1900;

inline constexpr double kStratusBelowM = 350;  // a low base above the ground: stratus
inline constexpr double kBrokenCover = 0.6;    // low cloud that covers more is a sheet, and no cumulus
inline constexpr double kSheetCover = 0.75;    // middle and high cloud that covers more is a sheet

inline constexpr double kMiddleBaseM = 3500, kAltocumulusM = 500, kAltostratusM = 1200;
inline constexpr double kHighBaseM = 8500, kHighM = 800;

// Showers, mm/h: from which on clouds tower, and from which on they are cumulonimbus.
inline constexpr double kToweringFromMm = 0.2, kCumulonimbusFromMm = 2.5;
inline constexpr double kToweringM = 3500;          // from base to top
inline constexpr double kCumulonimbusTopM = 10500;  // above the sea
inline constexpr double kMostTowerCover = 0.35;

// Even rain or snow, mm/h, under so much cloud: nimbostratus.
inline constexpr double kNimbostratusFromMm = 0.2, kNimbostratusCover = 0.6;
inline constexpr double kNimbostratusTopM = 5500;

inline constexpr double kFogVisibilityM = 1000;       // below which there is fog (WMO)
inline constexpr double kKoschmieder = 3.912;         // extinction times visibility, for a contrast of 2 %
inline constexpr double kLikelyFog = 0.5;             // probability from which on there is fog
inline constexpr double kLikelyFogVisibilityM = 500;  // that is assumed of it
inline constexpr double kFogDepthM = 80, kDeepFogDepthM = 200;

inline constexpr double kUsualVisibilityM = 30000;

// Temperature at which all falls as rain, and as snow, degrees (Auer 1974, in round figures).
inline constexpr double kRainFromC = 3, kSnowToC = 0;
// The share of snow within which rain and snow fall as one.
inline constexpr double kSleetFromShare = 0.2, kSleetToShare = 0.8;

inline constexpr double kLapsePerM = 0.0065;  // standard atmosphere of 1976

// Gusts over the mean wind, where the file has none: open land (WMO 2010, guidelines for converting winds).
inline constexpr double kUsualGustShare = 0.45;

// The free air's wind by height where the file has no levels: its speed as a share of that at the gradient
// height, and how far it turns clockwise (anticlockwise south of the equator), degrees.
struct AssumedLevel {
  double heightM, share, turnDeg;
};
inline constexpr AssumedLevel kAssumedLevels[] = {{1500, 1.1, 20}, {5500, 1.7, 25}, {10000, 2.4, 30}};
inline constexpr double kUsualFromDeg = 250;

}  // namespace skydrop::forecast
