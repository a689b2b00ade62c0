#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/hash.h"
#include "skydrop/weather/lightning.h"

namespace skydrop::weather {
namespace {

namespace dmath = core::dmath;

// A point is moved aside by about so much of the length of what it halves, farther in the first halvings:
// pieces then turn by 16 degrees in the mean from one to the next, as photographs have it (Hill 1968; Reed
// and Wyvill 1994).
constexpr double kAside = 0.058, kWideAside = 0.12;
constexpr int kWideHalvings = 2;
constexpr int kMainHalvings = 7, kBranchHalvings = 5, kTwigHalvings = 3;

double between(core::RandomStream& random, double a, double b) { return a + (b - a) * random.nextUnit(); }

// A unit vector at a right angle to another.
glm::dvec3 across(const glm::dvec3& along, core::RandomStream& random) {
  const double angle = dmath::kTwoPi * random.nextUnit();
  const glm::dvec3 other = std::abs(along.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(along, other));
  return right * dmath::cos(angle) + glm::cross(right, along) * dmath::sin(angle);
}

std::vector<glm::dvec3> displaced(const glm::dvec3& from, const glm::dvec3& to, int halvings,
                                  core::RandomStream& random) {
  std::vector<glm::dvec3> points = {from, to};
  for (int i = 0; i < halvings; ++i) {
    std::vector<glm::dvec3> finer = {points.front()};
    for (std::size_t k = 1; k < points.size(); ++k) {
      const glm::dvec3 way = points[k] - points[k - 1];
      const double length = glm::length(way);
      const double share = i < kWideHalvings ? kWideAside : kAside;
      const double aside = share * length * (0.4 + 1.2 * random.nextUnit());
      const glm::dvec3 side = length > 0 ? across(way / length, random) : glm::dvec3(0);
      finer.push_back(points[k - 1] + 0.5 * way + aside * side);
      finer.push_back(points[k]);
    }
    points = std::move(finer);
  }
  return points;
}

struct Growth {
  Channel& channel;
  core::RandomStream& random;
  double lowestM;  // no branch goes below
};

void addBranch(Growth& growth, const glm::dvec3& from, const glm::dvec3& along, double lengthM, double share,
               int halvings);

// Branches leave forwards from the points of a path, seldom near its ends.
void addBranches(Growth& growth, const std::vector<glm::dvec3>& path, double share, double chance,
                 int halvings) {
  double lengthM = 0;
  for (std::size_t i = 1; i < path.size(); ++i) lengthM += glm::length(path[i] - path[i - 1]);
  const std::size_t last = path.size() - 1;
  for (std::size_t i = 2; i + 2 < last; ++i) {
    if (growth.random.nextUnit() >= chance) continue;
    const glm::dvec3 way = path[std::min(i + 4, last)] - path[i - 2];
    const double wayM = glm::length(way);
    if (!(wayM > 0)) continue;
    const double angle = between(growth.random, 15, 50) * dmath::kRadPerDeg;
    const glm::dvec3 along = way / wayM;
    const glm::dvec3 aside = across(along, growth.random);
    const double left = 1 - static_cast<double>(i) / static_cast<double>(last);
    const double branchM = lengthM * left * between(growth.random, 0.12, 0.5);
    const double branchShare = share * between(growth.random, 0.25, 0.6);
    addBranch(growth, path[i], along * dmath::cos(angle) + aside * dmath::sin(angle), branchM, branchShare,
              halvings);
  }
}

void addBranch(Growth& growth, const glm::dvec3& from, const glm::dvec3& along, double lengthM, double share,
               int halvings) {
  const std::vector<glm::dvec3> path = displaced(from, from + along * lengthM, halvings, growth.random);
  std::vector<ChannelPiece>& pieces = growth.channel.pieces;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (pieces.size() >= kMostPieces || path[i].y < growth.lowestM) return;
    const double left = 1 - static_cast<double>(i - 1) / static_cast<double>(path.size() - 1);
    pieces.push_back({path[i - 1], path[i], share * left});
  }
  if (halvings > kTwigHalvings) addBranches(growth, path, share, 0.12, kTwigHalvings);
}

}  // namespace

Channel channelOf(const Flash& flash, double groundM) {
  Channel channel;
  core::RandomStream random{flash.seed};
  glm::dvec3 to = flash.to;
  if (flash.toGround) to.y = groundM;
  std::vector<glm::dvec3> path = displaced(flash.from, to, kMainHalvings, random);
  if (flash.toGround)  // none but the last touches it
    for (std::size_t i = 0; i + 1 < path.size(); ++i) path[i].y = std::max(path[i].y, groundM);
  for (std::size_t i = 1; i < path.size(); ++i) {
    channel.pieces.push_back({path[i - 1], path[i], 1});
    channel.mainLengthM += glm::length(path[i] - path[i - 1]);
  }
  channel.mainPieces = channel.pieces.size();
  double passed = 0;
  std::size_t light = 0;
  for (std::size_t i = 0; i < channel.mainPieces; ++i) {
    const ChannelPiece& piece = channel.pieces[i];
    const double length = glm::length(piece.to - piece.from);
    const auto middle = [&] {
      return (static_cast<double>(light) + 0.5) / Channel::kLights * channel.mainLengthM;
    };
    while (light < Channel::kLights && (middle() <= passed + length || i + 1 == channel.mainPieces)) {
      const double share = length > 0 ? std::clamp((middle() - passed) / length, 0.0, 1.0) : 0;
      channel.lights[light++] = piece.from + share * (piece.to - piece.from);
    }
    passed += length;
  }
  Growth growth{channel, random, groundM};
  addBranches(growth, path, 1, flash.toGround ? 0.09 : 0.12, kBranchHalvings);
  return channel;
}

}  // namespace skydrop::weather
