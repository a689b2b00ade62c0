// How the rays of a march are laid out over the picture and its tiles, and what of it the shaders are told.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "render/frame/list_groups.h"
#include "skydrop/clouds/cloud_settings.h"
#include "skydrop/render/gl/functions.h"

namespace skydrop::render {

// Of storage buffers, as in shaders/clouds.
inline constexpr GLuint kTilesBinding = 0, kSpansBinding = 1, kUnderWayBinding = 2, kRaysBinding = 3,
                        kCandidatesBinding = 4;
inline constexpr std::size_t kTaskBytes = 16, kSpansBytes = 128;  // of a tile
// Where a list of tiles has the groups of a dispatch of four each.
inline constexpr std::size_t kFourBytes = 16;

// Whether one dispatch may not reach the end of a ray.
bool isMultiDispatch(const clouds::CloudSettings& settings);
// Pixels.
int tileSideOf(const clouds::CloudSettings& settings);
// Pixels between rays where the picture is smooth.
int widestSpacing(const clouds::CloudSettings& settings);
// Rays so many pixels apart of which the last are at the picture's edge or beyond it, so that all others lie
// between rays twice as far apart.
int raysAcross(int pixels, int spacing, int widest);

// Of all shaders of a frame's march; `ofFrame` are those of its features. flatLoops: as a software renderer
// is fastest with (shaders/clouds/march.glsl); the picture is the same.
std::vector<std::string> marchDefines(std::span<const std::string> ofFrame,
                                      const clouds::CloudSettings& settings, bool flatLoops);
std::vector<std::string> withSpacing(std::span<const std::string> defines, int spacing);
// Of shaders that take the rays of whole tiles, so far apart.
std::vector<std::string> withGroups(std::span<const std::string> defines, int spacing);

}  // namespace skydrop::render
