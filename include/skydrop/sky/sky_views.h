// Skies of one air from any height and under any light, at little cost from frame to frame.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "skydrop/sky/air_tables.h"
#include "skydrop/sky/sky_view.h"

namespace skydrop::sky {

// A sky is mixed from those at the corners of a cell of a fixed grid of heights and elevations of the light,
// so that it is a function of both whatever was asked for before: the corners are kept, which costs time and
// no change of the result. A light is given by its elevation alone, so sun and moon share the corners. All
// functions from any thread.
class SkyViews {
 public:
  // Where a sky is seen from, and under which light: heightM: any finite value, as makeSkyView has it; sine:
  // of the light's elevation, [-1, 1].
  struct Place {
    double heightM = 0, sine = 0;
    bool operator==(const Place&) const = default;
  };

  explicit SkyViews(const Atmosphere& air) : tables_(air) {}

  // Those of an air: the same object while it is among the last few asked for. Makes its tables where it is
  // not; others who ask meanwhile do not wait.
  static std::shared_ptr<SkyViews> of(const Atmosphere& air);

  const AirTables& tables() const { return tables_; }

  // Makes the corners that are missing: about 2 ms each, none in most frames.
  // The same object as long as no more than one other is asked for (a frame may have a sun and a moon).
  std::shared_ptr<const SkyView> view(double heightM, double sine);
  std::shared_ptr<const SkyView> view(const Place& place) { return view(place.heightM, place.sine); }
  // Rows that view() would make: 25 us each.
  int missingRows(const Place& place);
  // Makes at most so many of them; returns how many it made.
  int makeSome(const Place& place, int rows);
  // Works on the corners that are needed next if height and light go on as they went since the last call: at
  // most so many rows (25 us each). The slices in which tables are rebuilt.
  void prepare(double heightM, double sine, int rows);

 private:
  struct Corner {
    SkyView view;
    int rows = 0;  // that are made
    std::uint64_t used = 0;
  };
  using Node = std::pair<int, int>;  // along heights and elevations

  // Makes up to so many rows; returns how many it made.
  int make(Corner& corner, const Node& node, int rows);
  Corner& cornerAt(const Node& node);
  // The nodes that a sky is mixed from and the share of each; those without a share are left out.
  std::vector<std::pair<Node, float>> nodesOf(const Place& place) const;
  SkyView mixed(double heightM, double sine);

  const AirTables tables_;
  std::mutex mutex_;
  std::map<Node, Corner> corners_;
  std::uint64_t uses_ = 0;
  struct Newest {
    double heightM = 0, sine = 0;
    std::shared_ptr<const SkyView> view;
  };
  std::array<Newest, 2> newest_;
  std::size_t oldest_ = 0;                     // of these two
  double lastHeight_ = 0, lastElevation_ = 0;  // on the grid
  bool goesOn_ = false;                        // those are set
};

}  // namespace skydrop::sky
