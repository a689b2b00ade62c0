#include "skydrop/terrain/terrain_settings.h"

#include <cstdio>
#include <string>

#include "terrain/land_octaves.h"

namespace skydrop::terrain {
namespace {

std::string roundingNote(double metres) {
  const double rounded = roundToPowerOfTwo(metres);
  if (rounded == metres) return "";
  char text[64];
  std::snprintf(text, sizeof text, "Rounded to %.0f m, a power of two.", rounded);
  return text;
}

}  // namespace

void describe(core::SettingsVisitor& visitor, TerrainSettings& s) {
  using core::TakesEffect;
  const auto number = [&](std::string_view name, double& value, std::string_view unit, double min, double max,
                          std::string_view help, std::string_view aliases) {
    visitor.number(name, value,
                   {.unit = unit,
                    .min = min,
                    .max = max,
                    .help = help,
                    .takesEffect = TakesEffect::restart,
                    .aliases = aliases});
  };
  const auto wavelength = [&](std::string_view name, double& value, double min, double max,
                              std::string_view help, std::string_view aliases) {
    visitor.number(name, value,
                   {.unit = "m",
                    .min = min,
                    .max = max,
                    .help = help,
                    .takesEffect = TakesEffect::restart,
                    .logarithmic = true,
                    .powersOfTwo = true,
                    .aliases = aliases,
                    .note = [&value] { return roundingNote(value); }});
  };
  wavelength("continentWavelength", s.continentWavelength, 8192, 131072,
             "Side of the largest lattice cell; more makes larger continents and wider seas.",
             "continent size, scale, frequency");
  number("landBias", s.landBias, "1", -1, 1, "Lifts the land against the sea; more leaves less sea.",
         "sea level, water level");
  number("seaDepth", s.seaDepth, "m", 20, 240, "Depth of the sea far from land.", "ocean, sea floor");
  number("plainHeight", s.plainHeight, "m", 0, 600, "Height of the plains far from the sea.",
         "lowland, elevation");
  wavelength("rangeWavelength", s.rangeWavelength, 4096, 65536,
             "Side of the lattice cell that spaces the mountain ranges; more sets them further apart.",
             "range spacing, scale, frequency");
  number("rangeShare", s.rangeShare, "1", 0, 1, "Share of the land that mountains take.",
         "mountains, amount");
  number("mountainHeight", s.mountainHeight, "m", 0, 1500, "Height of the highest peaks above the plains.",
         "amplitude, elevation");
  wavelength(
      "mountainWavelength", s.mountainWavelength, 1024, 16384,
      "Side of the largest lattice cell of the hills and of the ridges between crests; more makes them "
      "broader.",
      "mountain size, scale, frequency");
  wavelength("valleyWavelength", s.valleyWavelength, 2048, 32768,
             "Side of the lattice cell of the rivers on the plains and the passes through the ranges; more "
             "sets them further apart.",
             "river spacing, scale, frequency");
  number("valleyWidth", s.valleyWidth, "1", 0.01, 1,
         "Width of the valleys of rivers and of the passes, as a share of their noise.", "rivers");
  number("roughness", s.roughness, "1", 0, 2,
         "Depth of what water carves, and of the small relief in the mountains.", "gullies, erosion");
  number("plainRoughness", s.plainRoughness, "1", 0, 2,
         "Strength of the hills and of the small relief on the plains.", "hills");
  wavelength("finestWavelength", s.finestWavelength, 16, 512,
             "Side of the smallest lattice cell; less adds detail and costs time.", "octaves, detail");
}

}  // namespace skydrop::terrain
