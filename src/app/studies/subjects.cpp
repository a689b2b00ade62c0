#include "app/studies/subjects.h"

#include <array>

namespace skydrop::app {
namespace {

struct Maker {
  std::string_view name;
  std::unique_ptr<accuracy::Subject> (*make)();
};
constexpr std::array kMakers = {
    Maker{"motion", makeMotionSubject},
    Maker{"landing", makeLandingSubject},
    Maker{"land", makeLandSubject},
    Maker{"streaming", makeStreamingSubject},
    Maker{"farNoise", makeFarNoiseSubject},
    Maker{"depth", makeDepthSubject},
    Maker{"target", makeTargetSubject},
    Maker{"noiseTexture", makeNoiseTextureSubject},
    Maker{"sky", makeSkySubject},
    Maker{"march", makeMarchSubject},
    Maker{"cloudShade", makeCloudShadeSubject},
    Maker{"cloudLight", makeCloudLightSubject},
    Maker{"landShade", makeLandShadeSubject},
    Maker{"glitter", makeGlitterSubject},
};

}  // namespace

accuracy::Subject* Subjects::find(std::string_view name) {
  if (const auto found = made_.find(name); found != made_.end()) return found->second.get();
  std::unique_ptr<accuracy::Subject> subject;
  if (name == "picture") subject = makePictureSubject(size_);
  for (const Maker& maker : kMakers) {
    if (maker.name == name) subject = maker.make();
  }
  if (!subject) return nullptr;
  return (made_[std::string(name)] = std::move(subject)).get();
}

}  // namespace skydrop::app
