// The shadows that aircraft and packages cast on the land: for each caster a map of its outline as the sun
// sees it, and the volume of air behind it in which the land may be in shadow.
//
// A map holds coverage (1: the sun is hidden), with mip levels, parallel to the sun and around the caster's
// middle. The land looks it up (shaders/shadow/cast_shadows.glsl) with a disc as wide as the sun's own disc
// is seen from there: a shadow blurs and fades with the distance from its caster. Positions are relative to
// the eye.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "skydrop/render/frame/view.h"
#include "skydrop/render/gl/context.h"
#include "skydrop/render/gl/frame_buffer.h"
#include "skydrop/render/gl/shader.h"
#include "skydrop/render/gl/vertex_array.h"

namespace skydrop::render {

struct CastShadow {
  glm::dvec3 middle{0};  // of the caster
  glm::dvec3 right{0}, up{0},
      down{0};               // unit: the map's axes, and the way of the sunlight. right x up = -down
  double radiusM = 0;        // of a ball around `middle` that holds the caster
  double lengthM = 0;        // how far behind the middle land may lie
  double reachM = 0;         // at this distance the shadow has faded away
  double pixelAngleRad = 0;  // of the picture: a pixel shows the mean over its width

  double mapHalfWidthM() const;
  // Half the side of the square in which pixels may be touched at a distance behind the middle: penumbra
  // included.
  double halfWidthM(double behindM) const;
};

// The shadow of a ball of `radiusM` around a world position, whose outline has `areaM2`; toSun: unit vector,
// above the horizon.
CastShadow castShadow(const View& view, const glm::dvec3& middle, double radiusM, double areaM2,
                      const glm::dvec3& toSun);

// False where the whole volume lies beyond one side of the picture. One beyond a corner may pass.
bool isVolumePotentiallyVisible(const View& view, const CastShadow& shadow);

// Eye-relative positions to the clip space of the shadow's map.
glm::mat4 toShadowMap(const CastShadow& shadow);

// The shadows of one frame and their maps: a resource of the frame (FrameResources), owned and published by
// ShadowPass, read by whoever lights land. Without shadows it holds no GL object.
class CastShadows {
 public:
  static constexpr std::size_t kMost = 4;     // in one frame
  static constexpr GLsizei kMapTexels = 256;  // a side: 5 cm on the aircraft
  static constexpr GLuint kMapUnit = 9;       // as in shaders/shadow/cast_shadows.glsl

  bool empty() const { return shadows_.empty(); }
  void clear() { shadows_.clear(); }
  // Adds a shadow (at most kMost) and returns its map, to be drawn into: coverage, as a target without depth.
  gl::FrameBuffer& add(gl::Context& context, const CastShadow& shadow);
  // After the maps were drawn: makes their mip levels.
  void finish();

  // Draws the volume of each shadow with a program of shadow/volume.vert and shadow/cast_shadows.glsl, which
  // is in use. Each ray from the eye meets the inner faces of a volume once, its outer faces once or never.
  void drawVolumes(gl::Shader& shader) const;

 private:
  struct Map {
    gl::Texture texture;
    gl::FrameBuffer target;
  };
  std::vector<Map> maps_;
  std::vector<CastShadow> shadows_;
  gl::VertexArray empty_;
};

}  // namespace skydrop::render
