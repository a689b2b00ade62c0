// Under a sanitizer code runs 5 to 20 times as long, and what is looked for are faults of memory and threads,
// which need no statistics: tests that repeat for the sake of numbers repeat less.
#pragma once

namespace skydrop::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kInstrumented = true;
#else
inline constexpr bool kInstrumented = false;
#endif

// How often to repeat: `count`, or a twentieth of it under a sanitizer.
constexpr int repetitions(int count) { return kInstrumented ? (count + 19) / 20 : count; }

}  // namespace skydrop::test
