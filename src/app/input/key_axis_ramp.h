// A pair of keys as one lever: keys are on or off, a hand is not. Pressed, the lever leaves the centre
// eases in and out; released, it comes back faster. So a tap is a nudge, and a held key
// is a full deflection that neither the aircraft nor its control surfaces jump to.
#pragma once

namespace skydrop::app {

// Steps of 1/120 s between centre and full deflection.
struct KeyRampTimes {
  int attackSteps = 1;   // outwards, >= 1
  int releaseSteps = 1;  // back, >= 1; a key of the other side brings it back first
};

class KeyAxisRamp {
 public:
  explicit KeyAxisRamp(KeyRampTimes shape) : shape_(shape) {}

  // One step with the key of this side held: -1, 0 (none, or both) or 1. The lever's place, -1 .. 1. The
  // state is a whole number, so the same keys at the same steps give the same bits.
  double step(int side);

 private:
  KeyRampTimes shape_;
  int place_ = 0;  // full deflection is attackSteps * releaseSteps
};

}  // namespace skydrop::app
