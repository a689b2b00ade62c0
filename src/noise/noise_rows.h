// Rows of a noise texture by the kernels of one instruction set: what NoiseGenerator runs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "noise/octave_kernels.h"
#include "skydrop/noise/noise_generator.h"

namespace skydrop::noise {

// Immutable once it is made. Settings and size must have been judged (requireSettings(), requireSize()).
class NoiseRows {
 public:
  NoiseRows(const NoiseSettings& settings, const NoiseSize& size, const OctaveKernels& kernels);

  // As NoiseGenerator::fillRows().
  void fill(int layer, int firstRow, std::span<float> values) const;

 private:
  struct Octave {
    std::uint32_t cells = 0, salt = 0;
    float weight = 0;
    std::vector<std::uint32_t> columns, west, east;  // as in RowInCells
    std::vector<float> inside, fade;

    RowInCells row() const;
  };
  struct Scratch;

  static void place(Octave& octave, int width);
  void add(const Octave& octave, int layer, int firstRow, std::span<float> values, Scratch& scratch) const;

  NoiseSize size_;
  const OctaveKernels& kernels_;
  std::vector<Octave> octaves_;  // without those that are 0 at every texel
};

}  // namespace skydrop::noise
