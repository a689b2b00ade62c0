// What was probably meant by a name that is not known: a hint behind a refusal.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace skydrop::core {

struct KnownName {
  std::string_view name;          // one word, or a path with dots: "render.sun.elevationDegrees"
  std::string_view aliases = {};  // "HG, g": other words for its last part
  std::string_view shownAs = {};  // what to hint at instead: the present name of a former one
};

// The names that are most like `wanted`, best first, at most `most`. Parts of a path count first: a part that
// is there, then one that begins alike, then one that has the word in it, then one with few letters changed;
// the last part of `wanted` counts double. Capitals do not count. Each is there once. Equal likeness keeps
// the order of `known`.
std::vector<std::string> nearestNames(std::string_view wanted, std::span<const KnownName> known,
                                      std::size_t most = 3);

// The same behind a refusal: "; the nearest are 'a', 'b' and 'c'"; nothing where nothing is known.
std::string nearestText(std::string_view wanted, std::span<const KnownName> known);
std::string nearestText(std::string_view wanted, std::span<const std::string_view> known);

}  // namespace skydrop::core
