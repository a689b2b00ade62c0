// Getting a scene ready behind the loading picture: first what its effects prepare, then shaders and land.
#pragma once

#include <functional>

#include "app/session/preparations.h"
#include "app/session/scene_renderer.h"
#include "app/window/loading_screen.h"

namespace skydrop::app {

class Loading {
 public:
  // Window and overlay must outlive it. `goesOn` is asked between two pictures and looks after the window's
  // events; false: the player has quit.
  Loading(GameWindow& window, Overlay& overlay, std::function<bool()> goesOn);

  // Returns when all of them are ready; false when the player quit before. Throws what ended one early.
  bool prepare(Preparations& preparations);
  // Returns when all the land is there that the snapshot's view shows, or when the player quit.
  void makeLand(SceneRenderer& sceneRenderer, const game::Snapshot& start);

 private:
  GameWindow& window_;
  std::function<bool()> goesOn_;
  LoadingScreen screen_;
};

}  // namespace skydrop::app
