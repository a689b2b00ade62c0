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
    : context_(context), places_(std::move(places)) {
  grid_ = gl::Texture::make2D(context, GL_RG32UI, kPlaceGridSide, kPlaceGridSide, "places");
  data_ = gl::Texture::make2D(context, GL_RGBA32UI, kPlaceRow, kPlaceRows, "ways and fields");
}

void PlaceMapPass::apply(std::shared_ptr<const terrain::Places> places) {
  places_ = std::move(places);
  made_.reset();
  looked_ = 0;
}

void PlaceMapPass::make(const Cell& cell) {
  const PlaceMapData made = placeMapData(*places_, cell.x, cell.z);
  grid_.upload(GL_RG_INTEGER, GL_UNSIGNED_INT, std::as_bytes(std::span(made.grid)));
  data_.upload(GL_RGBA_INTEGER, GL_UNSIGNED_INT, std::as_bytes(std::span(made.data)));
  partCount_ = made.parts.size();
  villages_ = made.villages;
  if (partCount_ > 0 && (!parts_ || partCount_ * sizeof(PlacedPart) > parts_.size())) {
    parts_ = gl::Buffer(context_, 2 * partCount_ * sizeof(PlacedPart), gl::Buffer::Use::write, "buildings");
  }
  if (partCount_ > 0) parts_.write(0, std::as_bytes(std::span(made.parts)));
  map_ = {&grid_, &data_, made.corner, kFadeM, kFarM};
  made_ = cell;
  looked_ = 0;
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
  if (!made_ || (made_ != cell && !context.frame.warmsUp)) make(cell);
  look(cell);
  context.resources.publish(map_);
}

}  // namespace skydrop::render
