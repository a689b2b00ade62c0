#include "skydrop/render/clouds/ice_clouds_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/clouds/ice_view.h"
#include "render/clouds/sheet_layer.h"
#include "render/clouds/sheet_sun.h"
#include "skydrop/core/shared_ice.h"
#include "skydrop/render/frame/cloud_transmittance.h"
#include "skydrop/render/gl/frame_buffer.h"

namespace skydrop::render {
namespace {

using clouds::IceGenus;
using clouds::SheetResolution;
namespace shared = core::shared::f64;

constexpr GLuint kLayerUnit = 0, kDepthUnit = 4;  // as in shaders/clouds/ice*.glsl

constexpr std::array<const char*, 3> kGenusDefines = {"CIRRUS", "CIRROSTRATUS", "CIRROCUMULUS"};
// Share of the ice in regular crystals: whole sheets of cirrostratus make halos, cirrus parts of one.
constexpr std::array<float, 3> kRegular = {0.2f, 0.5f, 0.f};

// No land is higher.
constexpr double kLandsTopM = 6000;

// The sun stands higher for ice that lies towards it, along the level: nodes from -kSunReachM to kSunReachM.
constexpr std::size_t kSunPlaces = 16;
constexpr double kSunReachM = 400'000;

std::array<glm::vec4, kSunPlaces> sunAtPlaces(const SkyLight& light, double heightM) {
  std::array<glm::vec4, kSunPlaces> nodes;
  const double sine = light.direct.toSun.y, cosine = std::sqrt(std::max(1 - sine * sine, 0.0));
  SkyLight there = light;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double share = static_cast<double>(i) / (kSunPlaces - 1);
    const double turn = kSunReachM * (2 * share - 1) / shared::kEarthRadiusM;
    there.direct.toSun.y = std::min(sine * std::cos(turn) + cosine * std::sin(turn), 1.0);
    nodes[i] = glm::vec4(glm::vec3(sunOnSheet(there, heightM)), static_cast<float>(there.direct.toSun.y));
  }
  return nodes;
}

}  // namespace

IceCloudsPass::IceCloudsPass(gl::Context& context, const clouds::IceCloudSettings& settings,
                             const core::WindSettings& wind)
    : layers_(settings, wind),
      layer_(std::make_unique<SheetLayer>(context, "ice layer", GL_RGBA32F)),
      triangle_(context) {}

IceCloudsPass::~IceCloudsPass() = default;

std::optional<std::string> IceCloudsPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  const std::vector<clouds::IceField> fields = layers_.of(frame);
  if (fields.empty()) {
    layer_->release();  // the weather may bring none for a long time
    return "no layer of ice";
  }
  const bool isSeen = std::ranges::any_of(
      fields, [&](const auto& field) { return !pixelsOfIce(frame.view, field.layer()).empty(); });
  if (!isSeen) return "the layers are out of view";
  return std::nullopt;
}

// Those of all genera are asked for in every frame: the weather may bring each.
IceCloudsPass::Programs IceCloudsPass::programs(FrameContext& context, IceGenus genus,
                                                bool isBehindAll) const {
  std::vector<std::string> defines(context.defines.begin(), context.defines.end());
  std::vector<std::string> light = defines;
  if (halo_) light.emplace_back("HALO");
  light.emplace_back(kGenusDefines[static_cast<std::size_t>(genus)]);
  const auto* clouds = context.resources.find<CloudTransmittance>();
  const auto add = [clouds](std::vector<std::string>& to) {
    if (clouds) to.emplace_back("CLOUD_TRANSMITTANCE");
  };
  if (layers_.settings().resolution == SheetResolution::full) {
    add(light);
    return {&context.shaders.shader("fullscreen.vert", "clouds/ice.frag", light), nullptr};
  }
  add(defines);
  gl::Shader& any = context.shaders.shader("fullscreen.vert", "clouds/ice_compose.frag", defines);
  defines.emplace_back("SKY_ALONE");
  gl::Shader& sky = context.shaders.shader("fullscreen.vert", "clouds/ice_compose.frag", defines);
  return {&context.shaders.shader("fullscreen.vert", "clouds/ice_layer.frag", light),
          isBehindAll ? &sky : &any};
}

