#include "skydrop/terrain/analytic_height_sources.h"

#include <algorithm>
#include <cmath>

namespace skydrop::terrain {
namespace {

class TiltedPlane final : public HeightSource {
 public:
  TiltedPlane(double height, glm::dvec2 gradient, const HeightRange& stored)
      : height_(height), gradient_(gradient), stored_(stored) {}

  HeightSample sample(glm::dvec2 xz) const override {
    const double h = height_ + gradient_.x * xz.x + gradient_.y * xz.y;
    if (h < stored_.lowest || h > stored_.highest)
      return {std::clamp(h, stored_.lowest, stored_.highest), {0, 0}};
    return {h, gradient_};
  }
  HeightBounds bounds(glm::dvec2 lo, glm::dvec2 hi) const override {
    const double a = height(lo), b = height({hi.x, lo.y}), c = height({lo.x, hi.y}), d = height(hi);
    return {std::min({a, b, c, d}), std::max({a, b, c, d})};
  }
  HeightBounds range() const override {
    if (gradient_ == glm::dvec2(0, 0)) return {height({0, 0}), height({0, 0})};
    return {stored_.lowest, stored_.highest};
  }
  HeightRange storedRange() const override { return stored_; }

 private:
  double height_;
  glm::dvec2 gradient_;
  HeightRange stored_;
};

class Ridge final : public HeightSource {
 public:
  Ridge(double crestX, double crest, double slope, double foot)
      : crestX_(crestX), crest_(crest), slope_(slope), foot_(foot) {}

  HeightSample sample(glm::dvec2 xz) const override {
    const double away = xz.x - crestX_;
    const double h = crest_ - slope_ * std::abs(away);
    if (h <= foot_) return {foot_, {0, 0}};
    return {h, {away > 0 ? -slope_ : away < 0 ? slope_ : 0.0, 0}};
  }
  HeightBounds bounds(glm::dvec2 lo, glm::dvec2 hi) const override {
    const double a = height(lo), b = height(hi);
    const bool holdsCrest = lo.x <= crestX_ && crestX_ <= hi.x;
    return {std::min(a, b), holdsCrest ? crest_ : std::max(a, b)};
  }
  HeightBounds range() const override { return {foot_, crest_}; }

 private:
  double crestX_, crest_, slope_, foot_;
};

class Step final : public HeightSource {
 public:
  Step(double edgeX, double low, double high) : edgeX_(edgeX), low_(low), high_(high) {}

  HeightSample sample(glm::dvec2 xz) const override { return {xz.x < edgeX_ ? low_ : high_, {0, 0}}; }
  HeightBounds bounds(glm::dvec2 lo, glm::dvec2 hi) const override {
    const double a = height(lo), b = height(hi);
    return {std::min(a, b), std::max(a, b)};
  }
  HeightBounds range() const override { return {std::min(low_, high_), std::max(low_, high_)}; }

 private:
  double edgeX_, low_, high_;
};

}  // namespace

std::shared_ptr<const HeightSource> makeFlatSource(double height) {
  return std::make_shared<TiltedPlane>(height, glm::dvec2(0, 0), HeightRange{});
}
std::shared_ptr<const HeightSource> makeTiltedPlaneSource(double heightAtOrigin, glm::dvec2 gradient,
                                                          const HeightRange& stored) {
  return std::make_shared<TiltedPlane>(heightAtOrigin, gradient, stored);
}
std::shared_ptr<const HeightSource> makeRidgeSource(double crestX, double crest, double slope, double foot) {
  return std::make_shared<Ridge>(crestX, crest, slope, foot);
}
std::shared_ptr<const HeightSource> makeStepSource(double edgeX, double low, double high) {
  return std::make_shared<Step>(edgeX, low, high);
}

}  // namespace skydrop::terrain
