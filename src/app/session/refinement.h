// The order in which a picture that takes long is drawn in parts: all of it coarsely, then again and again
// with pixels half as wide. A value; any thread.
#pragma once

#include <glm/vec2.hpp>

#include "app/types/size.h"

namespace skydrop::app {

class Refinement {
 public:
  // Pixels of the first round are so many of the picture's wide.
  static constexpr int kCoarsest = 8;
  // Sides of parts, in pixels that are drawn: powers of two. Those of the first round are no larger than the
  // second.
  static constexpr int kLeastSide = 8, kMostSideOfFirstRound = 16, kMostSide = 256;

  // Parts before the first round. The first of them may have to compile, and does not count.
  static constexpr int kProbes = 3;

  // A square: `side` x `side` pixels, each of them pixelSize x pixelSize of the picture's, the first at
  // `corner` from the lower left. It may reach beyond the picture.
  struct Part {
    glm::ivec2 corner{0};
    int side = kLeastSide, pixelSize = kCoarsest;
  };

  // Of a picture at least 1 x 1; done at once if it is empty. A part takes some time whatever its size, and
  // more for each pixel: the first is found by a few parts of two sizes in the middle of the picture, which
  // come before the first round; the second by each round. A part should take partMs, or twice what it takes
  // anyway where that is more.
  explicit Refinement(Size size = {0, 0}, double partMs = 40);

  bool isDone() const { return part_.pixelSize == 0; }
  // What is to be drawn next; not once it is done.
  const Part& next() const { return part_; }
  // That has been drawn, and took so long, in milliseconds.
  void drawn(double ms);
  // Of all pixels of all rounds that have been drawn, 0 .. 1.
  double share() const;

 private:
  void beginRound(int pixelSize);
  void probe(double ms);

  Size size_;
  double partMs_;
  Part part_;
  int probes_ = 0;  // that have been drawn
  double smallMs_ = 0, anywayMs_ = 0, msPerPixel_ = 0;
  double roundMs_ = 0, roundPixels_ = 0, roundParts_ = 0, allPixels_ = 0;
};

}  // namespace skydrop::app
