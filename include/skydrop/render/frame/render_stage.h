#pragma once

namespace skydrop::render {

// The order of a frame. What is bound when Pass::draw() is called:
//   shadows, mirrors         as the next: what is drawn goes to maps of the pass's own. mirrors: pictures
//                            from other eyes (FrameContext::drawMirrored), lit by what shadows publish
//   terrain, sky, skySheets, the scene: linear light (RGBA16F) and reversed depth (D32F), both written;
//   models                   the passes of one of these stages may be drawn into a layer (StageLayer).
//                            skySheets: what lies before the sky at infinity
//   clouds, cloudSheets,     the scene's colour alone: depth can be read as a texture
//   translucents,            (FrameContext::sceneDepth). cloudSheets: clouds without thickness, veiled by
//   weatherEffects, edges    those that have some. edges: what is done to the finished scene
//   toneMap, hud, menu       the output: RGBA8, sRGB-encoded, no depth
enum class RenderStage {
  shadows,
  mirrors,
  terrain,
  sky,
  skySheets,
  models,
  clouds,
  cloudSheets,
  translucents,
  weatherEffects,
  edges,
  toneMap,
  hud,
  menu
};

}  // namespace skydrop::render
