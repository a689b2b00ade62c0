#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <map>
#include <memory>
#include <thread>

#include "app/studies/light_models.h"
#include "app/studies/light_scenes.h"
#include "app/studies/subjects.h"
#include "app/studies/table_subject.h"
#include "skydrop/clouds/light_volume.h"
#include "skydrop/clouds/reference_march.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/shared.h"

namespace skydrop::app {
namespace {

namespace f64 = core::shared::f64;

enum class LightModel { judge, judgeDoubled, octaves, refitted, once, stopgap, coarseVolume, volume };
constexpr std::array<std::string_view, 8> kModelNames = {"judge", "judgeDoubled", "octaves",      "refitted",
                                                         "once",  "stopgap",      "coarseVolume", "volume"};
enum class LightSource { sun, sky, ground };
constexpr std::array<std::string_view, 3> kSourceNames = {"sun", "sky", "ground"};
constexpr std::array<double clouds::TracedLight::*, 3> kTraced = {
    &clouds::TracedLight::sun, &clouds::TracedLight::sky, &clouds::TracedLight::ground};
constexpr std::array<double clouds::MarchResult::*, 3> kMarched = {
    &clouds::MarchResult::sun, &clouds::MarchResult::sky, &clouds::MarchResult::ground};

enum class JudgedScene {
  cumulus40,
  cumulus10,
  otherSeed20,
  elsewhere60,
  stratocumulus30,
  overcast40,
  droplets40
};
constexpr std::array<std::string_view, 7> kSceneNames = {"cumulus-40",   "cumulus-10",       "other-seed-20",
                                                         "elsewhere-60", "stratocumulus-30", "overcast-40",
                                                         "droplets-40"};

struct CloudLightParameters {
  LightModel model = LightModel::octaves;
  LightSource source = LightSource::sun;
  JudgedScene scene = JudgedScene::cumulus40;
  std::int64_t view = -1;
};

void describe(core::SettingsVisitor& visitor, CloudLightParameters& p) {
  visitor.choice("model", p.model, kModelNames, {.help = "What scatters light more than once."});
  visitor.choice("source", p.source, kSourceNames, {.help = "Where the light comes from."});
  visitor.choice("scene", p.scene, kSceneNames, {.help = "Of those that were traced."});
  visitor.integer("view", p.view,
                  {.unit = "1", .min = -1, .max = 5, .help = "Of the scene's pictures; -1: all of them."});
}

constexpr double kLeastOpacity = 0.01;  // of pixels that count

// A scene with all that is made of it.
struct Prepared {
  explicit Prepared(const LightScene& of)
      : scene(of),
        views(lightViews(of)),
        judged(readJudged(of, judgedFile(of))),
        field(lightNoise(of.noiseSeed), of.medium),
        medium(clouds::mediumOf(field)) {
    medium.isShell = false;  // as the judge has it
  }

  const clouds::LightVolume& volume(int side) {
    std::unique_ptr<clouds::LightVolume>& one = solved[side];
    if (!one) one = std::make_unique<clouds::LightVolume>(field, scene.toSun(), side);
    return *one;
  }

  const LightScene& scene;
  std::vector<LightView> views;
  JudgedLight judged;
  clouds::CloudField field;
  clouds::MarchMedium medium;
  std::map<int, std::unique_ptr<clouds::LightVolume>> solved;  // by cells across, once asked for
  std::map<LightModel, std::vector<std::vector<clouds::MarchResult>>>
      marched;  // by view and pixel, once asked for
};

// A draw of the standard normal distribution (Box and Muller 1958).
double normal(std::uint64_t index) {
  core::RandomStream random{7, 2 * index};
  const double a = random.nextUnit(), b = random.nextUnit();
  return std::sqrt(-2 * std::log1p(-a)) * std::cos(2 * glm::pi<double>() * b);
}

class CloudLightSubject final : public TableSubject<CloudLightParameters> {
  Prepared& prepared(JudgedScene scene) {
    std::unique_ptr<Prepared>& of = scenes_[scene];
    if (!of) of = std::make_unique<Prepared>(lightScene(kSceneNames[static_cast<std::size_t>(scene)]));
    return *of;
  }

  clouds::ScatteredLight scatteringOf(LightModel model, Prepared& of) {
    using clouds::LitPlace;
    switch (model) {
      case LightModel::once:
        return [](const LitPlace& at) { return glm::dvec3(at.sunPhases.x * std::exp(-at.sunDepth), 0, 0); };
      case LightModel::refitted:
        // Least squares of light and depth of an octave, the later ones even.
        return [](const LitPlace& at) {
          double sum = 0, light = 1, depth = at.sunDepth;
          for (int octave = 0; octave < 4; ++octave, light *= 0.56, depth *= 0.37)
            sum += light * std::exp(-depth) * (octave == 0 ? at.sunPhases.x : 1 / (4 * glm::pi<double>()));
          return glm::dvec3(sum, f64::scatteredSky(at.heightFraction),
                            f64::scatteredGround(at.heightFraction));
        };
      case LightModel::stopgap:
        return [&of](const LitPlace& at) {
          const double up = clouds::sunDepth(of.medium, {0, 1, 0}, at.place, 24);
          const double all = up + depthBelow(of, at.place), down = all - up, half = 2 * glm::pi<double>();
          return glm::dvec3(
              f64::scatteredSun(f64::Vec4(at.sunPhases), at.sunDepth),
              (0.68 * std::exp(-0.05 * up) + 0.81 * std::exp(-0.5 * up)) / half,
              (0.69 * std::exp(-0.05 * down) + 0.08 * std::exp(-0.15 * down) + 0.74 * std::exp(-0.5 * down)) /
                  half);
        };
      case LightModel::coarseVolume:
      case LightModel::volume:
        return litByVolume(of.volume(sideOf(model)), of.scene.medium.layer);
      default:
        return clouds::octavesOfLight;
    }
  }

