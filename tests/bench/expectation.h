// What the benchmarks promise. A promise that is not kept is named in the report and makes the program end
// with 1 (main.cpp).
#pragma once

#include <benchmark/benchmark.h>

namespace skydrop::bench {

// Notes whether a promise was kept; says so in the benchmark's row if not.
void expect(benchmark::State& state, bool kept, const char* promise);

// Of all benchmarks run so far.
bool allPromisesKept();

}  // namespace skydrop::bench
