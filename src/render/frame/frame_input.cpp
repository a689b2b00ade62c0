#include "skydrop/render/frame/frame_input.h"

#include "skydrop/game/snapshot.h"

namespace skydrop::render {

FrameInput gameFrame(const game::Snapshot& snapshot, const View& view, const FrameFeatures& features) {
  return {view, features, snapshot.simulatedSeconds, &snapshot};
}

}  // namespace skydrop::render