  // As clouds.march.lightCells has them.
  static int sideOf(LightModel model) {
    return model == LightModel::coarseVolume ? clouds::LightVolume::kSide / 2 : clouds::LightVolume::kSide;
  }

  static double depthBelow(const Prepared& of, const glm::dvec3& place) {
    constexpr int kSamples = 24;
    const double step = (place.y - of.medium.baseM) / kSamples;
    double depth = 0;
    for (int i = 0; i < kSamples; ++i)
      depth += of.medium.extinction(place - glm::dvec3(0, (i + 0.5) * step, 0)) * step;
    return depth;
  }

  template <class Use>
  static void eachPixel(const CloudLightParameters& p, const Prepared& of, const Use& use) {
    for (std::size_t v = 0; v < of.views.size(); ++v) {
      if (p.view >= 0 && v != static_cast<std::size_t>(p.view)) continue;
      for (std::size_t i = 0; i < of.views[v].rays.size(); ++i) {
        if (1 - of.judged.views[v][i].mean.transmittance > kLeastOpacity) use(v, i);
      }
    }
  }

  accuracy::Observation compute(const CloudLightParameters& p) override {
    Prepared& of = prepared(p.scene);
    const auto source = static_cast<std::size_t>(p.source);
    accuracy::Observation observation;
    const bool isJudge = p.model == LightModel::judge || p.model == LightModel::judgeDoubled;
    // Twice as many paths, half of them these: the mean would change by this share of its error bars.
    const double noise = p.model == LightModel::judgeDoubled ? std::sqrt(0.5) : 0;
    const std::vector<std::vector<clouds::MarchResult>>* marched =
        isJudge ? nullptr : &marchedBy(p.model, of);
    eachPixel(p, of, [&](std::size_t view, std::size_t pixel) {
      if (isJudge) {
        const clouds::TracedPixel& judged = of.judged.views[view][pixel];
        observation.values.push_back(judged.mean.*kTraced[source] + noise *
                                                                        normal(observation.values.size()) *
                                                                        judged.error.*kTraced[source]);
      } else {
        observation.values.push_back((*marched)[view][pixel].*kMarched[source]);
      }
    });
    return observation;
  }

  // Of what a march does at a place once it knows the depth towards the sun.
  double work(const CloudLightParameters& p) override {
    Prepared& of = prepared(p.scene);
    if (p.model == LightModel::judge || p.model == LightModel::judgeDoubled) return 0;
    const clouds::ScatteredLight scattered = scatteringOf(p.model, of);
    const glm::dvec4 phases(f64::cloudPhases(0.3, 0.119, 0.15));
    const clouds::CloudLayerSettings& layer = of.scene.medium.layer;
    double sum = 0;
    for (int i = 0; i < 1000; ++i) {
      const double share = (i + 0.5) / 1000;
      const glm::dvec3 place(37.0 * i, layer.cloudHeight + share * layer.thickness, 61.0 * i);
      const glm::dvec3 light = scattered({place, share, 20 * share, 0.03, phases, 0.3});
      sum += light.x + light.y + light.z;
    }
    return sum;
  }

  // Every pixel of a scene by a model, which is the same march for all sources of light and all views.
  const std::vector<std::vector<clouds::MarchResult>>& marchedBy(LightModel model, Prepared& of) {
    std::vector<std::vector<clouds::MarchResult>>& views = of.marched[model];
    if (!views.empty()) return views;
    const clouds::ScatteredLight scattered = scatteringOf(model, of);
    const clouds::MarchLight light = lightOf(of);
    const clouds::MarchSteps steps = stepsFor(of.scene.sunElevationDegrees);
    for (const LightView& view : of.views) {
      std::vector<clouds::MarchResult>& results = views.emplace_back(view.rays.size());
      std::atomic<std::size_t> next = 0;
      const auto march = [&] {
        for (std::size_t i = next++; i < results.size(); i = next++)
          results[i] = clouds::referenceMarch(of.medium, light, view.rays[i], steps, scattered);
      };
      const std::jthread beside(march);  // the same bits, whoever marches a ray
      march();
    }
    return views;
  }

  static clouds::MarchLight lightOf(const Prepared& of) {
    return {of.scene.toSun(), of.scene.medium.layer.anisotropy, of.scene.medium.layer.forwardShare};
  }

  std::map<JudgedScene, std::unique_ptr<Prepared>> scenes_;
};

}  // namespace

std::unique_ptr<accuracy::Subject> makeCloudLightSubject() { return std::make_unique<CloudLightSubject>(); }

}  // namespace skydrop::app
