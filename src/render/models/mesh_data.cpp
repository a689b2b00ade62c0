#include "skydrop/render/models/mesh_data.h"

#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace skydrop::render {
namespace {

// Step of the central difference: the error of a smooth mapping is of the order step^2, here 1e-8, and that
// of cancellation 1e-16 / step = 1e-12.
constexpr double kStep = 1e-4;

glm::dvec3 crossOfDerivatives(const SurfaceMapping& f, double u, double v) {
  const glm::dvec3 du = f(u + kStep, v) - f(u - kStep, v);
  const glm::dvec3 dv = f(u, v + kStep) - f(u, v - kStep);
  return glm::cross(dv, du);
}

glm::dvec3 surfaceNormal(const SurfaceMapping& f, double u, double v, double scale) {
  const auto unit = [](const glm::dvec3& n) {
    return glm::length(n) > 0 ? glm::normalize(n) : glm::dvec3(0, 1, 0);
  };
  const glm::dvec3 cross = crossOfDerivatives(f, u, v);
  if (glm::length(cross) > 1e-6 * scale * kStep * kStep) return unit(cross);
  // At a pole one derivative vanishes but for rounding: the normal is extrapolated from two places further
  // inside, with an error of the order of (2 kStep)^2.
  const double inside = v < 0.5 ? 2 * kStep : -2 * kStep;
  const glm::dvec3 first = unit(crossOfDerivatives(f, u, v + inside));
  const glm::dvec3 second = unit(crossOfDerivatives(f, u, v + 2 * inside));
  return unit(2.0 * first - second);
}

}  // namespace

MeshData meshFromMapping(const SurfaceMapping& mapping, int uCells, int vCells) {
  assert(uCells > 0 && vCells > 0);
  MeshData mesh;
  mesh.vertices.reserve(static_cast<std::size_t>((uCells + 1) * (vCells + 1)));
  mesh.indices.reserve(static_cast<std::size_t>(uCells * vCells * 6));
  // A typical area of the surface, to tell a vanishing cross product from a small surface.
  const glm::dvec3 across = mapping(0.5, 0.75) - mapping(0.5, 0.25);
  const glm::dvec3 along = mapping(0.75, 0.5) - mapping(0.25, 0.5);
  const double scale = glm::length(across) * glm::length(along);
  for (int j = 0; j <= vCells; ++j) {
    for (int i = 0; i <= uCells; ++i) {
      const double u = static_cast<double>(i) / uCells, v = static_cast<double>(j) / vCells;
      mesh.vertices.push_back({glm::vec3(mapping(u, v)), glm::vec3(surfaceNormal(mapping, u, v, scale)),
                               glm::vec2(static_cast<float>(u), static_cast<float>(v))});
    }
  }
  for (int j = 0; j < vCells; ++j) {
    for (int i = 0; i < uCells; ++i) {
      const auto corner = [uCells](int column, int row) {
        return static_cast<std::uint32_t>(row * (uCells + 1) + column);
      };
      const std::uint32_t a = corner(i, j), b = corner(i + 1, j), c = corner(i, j + 1),
                          d = corner(i + 1, j + 1);
      for (std::uint32_t index : {a, c, b, b, c, d}) mesh.indices.push_back(index);
    }
  }
  return mesh;
}

MeshData sphereMesh(double radius, int uCells, int vCells) {
  return meshFromMapping(
      [radius](double u, double v) {
        const double theta = 2 * std::numbers::pi * u, phi = std::numbers::pi * (v - 0.5);
        return radius *
               glm::dvec3(std::cos(theta) * std::cos(phi), std::sin(phi), std::sin(theta) * std::cos(phi));
      },
      uCells, vCells);
}

MeshData torusMesh(double ringRadius, double tubeRadius, int uCells, int vCells) {
  return meshFromMapping(
      [ringRadius, tubeRadius](double u, double v) {
        const double phi = 2 * std::numbers::pi * u, theta = 2 * std::numbers::pi * v;
        const double r = ringRadius + tubeRadius * std::cos(theta);
        return glm::dvec3(r * std::cos(phi), tubeRadius * std::sin(theta), r * std::sin(phi));
      },
      uCells, vCells);
}

MeshData planeMesh(double sizeX, double sizeZ, int uCells, int vCells) {
  return meshFromMapping(
      [sizeX, sizeZ](double u, double v) { return glm::dvec3((u - 0.5) * sizeX, 0, (v - 0.5) * sizeZ); },
      uCells, vCells);
}

}  // namespace skydrop::render
