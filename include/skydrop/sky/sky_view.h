// The sky as seen from one height under one light outside the air: tables over all directions, in the layout
// of shaders/shared/atmosphere_shell.glsl (skyTableRow, skyTableColumn).
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "skydrop/sky/air_tables.h"

namespace skydrop::sky {

// The tables, one after another. All are per irradiance of the light outside the air; `haze` is to be
// multiplied by its phase function, and the rest added. A direction that meets the ground ends there.
enum class SkyLayer {
  skyEven,  // radiance of all the air in a direction, without light scattered once by haze
  skyHaze,  // that light, without its phase function
  left,     // transmittance of all the air
  // The same two as means along the ray, up to the distances of slices: what air of any opacity adds is
  // opacity times this.
  airEven,
  airHaze = airEven + core::shared::f32::kSkySlices
};
inline constexpr int kSkyLayers = 3 + 2 * core::shared::f32::kSkySlices;
// Lower eyes see what one sees from here, m.
inline constexpr double kLeastEyeM = 1;

struct SkyView {
  double horizon = 0;             // sine of the elevation at which the sea ends
  double airEnds = 1;             // sine of the elevation at which the air ends
  std::vector<glm::vec4> texels;  // kSkyLayers of kSkyRows of kSkyColumns; w is 0

  // Interpolated by curves in the layers of the whole sky, in those of the air as a texture is.
  glm::dvec3 at(SkyLayer layer, double sine, double cosAzimuth) const;
  // Of airEven or airHaze, up to a distance in m, >= 0, or infinite.
  glm::dvec3 upTo(SkyLayer layer, double sine, double cosAzimuth, double distanceM) const;

 private:
  glm::dvec3 curveAt(SkyLayer layer, double row, double column) const;
};

// Of the rows [first, last) of all layers: what can be worked out apart. heightM: any finite value, lower
// than kLeastEyeM as there. cosine: of the light's zenith angle.
void makeSkyRows(const AirTables& tables, double heightM, double cosine, int first, int last, SkyView& view);
SkyView makeSkyView(const AirTables& tables, double heightM, double cosine);

}  // namespace skydrop::sky
