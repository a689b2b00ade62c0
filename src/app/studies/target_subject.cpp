// What formats of a render target keep of light.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "app/studies/subjects.h"
#include "app/studies/table_subject.h"

namespace skydrop::app {
namespace {

enum class TargetFormat { exact, float32, float16, float11, unorm8 };
constexpr std::array<std::string_view, 5> kTargetNames = {"exact", "float32", "float16", "float11", "unorm8"};

struct TargetParameters {
  TargetFormat format = TargetFormat::float16;
  double brightest = 100;
};

void describe(core::SettingsVisitor& visitor, TargetParameters& p) {
  visitor.choice("format", p.format, kTargetNames, {.help = "What keeps the light of a pixel."});
  visitor.number("brightest", p.brightest,
                 {.unit = "1", .min = 1, .max = 60000, .help = "Light of the brightest pixel; white is 1."});
}

double keptLight(TargetFormat format, double light) {
  switch (format) {
    case TargetFormat::exact:
      return light;
    case TargetFormat::float32:
      return static_cast<float>(light);
    case TargetFormat::float16:
      return glm::unpackHalf1x16(glm::packHalf1x16(static_cast<float>(light)));
    case TargetFormat::float11:
      return glm::unpackF2x11_1x10(glm::packF2x11_1x10(glm::vec3(static_cast<float>(light)))).x;
    case TargetFormat::unorm8:
      return std::round(std::clamp(light, 0.0, 1.0) * 255) / 255;
  }
  return light;
}

// Relative errors of lights that grow by ratios, from a thousandth of white.
class TargetSubject final : public TableSubject<TargetParameters> {
  accuracy::Observation compute(const TargetParameters& p) override {
    accuracy::Observation observation;
    for (int i = 0; i < kLights; ++i)
      observation.values.push_back(keptLight(p.format, lightOf(p, i)) / lightOf(p, i));
    return observation;
  }
  double work(const TargetParameters& p) override {
    double sum = 0;
    for (int i = 0; i < kLights; ++i) sum += keptLight(p.format, lightOf(p, i));
    return sum;
  }
  static constexpr int kLights = 4096;
  static double lightOf(const TargetParameters& p, int i) {
    constexpr double kDarkest = 1e-3;
    return kDarkest * std::pow(p.brightest / kDarkest, (i + 0.5) / kLights);
  }
};

}  // namespace

std::unique_ptr<accuracy::Subject> makeTargetSubject() { return std::make_unique<TargetSubject>(); }

}  // namespace skydrop::app
