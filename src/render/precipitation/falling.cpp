#include "render/precipitation/falling.h"

#include "skydrop/game/snapshot.h"

namespace skydrop::render {

std::optional<weather::State> weatherOf(const FrameInput& frame) {
  std::optional<weather::State> state;
  if (frame.game && frame.game->weather)
    state = frame.game->weather.at({frame.view.position.x, frame.view.position.z});
  if (!frame.warmsUp) return state;
  weather::State wet = state.value_or(weather::State());
  wet.precipitation = {.rain = 5, .snow = 1, .sleet = 1, .hail = 1};
  wet.layers[0] = {.genus = weather::Genus::nimbostratus,
                   .baseM = frame.view.position.y + 500,
                   .topM = frame.view.position.y + 2000,
                   .cover = 1};
  return wet;
}

std::optional<std::string> whyDry(const std::optional<weather::State>& state) {
  if (!state) return "no weather";
  if (!(weather::rateOf(state->precipitation) > 0)) return "it is dry";
  if (!weather::feedingLayer(*state)) return "no cloud that it could fall from";
  return std::nullopt;
}

}  // namespace skydrop::render
