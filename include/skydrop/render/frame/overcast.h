// How clouds above the eye darken the day around it, in the mean: the air below them, the plain beyond the
// land, and what exposure follows. Land, sea and models have what clouds leave of the light place by place.
#pragma once

namespace skydrop::render {

struct Overcast {
  double cover = 0;    // how even a deck lies above the eye, [0, 1]: 0 under scattered clouds and above all
  double left = 1;     // of the light of sun and sky on level ground, what that deck lets through, (0, 1]
  double baseM = 1e9;  // of the lowest layer of it, above the sea

  // Of all light around the eye, what is left, (0, 1].
  double light() const { return 1 - cover * (1 - left); }
};

}  // namespace skydrop::render
