#include "render/clouds/sun_optical_depth_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "render/clouds/cloud_uniforms.h"

namespace skydrop::render {
namespace {

constexpr int kColumnsAMove = 8;  // a grid moves in steps of so many columns
constexpr int kFewestLayers = 8, kMostLayers = 192;
constexpr double kSampleM = 60;  // of extinction along a ray, about

// A power of two near the sine: layouts stay alike while the sun moves a little.
double roundedSine(double sine) { return std::exp2(std::round(std::log2(sine))); }

}  // namespace

SunOpticalDepthGridLayout sunOpticalDepthGridLayout(const clouds::CloudLayerSettings& s,
                                                    const glm::dvec3& toSun, double cellM, double radiusM,
                                                    const glm::dvec3& middle) {
  const double level = std::hypot(toSun.x, toSun.z);
  const glm::dvec3 azimuth = level > 1e-9 ? glm::dvec3(toSun.x, 0, toSun.z) / level : glm::dvec3(1, 0, 0);
  const double slant = level / toSun.y;  // metres along the azimuth per metre up
  const double sine = roundedSine(toSun.y);
  SunOpticalDepthGridLayout grid;
  grid.along = azimuth * (cellM / sine);
  grid.across = glm::dvec3(-azimuth.z, 0, azimuth.x) * cellM;
  grid.nodes.z =
      std::clamp(static_cast<int>(std::ceil(s.thickness / (cellM * sine))) + 1, kFewestLayers, kMostLayers);
  grid.sunward = (azimuth * slant + glm::dvec3(0, 1, 0)) * (s.thickness / (grid.nodes.z - 1));

  // Columns that stand within the radius. Whole moves, one to spare on each side.
  const auto columns = [&](double from, double to, double spacing) {
    const double move = spacing * kColumnsAMove;
    const double first = std::floor(from / move);
    return std::pair(first * move, static_cast<int>(std::ceil(to / move) - first) * kColumnsAMove + 1);
  };
  const double alongMiddle = glm::dot(middle, azimuth), acrossMiddle = glm::dot(middle, grid.across) / cellM;
  const auto [alongFoot, alongNodes] =
      columns(alongMiddle - radiusM, alongMiddle + radiusM, glm::length(grid.along));
  const auto [acrossFoot, acrossNodes] = columns(acrossMiddle - radiusM, acrossMiddle + radiusM, cellM);
  grid.nodes.x = alongNodes;
  grid.nodes.y = acrossNodes;
  grid.foot = azimuth * alongFoot + grid.across * (acrossFoot / cellM) + glm::dvec3(0, s.cloudHeight, 0);
  return grid;
}

std::array<glm::vec4, 3> toSunOpticalDepthGrid(const SunOpticalDepthGridLayout& layout,
                                               const glm::dvec3& eye) {
  const glm::dmat3 toNodes = glm::inverse(glm::dmat3(layout.along, layout.across, layout.sunward));
  const glm::dvec3 ofEye = toNodes * (eye - layout.foot);
  std::array<glm::vec4, 3> rows;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 row(toNodes[0][i], toNodes[1][i], toNodes[2][i]);
    rows[static_cast<std::size_t>(i)] =
        glm::vec4(glm::dvec4(row, ofEye[i] + 0.5) / static_cast<double>(layout.nodes[i]));
  }
  return rows;
}

void SunOpticalDepthGrid::update(gl::Context& context, gl::ShaderCache& shaders,
                                 const SunOpticalDepthGridLayout& layout,
                                 const clouds::CloudLayerSettings& layer,
                                 const clouds::CloudSettings& settings, double meanDetail) {
  std::vector<std::string> defines;
  if (settings.march.detail) defines.emplace_back("DETAIL");
  // Asked for in every frame: a program that frames need now and then counts as used.
  gl::ComputeShader& shader = shaders.computeShader("clouds/sun_optical_depth_grid.comp", defines);
  if (layout == layout_) return;
  if (!depths_ || depths_.format() != GL_R32F || layout.nodes != layout_.nodes) {
    depths_ = gl::Texture::make3D(context, GL_R32F, layout.nodes.x, layout.nodes.y, 1, label_);
  }
  if (uniforms_.size() != sizeof(CloudUniforms))
    uniforms_ = gl::Buffer(context, sizeof(CloudUniforms), gl::Buffer::Use::write, label_);
  layout_ = layout;
  uniforms_.writeValue(0, fieldUniforms(layer, settings.fadeDistance, layout.foot, meanDetail));
  uniforms_.bindBase(GL_UNIFORM_BUFFER, kCloudUniformsBinding);
  depths_.bindImage(0, GL_WRITE_ONLY);
  shader.setVec3("along", glm::vec3(layout.along));
  shader.setVec3("across", glm::vec3(layout.across));
  shader.setVec3("sunward", glm::vec3(layout.sunward));
  shader.setIvec3("nodes", layout.nodes);
  shader.setInt("samplesALayer",
                std::max(1, static_cast<int>(std::round(glm::length(layout.sunward) / kSampleM))));
  shader.dispatch(static_cast<GLuint>(layout.nodes.x + 7) / 8, static_cast<GLuint>(layout.nodes.y + 7) / 8);
  context.api().MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void SunOpticalDepthGrid::update(gl::Context& context, gl::ShaderCache& shaders,
                                 const SunOpticalDepthGridLayout& layout, std::span<const DrawnLayer> layers,
                                 const clouds::CloudSettings& settings, double meanDetail, double sampleM) {
  constexpr double kFewestSamples = 4, kMostSamples = 48;  // of a layer
  std::vector<std::string> defines = {"LAYERS " + std::to_string(layers.size())};
  if (settings.march.detail) defines.emplace_back("DETAIL");
  gl::ComputeShader& shader = shaders.computeShader("clouds/sun_optical_depth_grid.comp", defines);
  if (layout == layout_) return;
  if (!depths_ || depths_.format() != GL_RGBA32F || layout.nodes != layout_.nodes) {
    depths_ = gl::Texture::make3D(context, GL_RGBA32F, layout.nodes.x, layout.nodes.y, 1, label_);
  }
  if (uniforms_.size() != sizeof(CloudUnionUniforms))
    uniforms_ = gl::Buffer(context, sizeof(CloudUnionUniforms), gl::Buffer::Use::write, label_);
  layout_ = layout;
  uniforms_.writeValue(0, unionUniforms(layers, settings.fadeDistance, layout.foot, meanDetail));
  uniforms_.bindBase(GL_UNIFORM_BUFFER, kCloudUniformsBinding);
  depths_.bindImage(0, GL_WRITE_ONLY);
  glm::vec4 samples(0);
  const double slope = glm::length(layout.sunward) / layout.sunward.y;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (!layers[i].isThere) continue;
    const double wayM = layers[i].medium.layer.thickness * slope;
    samples[static_cast<int>(i)] =
        static_cast<float>(std::clamp(std::ceil(wayM / sampleM), kFewestSamples, kMostSamples));
  }
  shader.setVec3("along", glm::vec3(layout.along));
  shader.setVec3("across", glm::vec3(layout.across));
  shader.setVec3("sunward", glm::vec3(layout.sunward));
  shader.setIvec3("nodes", layout.nodes);
  shader.setVec4("samplesOfLayers", samples);
  shader.dispatch(static_cast<GLuint>(layout.nodes.x + 7) / 8, static_cast<GLuint>(layout.nodes.y + 7) / 8);
  context.api().MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

}  // namespace skydrop::render
