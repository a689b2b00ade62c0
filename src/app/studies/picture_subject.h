// Pictures of scenes as a subject of studies: any setting of the program is turned, by its path, and `samples`
// a pixel: as many frames (DrawnScene::draw). Main thread.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "app/studies/drawn_scene.h"
#include "skydrop/accuracy/subject.h"

namespace skydrop::app {

class PictureSubject final : public accuracy::Subject {
 public:
  // Of pictures of this size. What effects are made of outlives it.
  explicit PictureSubject(Size size, const std::vector<EffectDescriptor>& table = effectTable())
      : size_(size), table_(table) {}

  accuracy::Assignments checked(const accuracy::Experiment& experiment) const override;
  accuracy::Observation observe(const accuracy::Experiment& experiment) override;
  double timeOnce(const accuracy::Experiment& experiment) override;
  std::string clock(const accuracy::Experiment& experiment) const override;
  std::string machine() const override;

 private:
  // The scene as these settings want it, ready to be drawn. Those that differ only in what can change while
  // flying share one.
  DrawnScene& shown(const accuracy::Experiment& experiment);

  Size size_;
  const std::vector<EffectDescriptor>& table_;
  std::map<std::string, std::unique_ptr<DrawnScene>> scenes_;
  mutable std::map<std::string, accuracy::Assignments> checked_;
  std::string device_ = "no renderer yet", passClock_;
};

}  // namespace skydrop::app
