// The instruction sets that row kernels are compiled for (cmake/SkydropRowKernels.cmake): each module's
// kernels are one source of plain loops, compiled once a set behind a table of functions, and give the same
// bits with each. Any thread.
#pragma once

#include <array>

namespace skydrop::core {

// avx512 means F, VL, DQ and BW.
enum class InstructionSet { baseline, sse41, avx2, avx512 };
inline constexpr std::array<InstructionSet, 4> kInstructionSets{
    InstructionSet::baseline, InstructionSet::sse41, InstructionSet::avx2, InstructionSet::avx512};

// Whether processor and system support the set. The baseline is what the whole program is compiled for.
bool supports(InstructionSet set);

}  // namespace skydrop::core
