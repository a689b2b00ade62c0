// Draws endless land and the sea: the mesh's depth alone first, and shadows upon it; then light for each
// pixel from these, so that each pixel is shaded once, and its normal does not depend on how coarse the mesh
// is (docs/terrain-streaming.md).
#pragma once

#include <optional>
#include <vector>

#include "skydrop/render/frame/fullscreen_triangle.h"
#include "skydrop/render/frame/land_ground.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/terrain/chunk_textures.h"
#include "skydrop/render/terrain/ground_texture.h"
#include "skydrop/terrain/strips.h"
#include "skydrop/terrain/terrain_frame.h"
#include "skydrop/terrain/view_volume.h"

namespace skydrop::render {

class CastShadows;
class CloudShadowMap;
class IceShade;
class LandShadowMap;
struct FallenWater;

// The view as EndlessTerrain wants it.
terrain::ViewVolume viewVolume(const View& view);

// Shadows are those that CastShadows, CloudShadowMap and LandShadowMap of the frame hold, where they are
// published.
class TerrainPass final : public Pass, public LandGround {
 public:
  // Alpine belts: plants, rock and snow as high as on the earth, for land of elevation data; else as on the
  // endless land, which is lower.
  explicit TerrainPass(gl::Context& context, bool hasAlpineBelts = false);

  // Carries out the frame's uploads and draws its patches from now on. To be called for each frame that
  // EndlessTerrain makes, before the frame is drawn.
  void take(const terrain::TerrainFrame& frame);

  // The land wears a picture of the ground from now on: a texture, and a variant of its shaders.
  void wear(const terrain::GroundPicture& picture);
  void setWorn(const terrain::GroundPictureSettings& settings) { worn_ = settings; }
  // Null while it wears none.
  const GroundTexture* groundTexture() const { return ground_ ? &*ground_ : nullptr; }

  // The strip that is drawn from now on, where it is in view; none where there is none near. Land for which
  // this is never called has no shader that knows of strips.
  void lay(const std::optional<terrain::Strip>& strip);

  std::string_view name() const override { return "terrain"; }
  RenderStage stage() const override { return RenderStage::terrain; }
  std::optional<std::string> skipReason(const FrameInput& input) const override;
  bool isMirrored() const override { return true; }
  void draw(FrameContext& context) override;

  // Reversed depth of the land alone, without the sea, of the last frame drawn (not of a wireframe).
  const gl::Texture& landDepth() const { return surface_.depthTexture(); }

  // The mesh of the last frame taken, through a program whose vertex shader includes terrain/patch.glsl, and
  // one triangle over the target through a program that includes terrain/surface.glsl; into whatever is
  // bound.
  void drawPatches(gl::Shader& shader, const View& view, GLenum mode);
  void drawLand(gl::Shader& shader, const View& view);

  // For what stands on it: published in each frame in which it is drawn.
  void setGround(gl::ShaderProgram& shader, const View& view) const override;
  void setSurface(gl::ShaderProgram& shader, const View& view) const override;
  glm::dvec2 base() const override { return base_; }
  bool hasAlpineBelts() const override { return hasAlpineBelts_; }

 private:
  struct Instance {
    glm::ivec4 place, source;  // as in shaders/terrain/patch.glsl
  };

  void setEye(gl::ShaderProgram& shader, const View& view) const;
  void setHeights(gl::ShaderProgram& shader) const;
  void setLand(gl::ShaderProgram& shader, const View& view) const;
  void setSea(gl::ShaderProgram& shader, const View& view) const;
  bool isStripSeen(const View& view) const;
  void setStrip(gl::Shader& shader) const;
  void drawLandUpTo(gl::Shader& shader, const View& view, double depth);
  void drawDepth(FrameContext& context);
  void drawMesh(FrameContext& context);
  void drawLitLand(FrameContext& context);
  void drawShadows(FrameContext& context, const CastShadows& shadows);
  void drawCloudShadows(FrameContext& context, const CloudShadowMap& shadowMap);
  void drawIceShade(FrameContext& context, const IceShade& ice);
  // Of all pixels, with a program that is in use: what was there is replaced, or multiplied.
  void drawShares(bool replaces);
  void drawSea(FrameContext& context);
  void drawLines(FrameContext& context);

  gl::Context& context_;
  ChunkTextures textures_;
  gl::Buffer indices_, instances_;
  gl::VertexArray patches_;
  gl::FrameBuffer surface_;  // depth of the land alone, and the share of the sun that shadows leave
  gl::FrameBuffer* drawn_ = &surface_;  // of the view that was drawn last (LandSurface)
  FullscreenTriangle triangle_;
  gl::VertexArray seaPlane_;  // without buffers
  bool hasAlpineBelts_;
  std::optional<GroundTexture> ground_;
  terrain::GroundPictureSettings worn_;
  bool hasStrips_ = false;
  std::optional<terrain::Strip> strip_;
  GLsizei instanceCount_ = 0;
  glm::dvec2 base_{0.0};
  terrain::HeightRange heightRange_;
  terrain::LodDistances lod_;
  double farDistanceM_ = 0, seaFloorDepthM_ = 0;
  double nearestM_ = 0;  // from the eye to the nearest land in view
};

}  // namespace skydrop::render