void IceCloudsPass::draw(FrameContext& context) {
  std::vector<clouds::IceField> fields = layers_.of(context.frame);
  if (context.frame.warmsUp) {  // whatever there is, all are compiled, and the smallest picture is drawn
    for (std::size_t i = 0; i < kGenusDefines.size(); ++i)
      fields.emplace_back(
          clouds::IceLayer{.genus = static_cast<IceGenus>(i), .cover = 0.5, .opticalDepth = 0.5},
          glm::dvec2(0));
  }
  for (std::size_t i = 0; i < kGenusDefines.size(); ++i) programs(context, static_cast<IceGenus>(i), false);
  // Far to near: what is farther from the eye's height lies behind.
  const double eye = context.frame.view.position.y;
  std::ranges::stable_sort(fields, std::ranges::greater(), [&](const clouds::IceField& field) {
    return std::abs(0.5 * (field.layer().baseM + field.layer().topM) - eye);
  });
  if (const auto* clouds = context.resources.find<CloudTransmittance>()) clouds->bind();
  context.sceneDepth.bind(kDepthUnit);
  if (layers_.settings().resolution == SheetResolution::full) layer_->release();
  for (const clouds::IceField& field : fields) {
    PixelBox box = pixelsOfIce(context.frame.view, field.layer());
    if (context.frame.warmsUp) box = {0, 0, context.frame.view.width, context.frame.view.height};
    if (!box.empty()) drawLayer(context, field, box);
  }
  if (context.frame.warmsUp) layer_->release();
}

void IceCloudsPass::drawLayer(FrameContext& context, const clouds::IceField& field, const PixelBox& box) {
  const gl::Functions& gl = context.gl.api();
  // Below a layer that no land reaches only the sky shows it: what is nearer is left out by the depth test,
  // which a software renderer does before it shades.
  const bool isBehindAll = layers_.settings().resolution != SheetResolution::full &&
                           context.frame.view.position.y < field.layer().baseM &&
                           field.layer().baseM >= kLandsTopM;
  const Programs with = programs(context, field.layer().genus, isBehindAll);
  const SheetResolution resolution = layers_.settings().resolution;
  setLayer(context, *with.light, field);
  if (with.compose) {
    const int pixels = clouds::pixelsAlong(resolution);
    with.light->setFloat("pixelsAlong", static_cast<float>(pixels));
    layer_->begin(context.frame.view, resolution);
    // One texel more to each side, between which pixels at the box's sides are mixed.
    const int low = std::max(box.lowY / pixels - 1, 0);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(0, low, box.width() / pixels + 1, box.highY / pixels + 2 - low);
    gl.Disable(GL_BLEND);
    with.light->use();
    triangle_.draw();
    layer_->end(kLayerUnit);
    setLevels(*with.compose, context.frame.view, field.layer());
  }
  gl::FrameBuffer overScene;
  if (isBehindAll) {
    overScene = gl::FrameBuffer(context.gl, &context.sceneColor, &context.sceneDepth, "scene under ice");
    overScene.bind(gl::FrameBuffer::Clear::no);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_GEQUAL);
    gl.DepthMask(GL_FALSE);
  }
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(box.lowX, box.lowY, box.width(), box.height());
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  (with.compose ? with.compose : with.light)->use();
  triangle_.draw();
  gl.Disable(GL_SCISSOR_TEST);
  if (isBehindAll) overScene.unBind();
}

void IceCloudsPass::setLevels(gl::Shader& shader, const View& view, const clouds::IceLayer& layer) {
  shader.setVec2("iceLevels", glm::vec2(view.position.y - glm::dvec2(layer.baseM, layer.topM)));
}

void IceCloudsPass::setLayer(FrameContext& context, gl::Shader& shader, const clouds::IceField& field) const {
  const View& view = context.frame.view;
  const clouds::IceLayer& layer = field.layer();
  const auto number = [](double value) { return static_cast<float>(value); };
  setLevels(shader, view, layer);
  const clouds::IceAnchor anchor = field.anchor({view.position.x, view.position.z});
  shader.setIvec2("iceCell", glm::ivec2(anchor.cell));
  shader.setVec2("iceInside", glm::vec2(anchor.inside));
  shader.setVec2("iceAlong", glm::vec2(layer.along));
  shader.setVec3("iceForm", {number(layer.trailM), number(layer.hookM), number(field.threshold())});
  shader.setFloat("iceExtinction", number(field.extinction()));
  shader.setInt("iceSamples", static_cast<int>(layers_.settings().samples));
  shader.setVec4s("sunAtPlaces", sunAtPlaces(context.light, 0.5 * (layer.baseM + layer.topM)));
  if (!halo_) return;
  halo_->halo->bind(HaloTables::kHaloUnit);
  halo_->sunDogs->bind(HaloTables::kSunDogUnit);
  shader.setFloat("plates", number(halo_->plates));
  shader.setFloat("regularShare", kRegular[static_cast<std::size_t>(layer.genus)]);
}

}  // namespace skydrop::render
