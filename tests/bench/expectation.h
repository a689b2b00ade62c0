// What the benchmarks promise. A promise that is not kept is named and makes the program end
// with 1 (main.cpp).
#pragma once

namespace skydrop::bench {

// Notes whether a promise was kept; if not, says so on the error stream.
void expect(bool kept, const char* promise);

// Of all benchmarks run so far.
bool allPromisesKept();

}  // namespace skydrop::bench
