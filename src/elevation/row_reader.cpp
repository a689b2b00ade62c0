#include "elevation/row_reader.h"

#include <algorithm>
#include <cmath>

namespace skydrop::elevation {
namespace {

// What samples without weight lie on.
constexpr float kNoCells[3 * kPageSide + 4] = {};

}  // namespace

RowReader::RowReader(const Mosaic& mosaic, const SurfaceKernels& kernels, const WorldRect& rect)
    : mosaic_(mosaic), kernels_(kernels), blocks_(mosaic.blocks_) {
  if (mosaic.chart_.isExact()) return;
  const auto cells = mosaic.cellsOf(rect);
  if (!cells) return;
  auto near = mosaic.blocksNear(*cells);
  isCovered_ = !near;
  blocks_ = near ? std::move(*near) : std::vector<FadingBlock>{};
}

bool RowReader::read(glm::dvec2 xz, double step, int count) {
  isOutside_ = false;
  place(xz, step, count);
  if (!fade(count)) return false;
  findCells(count);
  return true;
}

// Samples that the chart does not reach have no weight.
void RowReader::withhold(int from, int past) {
  if (from < past) isOutside_ = true;
  SurfaceRow& row = *row_;
  for (int s = from; s < past; ++s) {
    row.column[s] = row.row[s] = 0;
    row.cellColumn[s] = row.cellRow[s] = -1;
    row.across[s] = row.down[s] = 0;
    row.eastColumn[s] = row.eastRow[s] = row.southColumn[s] = row.southRow[s] = 0;
  }
}

void RowReader::place(glm::dvec2 xz, double step, int count) {
  const Chart& chart = mosaic_.chart_;
  Chart::Row way(chart, xz.y);
  SurfaceRow& row = *row_;
  for (int s = 0; s < count;) {
    const double x = xz.x + s * step;
    if (chart.isExact()) {
      const Chart::Spot spot = way.at(x);
      if (spot.isValid) {
        // A piece that is constant.
        kernels_.places({{{spot.at.x, spot.at.y}}, {{spot.dx.x, spot.dx.y}}, {{spot.dz.x, spot.dz.y}}}, 0, 0,
                        s, s + 1, row);
      } else {
        withhold(s, s + 1);
      }
      ++s;
      continue;
    }
    const ChartPiece* piece = way.pieceAt(x);
    if (piece == nullptr) {
      withhold(s, s + 1);
      ++s;
      continue;
    }
    // All of these are exact: distances are powers of two, and nodes lie at multiples of them.
    const double t = way.inPiece(x), perSample = step / Chart::kNodeM;
    int past = s + std::max(1, static_cast<int>(std::min(std::ceil((1 - t) / perSample), 1.0 * kRowSize)));
    past = std::min(past, count);
    while (past - 1 > s && !chart.hasColumn(xz.x + (past - 1) * step)) --past;
    kernels_.places(*piece, t - s * perSample, perSample, s, past, row);
    s = past;
  }
}

bool RowReader::fade(int count) {
  SurfaceRow& row = *row_;
  const float whole = isCovered_ ? 0 : 1;
  std::fill_n(row.rest, count, whole);
  std::fill_n(row.restColumn, count, 0.0F);
  std::fill_n(row.restRow, count, 0.0F);
  if (isCovered_) return true;
  for (const FadingBlock& block : blocks_) kernels_.fade(block, 0, count, row);
  if (isOutside_) {
    for (int s = 0; s < count; ++s) {
      if (row.cellColumn[s] != -1 || row.eastColumn[s] != 0 || row.eastRow[s] != 0) continue;
      row.rest[s] = 1;
      row.restColumn[s] = row.restRow[s] = 0;
    }
  }
  return std::any_of(row.rest, row.rest + count, [](float rest) { return rest < 1; });
}

void RowReader::findCells(int count) {
  SurfaceRow& row = *row_;
  int first = 0;
  std::int32_t pageColumn = 0, pageRow = 0;
  const float* cells = nullptr;  // of the page's first cell
  const auto finish = [&](int past) {
    kernels_.surface(first, past, row);
    first = past;
  };
  for (int s = 0; s < count; ++s) {
    if (!(row.rest[s] < 1)) {
      row.cells[s] = kNoCells;
      continue;
    }
    const std::int32_t i = row.cellColumn[s], k = row.cellRow[s];
    if (cells == nullptr || i >> 7 != pageColumn || k >> 7 != pageRow) {
      static_assert(kPageCells == 1 << 7);
      pageColumn = i >> 7;
      pageRow = k >> 7;
      auto held = std::find_if(held_.rbegin(), held_.rend(), [&](const Held& page) {
        return page.column == pageColumn && page.row == pageRow;
      });
      if (held == held_.rend()) {
        if (held_.size() == kHeldPages) {
          finish(s);
          held_.clear();
        }
        held_.push_back({pageColumn, pageRow, mosaic_.pageAt(pageColumn, pageRow)});
        held = held_.rbegin();
      }
      cells = held->page->patch(0, 0);
    }
    row.cells[s] = cells + (k - pageRow * kPageCells) * kPageSide + (i - pageColumn * kPageCells);
  }
  finish(count);
}

}  // namespace skydrop::elevation
