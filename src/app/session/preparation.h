// What an effect needs before its first frame and what takes long: made beside everything else, from the
// moment the scene is known (EffectDescriptor::prepare).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/session/prepared_resources.h"
#include "skydrop/render/gl/context.h"

namespace skydrop::app {

// Used by the main thread. A thread of its own ends with it, within the time of a slice of work (20 ms).
class Preparation {
 public:
  // Who makes it. A software renderer would hold its window up with every part.
  enum class Maker { processor, graphics };

  virtual ~Preparation() = default;

  // As the loading picture shows it before a percentage: "Making the clouds".
  virtual std::string_view title() const = 0;
  // How much of it is done, 0 .. 1.
  virtual double progress() const = 0;
  // Whether its result is there. Throws what ended it early.
  virtual bool isReady() const = 0;
  // Returns when it is; throws likewise. For Maker::processor.
  virtual void waitUntilReady() const = 0;
  // With Maker::graphics, once a frame until it is ready, on the context's thread. Throws core::DataError
  // (shader).
  virtual void makePart(render::gl::Context& context) = 0;
  // Adds the result once it is ready.
  virtual void putResult(PreparedResources& resources) const = 0;
  // What to warn of since the last call, a line each.
  virtual std::vector<std::string> takeMessages() = 0;
};

}  // namespace skydrop::app
