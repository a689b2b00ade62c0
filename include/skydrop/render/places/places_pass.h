// Villages: what the land's colour needs of them, and the houses and hedges that stand (docs/places.md). They
// are part of the scene: lit as the land is, behind clouds and fog.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "skydrop/render/frame/land_ground.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/frame/place_map.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/texture.h"
#include "skydrop/render/gl/vertex_array.h"
#include "skydrop/render/places/places_settings.h"
#include "skydrop/terrain/places.h"

namespace skydrop::render {

// Publishes PlaceMap for the passes that draw the land and what grows on it. Draws nothing.
class PlaceMapPass final : public Pass {
 public:
  // places: those of the land that is drawn, not null.
  PlaceMapPass(gl::Context& context, std::shared_ptr<const terrain::Places> places);

  // For the next frame.
  void apply(std::shared_ptr<const terrain::Places> places);

  std::string_view name() const override { return "placeMap"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  void draw(FrameContext& context) override;

  const terrain::Places& places() const { return *places_; }
  // The buildings of the map, as shaders/places/place_houses.glsl reads them, and how many; middles of the
  // map's villages, world (x, z), m.
  const gl::Buffer& parts() const { return shown_->parts; }
  std::size_t partCount() const { return shown_->partCount; }
  const std::vector<glm::dvec2>& villages() const { return shown_->villages; }

  // Maps that were made so far: for tests.
  std::size_t mapsMade() const { return mapsMade_; }

 private:
  struct Cell {
    std::int64_t x = 0, z = 0;
    bool operator==(const Cell&) const = default;
  };
  struct Map {
    std::optional<Cell> cell;  // its middle; none: to be made
    gl::Texture grid, data;
    gl::Buffer parts;
    std::size_t partCount = 0;
    std::vector<glm::dvec2> villages;
    PlaceMap published;
  };
  Map& mapFor(const FrameInput& frame, const Cell& cell);
  void make(Map& map, const Cell& cell);
  void look(const Cell& cell);

  gl::Context& context_;
  std::shared_ptr<const terrain::Places> places_;
  Map scene_;
  std::optional<Map> inset_;    // where the small picture's eye is in another cell than the scene's
  int framesWithoutInset_ = 0;  // that followed each other
  Map* shown_ = &scene_;        // of the frame that was drawn last
  std::size_t looked_ = 0;      // neighbours that have been found for the maps to come
  std::size_t mapsMade_ = 0;
};

class PlacesPass final : public Pass {
 public:
  // `map`: of the same renderer, must outlive this.
  PlacesPass(gl::Context& context, const PlaceMapPass& map, const PlacesViewSettings& settings);

  // For the next frame.
  void apply(const PlacesViewSettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "places"; }
  RenderStage stage() const override { return RenderStage::terrain; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  std::optional<std::string> skipReasonAfter(const FrameInput& frame,
                                             const FrameResources& resources) const override;
  bool isMirrored() const override { return true; }
  void draw(FrameContext& context) override;

  // How many buildings (parts of them) and pieces of hedges the last frame had. Waits for the GPU: for tests.
  std::array<std::uint32_t, 2> drawn() const;
  // Where walls of the last frame begin, relative to the eye, and how far they go on below. Waits for the
  // GPU: for tests.
  std::vector<glm::vec4> feet() const;

 private:
  gl::ComputeShader& placing(FrameContext& context, const LandGround& land, const char* file) const;
  void place(FrameContext& context, const LandGround& land);

  gl::Context& context_;
  const PlaceMapPass& map_;
  PlacesViewSettings settings_;
  gl::Buffer houseVertices_, hedgeVertices_, indices_, instances_, commands_;
  gl::VertexArray houses_, hedges_;
  GLsizei houseIndices_ = 0, hedgeIndices_ = 0;
  std::size_t houseRoom_ = 0;
};

// Share of the windows that are lit and how bright they look for a sine of the sun's elevation and an
// exposure.
struct WindowsLit {
  double share = 0;
  glm::dvec3 light{0};
};
WindowsLit windowsLit(const PlacesViewSettings& settings, double sunSine, double exposure);

}  // namespace skydrop::render
