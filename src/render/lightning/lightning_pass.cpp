#include "skydrop/render/lightning/lightning_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/cloud_transmittance.h"

namespace skydrop::render {
namespace {

constexpr GLuint kGlowDepthUnit = 0, kChannelDepthUnit = 8;  // as in shaders/lightning

// Of a channel of some 25 000 K (Orville 1968) as the eye has it, of luminance 1.
constexpr glm::dvec3 kColor{0.84, 0.99, 1.51};

// Two thirds of a light within a cloud leave it downwards, into half of all directions (photons followed in
// tests/unit/lightning_test.cpp).
constexpr double kBelowCloud = 1.3;
constexpr double kLeastAboveBaseM = 300;
constexpr double kNearestShownM = 800;  // a flash is not held down more for being nearer
constexpr double kFaintest = 1.0 / 512;
// The lens of an eye blurs a line by so much, rad; a pixel by more, in most pictures.
constexpr double kEyeBlurRad = 6e-4;
constexpr double kLeastSpreadPixels = 0.65;
// The line's own glow: so much of its light, so many times as wide, drawn in so many pieces.
constexpr double kGlowShare = 0.03;
constexpr float kGlowWidth = 8;
constexpr std::size_t kGlowPieces = 16;
constexpr std::array<std::uint16_t, 6> kCorners = {0, 1, 2, 3, 4, 5};

glm::dvec2 level(const glm::dvec3& place) { return {place.x, place.z}; }

std::optional<weather::Flash> shining(const FrameInput& frame, const weather::LightningSettings& settings) {
  if (!frame.game || !frame.game->weather) return std::nullopt;
  const std::vector<weather::Flash> all = weather::flashesShining(
      frame.game->weather, settings, frame.game->weather.seconds, level(frame.view.position));
  return all.empty() ? std::nullopt : std::optional(all.front());
}

// A flash before the eye that shines nothing: for frames that nobody sees.
weather::Flash unseen(const glm::dvec3& eye) {
  weather::Flash flash;
  flash.toGround = true;
  flash.from = eye + glm::dvec3(900, 300, 0);
  flash.to = eye + glm::dvec3(900, -300, 100);
  flash.cloudBaseM = eye.y;
  flash.strokes[0] = {0, 1};
  flash.strokeCount = 1;
  return flash;
}

}  // namespace

std::optional<std::string> LightningLightPass::skipReason(const FrameInput& frame) const {
  if (!frame.game) return "no game";
  if (frame.warmsUp) return std::nullopt;
  if (!frame.game->weather) return "no weather";
  if (settings_.brightness <= 0) return "no brightness";
  if (!shining(frame, settings_)) return "no flash at this moment";
  return std::nullopt;
}

void LightningLightPass::draw(FrameContext& context) {
  const FrameInput& frame = context.frame;
  const glm::dvec3& eye = frame.view.position;
  const std::optional<weather::Flash> now = shining(frame, settings_);
  const weather::Flash flash = now ? *now : unseen(eye);
  if (flash.seed != lit_.flash.seed || flash.from != lit_.flash.from || lit_.channel.pieces.empty())
    lit_.channel = weather::channelOf(flash, flash.toGround ? groundM_(level(flash.to)) : -1e9);
  lit_.flash = flash;

  double nearestM = 2 * weather::kLightningSightM;
  for (const glm::dvec3& place : lit_.channel.lights) nearestM = std::min(nearestM, glm::length(place - eye));
  nearestM = std::max(nearestM, kNearestShownM);
  const double most = weather::kFlashIntensityKcd * settings_.brightness * flash.strength;
  const double shownMost = most * context.light.exposure / (nearestM * nearestM) / std::numbers::pi;
  const double brightness = now ? weather::brightnessAt(flash, settings_, frame.game->weather.seconds) : 0;
  lit_.intensityKcd =
      weather::kFlashIntensityKcd * brightness * context.light.exposure / (1 + shownMost / kMostShown);

  const double partM = lit_.channel.mainLengthM / weather::Channel::kLights;
  const double core = std::max(0.5 * partM, 50.0);
  for (std::size_t i = 0; i < weather::Channel::kLights; ++i) {
    const glm::dvec3& place = lit_.channel.lights[i];
    const bool isOpen = place.y < flash.cloudBaseM;
    const double share = (isOpen ? 1 : kBelowCloud) / weather::Channel::kLights;
    lit_.light.places[i] = glm::vec4(relativeToEye(frame.view, place), static_cast<float>(core * core));
    lit_.light.lights[i] = glm::vec4(glm::vec3(kColor * (lit_.intensityKcd * share)), isOpen ? 1.0f : 0.0f);
  }
  context.resources.publish(lit_);
  if (frame.warmsUp || shownMost > kFaintest) context.resources.publish(lit_.light);
}

LightningPass::LightningPass(gl::Context& context)
    : pieces_(context, (weather::kMostPieces + kGlowPieces) * sizeof(Piece), gl::Buffer::Use::write,
              "pieces of a channel"),
      corners_(
          gl::Buffer::of<std::uint16_t>(context, kCorners, gl::Buffer::Use::fixed, "corners of a piece")),
      array_(context, "channel"),
      triangle_(context) {
  array_.setIndexBuffer(corners_);
  array_.setVertexBuffer(0, pieces_, 0, sizeof(Piece), 1);
  array_.setAttribute(0, 0, 4, GL_FLOAT, 0);
  array_.setAttribute(1, 0, 4, GL_FLOAT, sizeof(glm::vec4));
}

std::optional<std::string> LightningPass::skipReasonAfter(const FrameInput&,
                                                          const FrameResources& resources) const {
  if (!resources.find<LitFlash>()) return "no flash at this moment";
  return std::nullopt;
}

void LightningPass::draw(FrameContext& context) {
  const auto* lit = context.resources.find<LitFlash>();
  const gl::Functions& api = context.gl.api();
  api.Enable(GL_BLEND);
  api.BlendFunc(GL_ONE, GL_ONE);
  drawGlow(context, *lit);
  drawChannel(context, *lit);
}

void LightningPass::drawGlow(FrameContext& context, const LitFlash& lit) {
  std::vector<std::string> defines(context.defines.begin(), context.defines.end());
  defines.emplace_back(FlashLight::kDefine);
  const auto* clouds = context.resources.find<CloudTransmittance>();
  if (clouds) {
    defines.emplace_back("CLOUD_TRANSMITTANCE");
    clouds->bind();
  }
  gl::Shader& shader = context.shaders.shader("fullscreen.vert", "lightning/glow.frag", defines);
  lit.light.set(shader);
  if (clouds) {
    const double aboveM = lit.flash.from.y - lit.flash.cloudBaseM;
    shader.setFloat("aboveBaseM", static_cast<float>(std::max(aboveM, kLeastAboveBaseM)));
  }
  context.sceneDepth.bind(kGlowDepthUnit);
  shader.use();
  triangle_.draw();
}

void LightningPass::drawChannel(FrameContext& context, const LitFlash& lit) {
  const View& view = context.frame.view;
  std::vector<std::string> defines(context.defines.begin(), context.defines.end());
  const auto* clouds = context.resources.find<CloudTransmittance>();
  if (clouds) {
    defines.emplace_back("CLOUD_TRANSMITTANCE");
    clouds->bind();
  }
  std::vector<Piece> pieces;
  const weather::Channel& channel = lit.channel;
  // Where no cloud is drawn that could hide it, what lies within the cloud is left out.
  const auto isShown = [&](const weather::ChannelPiece& piece) {
    return clouds || std::max(piece.from.y, piece.to.y) <= lit.flash.cloudBaseM;
  };
  const auto add = [&](const glm::dvec3& from, const glm::dvec3& to, double share, float width) {
    pieces.push_back({glm::vec4(relativeToEye(view, from), static_cast<float>(share)),
                      glm::vec4(relativeToEye(view, to), width)});
  };
  for (const weather::ChannelPiece& piece : channel.pieces)
    if (isShown(piece)) add(piece.from, piece.to, piece.share, 1);
  const std::size_t step = std::max<std::size_t>(channel.mainPieces / kGlowPieces, 1);
  for (std::size_t i = 0; i + step <= channel.mainPieces && pieces.size() < pieces_.size() / sizeof(Piece);
       i += step) {
    const weather::ChannelPiece& first = channel.pieces[i];
    const weather::ChannelPiece& last = channel.pieces[i + step - 1];
    if (isShown(first) && isShown(last)) add(first.from, last.to, kGlowShare, kGlowWidth);
  }
  gl::Shader& shader = context.shaders.shader("lightning/channel.vert", "lightning/channel.frag", defines);
  if (pieces.empty()) return;
  pieces_.write(0, std::as_bytes(std::span(pieces)));
  shader.setVec3("channelLight",
                 glm::vec3(kColor * (lit.intensityKcd / std::max(channel.mainLengthM, 100.0))));
  shader.setFloat("lineSpread",
                  static_cast<float>(std::max(kLeastSpreadPixels, kEyeBlurRad / view.pixelAngleRad())));
  context.sceneDepth.bind(kChannelDepthUnit);
  array_.bind();
  shader.use();
  const gl::Functions& api = context.gl.api();
  api.Disable(GL_CULL_FACE);
  context.gl.drawElementsInstanced(GL_TRIANGLES, kCorners.size(), GL_UNSIGNED_SHORT, 0,
                                   static_cast<GLsizei>(pieces.size()));
}

}  // namespace skydrop::render
