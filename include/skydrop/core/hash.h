// Integer hashing: the same bits on every machine, no period in reach.
#pragma once

#include <bit>
#include <cstdint>

namespace skydrop::core {

// A bijection of 64 bits with full avalanche (the finaliser of SplitMix64: Steele, Lea, Flood 2014).
constexpr std::uint64_t mix64(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

constexpr std::uint64_t hashCombine(std::uint64_t seed, std::uint64_t value) {
  return mix64(seed ^ mix64(value));
}

// A stream of random bits from a seed and a counter: stateless but for the counter, so it can be part of a
// hashed simulation state.
struct RandomStream {
  std::uint64_t seed = 0;
  std::uint64_t counter = 0;

  constexpr std::uint64_t next() { return hashCombine(seed, counter++); }
  // Uniform in [0, 1), 53 bits.
  constexpr double nextUnit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
};

// Order-dependent digest of a simulation's state; doubles enter by their bits (so -0 and 0 differ).
class StateHasher {
 public:
  constexpr void add(std::uint64_t value) { hash_ = hashCombine(hash_, value); }
  constexpr void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  constexpr std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0x5be0cd19137e2179ull;
};

}  // namespace skydrop::core
