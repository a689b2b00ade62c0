#include "game/safe_places.h"

#include "game/state_digest.h"

namespace skydrop::game {
namespace {

constexpr std::size_t kMostPlaces = 120;  // a minute at two notes a second

}  // namespace

void SafePlaces::startFrom(const SafePlace& place) { places_.assign(1, place); }

void SafePlaces::note(const SafePlace& place) {
  if (places_.size() == kMostPlaces) places_.pop_front();
  places_.push_back(place);
}

const SafePlace& SafePlaces::newestBefore(std::uint64_t now, std::uint64_t steps) const {
  const SafePlace* newest = &places_.front();
  for (const SafePlace& place : places_) {
    if (place.step + steps <= now) newest = &place;
  }
  return *newest;
}

void SafePlaces::addTo(core::StateHasher& hash) const {
  for (const SafePlace& place : places_) {
    hash.add(place.step), game::addTo(hash, place.position), hash.add(place.headingRad);
  }
}

}  // namespace skydrop::game
