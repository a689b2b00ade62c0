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
  // Sides of parts, in pixels that are drawn: powers of two.
  static constexpr int kLeastSide = 8, kMostSide = 256, kFirstSide = 16;

  // A square: `side` x `side` pixels, each of them pixelSize x pixelSize of the picture's, the first at
  // `corner` from the lower left. It may reach beyond the picture.
  struct Part {
    glm::ivec2 corner{0};
    int side = kFirstSide, pixelSize = kCoarsest;
  };

  // Of a picture at least 1 x 1; done at once if it is empty. A part should take partMs, as far as the parts
  // of the round before tell.
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

  Size size_;
  double partMs_;
  Part part_;
  double roundMs_ = 0, roundPixels_ = 0, allPixels_ = 0;
};

}  // namespace skydrop::app
