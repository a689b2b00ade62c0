#include "skydrop/terrain/terrain_settings.h"

namespace skydrop::terrain {

void describe(core::SettingsVisitor& visitor, TerrainSettings& s) {
  using core::TakesEffect;
  const auto number = [&](std::string_view name, double& value, std::string_view unit, double min, double max,
                          std::string_view help, bool logarithmic = false) {
    visitor.number(name, value, {unit, min, max, help, TakesEffect::rebuild, logarithmic});
  };
  number("continentWavelength", s.continentWavelength, "m", 8192, 131072,
         "Side of the largest lattice cell; more makes larger continents and wider seas.", true);
  number("landBias", s.landBias, "1", -1, 1, "Lifts the land against the sea; more leaves less sea.");
  number("seaDepth", s.seaDepth, "m", 20, 240, "Depth of the sea far from land.");
  number("plainHeight", s.plainHeight, "m", 0, 600, "Height of the plains far from the sea.");
  number("rangeWavelength", s.rangeWavelength, "m", 4096, 65536,
         "Side of the lattice cell that spaces the mountain ranges.", true);
  number("rangeShare", s.rangeShare, "1", 0, 1, "Share of the land that mountains take.");
  number("mountainHeight", s.mountainHeight, "m", 0, 1500, "Height of the highest peaks above the plains.");
  number("mountainWavelength", s.mountainWavelength, "m", 1024, 16384,
         "Side of the largest lattice cell of the hills and of the ridges between crests; more makes them "
         "broader.",
         true);
  number("valleyWavelength", s.valleyWavelength, "m", 2048, 32768,
         "Side of the lattice cell of the rivers on the plains and the passes through the ranges.", true);
  number("valleyWidth", s.valleyWidth, "1", 0.01, 1, "Width of those valleys as a share of their noise.");
  number("roughness", s.roughness, "1", 0, 2,
         "Depth of what water carves, and of the small relief in the mountains.");
  number("plainRoughness", s.plainRoughness, "1", 0, 2, "Strength of the hills on the plains.");
  number("finestWavelength", s.finestWavelength, "m", 16, 512,
         "Side of the smallest lattice cell; less adds detail and costs time.", true);
}

}  // namespace skydrop::terrain
