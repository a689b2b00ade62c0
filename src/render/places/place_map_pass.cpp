#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "render/places/place_map_data.h"
#include "skydrop/render/places/places_pass.h"

namespace skydrop::render {
namespace {

constexpr int kAheadCells = kPlaceCells / 2 + 3;  // what the next map may ask of
constexpr double kFadeM = 2900, kFarM = 3800;     // within two cells from any place of the middle one
static_assert(kFarM <= (kPlaceCells / 2) * terrain::kPlaceCellM);

std::int64_t cellOf(double metres) {
  const double cell = std::floor(metres / terrain::kPlaceCellM);
  return std::abs(cell) < 1e12 ? static_cast<std::int64_t>(cell) : 0;
}

}  // namespace

PlaceMapPass::PlaceMapPass(gl::Context& context, std::shared_ptr<const terrain::Places> places)
    : context_(context), places_(std::move(places)) {}

void PlaceMapPass::apply(std::shared_ptr<const terrain::Places> places) {
  places_ = std::move(places);
  scene_.cell.reset();
  inset_.reset();
  shown_ = &scene_;
  looked_ = 0;
}

void PlaceMapPass::make(Map& map, const Cell& cell) {
  const PlaceMapData made = placeMapData(*places_, cell.x, cell.z);
  if (!map.grid) {
    map.grid = gl::Texture::make2D(context_, GL_RG32UI, kPlaceGridSide, kPlaceGridSide, "places");
    map.data = gl::Texture::make2D(context_, GL_RGBA32UI, kPlaceRow, kPlaceRows, "ways and fields");
  }
  map.grid.upload(GL_RG_INTEGER, GL_UNSIGNED_INT, std::as_bytes(std::span(made.grid)));
  map.data.upload(GL_RGBA_INTEGER, GL_UNSIGNED_INT, std::as_bytes(std::span(made.data)));
  map.partCount = made.parts.size();
  map.villages = made.villages;
  if (map.partCount > 0 && (!map.parts || map.partCount * sizeof(PlacedPart) > map.parts.size())) {
    map.parts =
        gl::Buffer(context_, 2 * map.partCount * sizeof(PlacedPart), gl::Buffer::Use::write, "buildings");
  }
  if (map.partCount > 0) map.parts.write(0, std::as_bytes(std::span(made.parts)));
  map.published = {&map.grid, &map.data, made.corner, kFadeM, kFarM};
  map.cell = cell;
  ++mapsMade_;
}

// The scene's map is not given up for an eye that looks at the scene from another cell in every other frame.
PlaceMapPass::Map& PlaceMapPass::mapFor(const FrameInput& frame, const Cell& cell) {
  constexpr int kKeptFrames = 60;
  framesWithoutInset_ = frame.isInset ? 0 : std::min(framesWithoutInset_ + 1, kKeptFrames);
  if (framesWithoutInset_ >= kKeptFrames) inset_.reset();
  if (!frame.isInset || !scene_.cell || scene_.cell == cell) return scene_;
  if (!inset_) inset_ = Map{};
  return *inset_;
}

// One village or road a frame, so that the map of the next cell finds all at hand.
void PlaceMapPass::look(const Cell& cell) {
  constexpr std::size_t kSide = 2 * kAheadCells + 1, kEach = 4;
  if (looked_ >= kSide * kSide * kEach) return;
  const std::size_t index = looked_ / kEach;
  const std::int64_t x = cell.x + static_cast<std::int64_t>(index % kSide) - kAheadCells;
  const std::int64_t z = cell.z + static_cast<std::int64_t>(index / kSide) - kAheadCells;
  places_->road(x, z, static_cast<int>(looked_ % kEach));
  ++looked_;
}

void PlaceMapPass::draw(FrameContext& context) {
  const View& view = context.frame.view;
  const Cell cell{cellOf(view.position.x), cellOf(view.position.z)};
  // In frames that nobody sees any map will do: their eye may be in the next cell, between frames that are
  // seen.
  Map& map = mapFor(context.frame, cell);
  if (!map.cell || (map.cell != cell && !context.frame.warmsUp)) {
    make(map, cell);
    if (&map == &scene_) looked_ = 0;
  }
  if (&map == &scene_) look(cell);
  shown_ = &map;
  context.resources.publish(map.published);
}

}  // namespace skydrop::render
