#include "skydrop/render/shadows/land_shadow_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "render/frame/visibility.h"
#include "skydrop/render/frame/sky_light.h"

namespace skydrop::render {
namespace {

// A shade for a sun that has moved by less is good enough for a frame that follows another: a tenth of its
// disc's radius.
constexpr double kSameSunRad = 0.1 * kSunRadiusRad;

// Sine of the elevation that a warm-up's sun has at least, so that there is a shade to draw with.
constexpr double kWarmUpSun = 0.05;

bool isGoodEnough(const terrain::ShadeKey& had, const terrain::ShadeKey& wanted) {
  return had.layout == wanted.layout && had.first == wanted.first &&
         glm::length(had.toSun - wanted.toSun) < kSameSunRad;
}

bool mayBeInView(const View& view, const terrain::Box& box) {
  std::array<glm::dvec3, 8> corners;
  for (unsigned i = 0; i < corners.size(); ++i) {
    const glm::dvec3 corner(i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                            i & 4 ? box.hi.z : box.lo.z);
    corners[i] = corner - view.position;
  }
  if (!isPotentiallyVisible(view, corners)) return false;
  // Boxes below a view that rises, which the picture's sides alone do not tell from those in it.
  return view.offAxis != glm::dvec2(0) ||
         terrain::mayBeVisible(
             terrain::makeViewVolume(view.position, view.worldToView, view.fovYRad, view.width, view.height),
             box);
}

double reliefOf(const terrain::HeightSource& ground) {
  const terrain::HeightBounds range = ground.range();
  return range.highest - std::max(range.lowest, 0.0);
}

}  // namespace

LandShadowPass::Work::Work(std::shared_ptr<const terrain::HeightSource> ground)
    : job([heights = std::make_shared<terrain::ShadeHeights>(std::move(ground))](
              const terrain::ShadeKey& key, const std::stop_token& stop) {
        return std::make_shared<const terrain::LandShade>(terrain::LandShade::make(*heights, key, stop));
      }) {}

void LandShadowPass::Work::want(const terrain::ShadeKey& key, bool waits) {
  const bool isThere = waits ? wanted == key : wanted && isGoodEnough(*wanted, key);
  if (!isThere) {
    job.request(key);
    wanted = key;
  }
  if (waits) job.wait();
  if (auto made = job.take()) shade = std::move(*made);
}

LandShadowPass::LandShadowPass(std::shared_ptr<const terrain::HeightSource> ground,
                               const LandShadowSettings& settings)
    : relief_(reliefOf(*ground)), settings_(settings), work_(std::make_unique<Work>(std::move(ground))) {}

std::optional<std::string> LandShadowPass::skipReason(const FrameInput& frame) const {
  if (frame.toSun.y <= -std::sin(kSunRadiusRad) && !frame.warmsUp) return "the sun is below the horizon";
  if (relief_ <= 0) return "no land rises above other land";
  const View& view = frame.view;
  const auto wantAs = [&](const glm::dvec3& toSun, bool waits) {
    work_->want(terrain::shadeKey(shadeLayout(settings_), {view.position.x, view.position.z}, toSun), waits);
  };
  if (frame.warmsUp) {
    // Whatever shade is there will do.
    const glm::dvec3 raised(frame.toSun.x, std::max(frame.toSun.y, kWarmUpSun), frame.toSun.z);
    if (!work_->shade) wantAs(glm::normalize(raised), !frame.followsLast);
    return std::nullopt;
  }
  wantAs(frame.toSun, !frame.followsLast);
  if (!work_->shade) return "the shade is being worked out";
  const std::vector<terrain::Box>& shaded = work_->shade->shaded();
  if (shaded.empty()) return "the sun stands above every slope";
  if (std::none_of(shaded.begin(), shaded.end(), [&](const terrain::Box& b) { return mayBeInView(view, b); }))
    return "no shaded land is in view";
  return std::nullopt;
}

void LandShadowPass::draw(FrameContext& context) {
  if (!work_->shade) {  // in a warm-up: what is drawn with is compiled, and no frame waits for the shade
    map_.takeNone(context.gl, shadeLayout(settings_));
  } else if (uploaded_ != work_->shade) {
    uploaded_ = work_->shade;
    map_.take(context.gl, *uploaded_);
  }
  context.resources.publish(map_);
  before_ = context.resources.replace<LightAtPlaces>(*this);
}

LightShares LandShadowPass::at(const glm::dvec3& place) const {
  LightShares shares = before_ ? before_->at(place) : LightShares{};
  if (uploaded_) shares.sun *= uploaded_->sunShare(place);
  return shares;
}

}  // namespace skydrop::render
