#pragma once

namespace skydrop::render {

// The order of a frame. What is bound when Pass::draw() is called:
//   shadows                  as the next: what is drawn goes to maps of the pass's own
//   terrain, sky, models     the scene: linear light (RGBA16F) and reversed depth (D32F), both written;
//                            the passes of one of these stages may be drawn into a layer (StageLayer)
//   clouds, translucents,    the scene's colour alone: depth can be read as a texture
//   weatherEffects           (FrameContext::sceneDepth)
//   toneMap, hud, menu       the output: RGBA8, sRGB-encoded, no depth
enum class RenderStage {
  shadows,
  terrain,
  sky,
  models,
  clouds,
  translucents,
  weatherEffects,
  toneMap,
  hud,
  menu
};

}  // namespace skydrop::render
