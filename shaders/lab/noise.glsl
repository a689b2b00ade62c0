// The pages of noise. One of PAGE_SINE, PAGE_RANDOM, PAGE_PERLIN, PAGE_SPACE, PAGE_VORONOI, PAGE_FRACTAL and PAGE_SPECTRUM
// is defined.
#include "lab/frame.glsl"
#include "shared/lab/noise.glsl"

// Noise is shown as it is, not as light.
vec3 grey(float value) { return srgbDecode(vec3(saturate(value))); }

vec2 placeIn(Panel panel) { return clamp(panel.uv, vec2(0.0), vec2(0.999999)); }

// A square in the middle of the panel; false beside it. Leaves `panel.uv` as the place in the square.
bool square(inout Panel panel) {
  vec2 at = panel.at * (panel.aspect < 1.0 ? 1.0 / panel.aspect : 1.0);
  if (panel.aspect < 1.0) panel.pixel /= panel.aspect;
  panel.at = at;
  panel.uv = at * 0.5 + 0.5;
  return max(abs(at.x), abs(at.y)) < 1.0;
}

#ifdef PAGE_SINE
vec3 pageColor(vec2 pixel) {
  Panel panel;
  int which = gridPanel(pixel, vec2(0.0), vec2(1.0), 1, 2, panel);
  if (which < 0) return vec3(0.0);
  float scale = which == 0 ? knob_firstScale : knob_secondScale;
  float x = knob_from + panel.uv.x * knob_width;
  float next = x + knob_width * panel.pixel * 0.5 / panel.aspect;
  float value = sineRandom1(x, scale);
  float slope = (sineRandom1(next, scale) - value) / (panel.pixel * 0.5);
  float y = panel.uv.y * 1.1 - 0.05;
  // Where it jumps, a dot.
  float line = markValue(y, value, min(abs(slope), 40.0) < 39.0 ? slope : 0.0, panel.pixel * 0.55);
  return mix(plotPaper(panel.uv), curveColor(0), line);
}
#endif

#ifdef PAGE_RANDOM
vec3 pageColor(vec2 pixel) {
  Panel panel;
  int which = gridPanel(pixel, vec2(0.0), vec2(1.0), 4, 2, panel);
  if (which < 0) return vec3(0.0);
  vec2 cell = floor(vec2(panel.uv.x * panel.aspect, panel.uv.y) * knob_cells);
  int column = which % 4;
  bool isSpace = which >= 4;
  float away = (column & 1) == 0 ? 0.0 : knob_away;
  if (column < 2) {
    vec2 place = cell + away;
    return grey(isSpace ? sineRandom3(vec3(place, away + floor(knob_slice))) : sineRandom2(place));
  }
  uvec2 whole = uvec2(cell) + uint(away);
  return grey(isSpace ? hashRandom3(uvec3(whole, uint(away) + uint(knob_slice))) : hashRandom2(whole));
}
#endif

#ifdef PAGE_PERLIN
const float kShownCells = 5.0;

vec3 signedColor(float value) {
  return value < 0.0 ? mix(vec3(0.03), vec3(0.05, 0.25, 0.9), saturate(-value)) : mix(vec3(0.03), vec3(0.95, 0.4, 0.05), saturate(value));
}

float arrow(vec2 at, vec2 from, vec2 to, float pixel) {
  return max(markLine(at, from, to, 1.2 * pixel), markDisc(at, to, 3.0 * pixel, pixel));
}

vec3 pageColor(vec2 pixel) {
  Panel panel;
  int which = gridPanel(pixel, vec2(0.0), vec2(1.0), 3, 2, panel);
  if (which < 0 || !square(panel)) return vec3(0.0);
  uint salt = octaveSalt(uint(knob_seed), 0u, 2u);
  uint cells = uint(knob_cells);
  float unit = 0.5 * panel.pixel;  // a pixel in uv
  if (which == 4 || which == 5) {
    vec2 at = placeIn(panel) * float(cells);
    return grey(0.5 + 0.5 * perlinOfParts(uvec2(floor(at)), fract(at), cells, salt, which == 5));
  }
  if (which == 0) {
    // Nodes with their gradients, over the noise.
    vec2 at = placeIn(panel) * kShownCells;
    float width = unit * kShownCells;
    vec3 color = 0.4 * grey(0.5 + 0.5 * perlinOfParts(uvec2(floor(at)) % cells, fract(at), cells, salt, true));
    vec2 line = abs(fract(at + 0.5) - 0.5);
    color = mix(color, vec3(0.12), saturate(1.0 - min(line.x, line.y) / width));
    vec2 nearest = floor(at + 0.5);
    float mark = 0.0;
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        vec2 node = clamp(nearest + vec2(i, j), vec2(0.0), vec2(kShownCells));
        mark = max(mark, arrow(at, node, node + 0.45 * nodeGradient(uvec2(node) % cells, salt), width));
      }
    }
    return mix(color, curveColor(0), mark);
  }
  // One cell, with a margin: the place that is looked at, and what it takes from each corner.
  vec2 at = panel.uv * 1.5 - 0.25;
  float width = unit * 1.5;
  vec2 looked = vec2(knob_pointX, knob_pointY);
  uvec2 cell = uvec2(1u, 2u) % cells;
  vec2 inside = clamp(at, vec2(0.0), vec2(1.0));
  vec4 influences = cornerInfluences(cell, looked, cells, salt);
  vec3 color = kPaper;
  if (at == inside) {
    if (which == 3) {
      // The corners' weights as shares of four colours.
      vec4 weights = cornerWeights(inside, true);
      color = weights.x * curveColor(0) + weights.y * curveColor(1) + weights.z * curveColor(2) + weights.w * curveColor(3);
    } else if (which == 2) {
      color = signedColor(dot(cornerInfluences(cell, inside, cells, salt), cornerWeights(inside, true)));
    }
  }
  vec2 edge = abs(abs(at - 0.5) - 0.5);
  if (all(lessThan(abs(at - 0.5), vec2(0.5 + width)))) color = mix(color, vec3(0.3), saturate(1.0 - min(edge.x, edge.y) / width));
  for (int i = 0; i < 4; ++i) {
    vec2 corner = vec2(i & 1, i >> 1);
    uvec2 node = uvec2((i & 1) != 0 ? cellAfter(cell.x, cells) : cell.x, i >= 2 ? cellAfter(cell.y, cells) : cell.y);
    vec2 gradient = nodeGradient(node, salt);
    if (which == 1) {
      color = mix(color, curveColor(1), arrow(at, corner, looked, width));
      color = mix(color, curveColor(0), arrow(at, corner, corner + 0.18 * gradient, width));
    } else if (which == 2) {
      color = mix(color, kInk, arrow(at, corner, corner + 0.25 * influences[i] * gradient, width));
    }
  }
  return mix(color, vec3(1.0), markDisc(at, looked, 3.0 * width, width));
}
#endif

#ifdef PAGE_SPACE
vec3 pageColor(vec2 pixel) {
  Panel panel;
  int which = gridPanel(pixel, vec2(0.0), vec2(1.0), 4, 2, panel);
  if (which < 0) return vec3(0.0);
  square(panel);
  uint salt = octaveSalt(uint(knob_seed), 0u, 3u);
  uint cells = uint(knob_cells);
  // The slices follow one another from left to right; above without the fade.
  float z = fract(knob_slice + 0.25 * float(which % 4) / knob_cells);
  vec3 at = vec3(fract(panel.uv), z) * float(cells);
  return grey(0.5 + 0.5 * perlinInSpaceOfParts(uvec3(floor(at)), fract(at), cells, salt, which >= 4));
}
#endif

#ifdef PAGE_VORONOI
vec3 pageColor(vec2 pixel) {
  Panel panel;
  int which = gridPanel(pixel, vec2(0.0), vec2(1.0), 4, 1, panel);
  if (which < 0) return vec3(0.0);
  square(panel);
  uint salt = uint(knob_seed);
  if (which < 2) {
    // Beyond the square it repeats.
    vec2 place = fract(panel.uv);
    float value = which == 0 ? ownVoronoi(place, uint(knob_cells), salt) : nearVoronoi(place, uint(knob_cells), salt);
    vec2 at = place * knob_cells;
    uvec2 cell = uvec2(floor(at));
    float seed = markDisc(fract(at), voronoiSeed(cell.x, cell.y, salt), 2.5 * 0.5 * panel.pixel * knob_cells, 0.5 * panel.pixel * knob_cells);
    return mix(grey(value), curveColor(0), seed);
  }
  vec2 at = panel.at * knob_cells * 0.5;
  vec3 color = grey(tiledVoronoi(at, int(knob_period), salt, which == 3));
  // Where the period is over.
  vec2 line = abs(fract(at / knob_period + 0.5) - 0.5) * knob_period;
  return mix(color, curveColor(0), 0.7 * saturate(1.0 - min(line.x, line.y) / (0.5 * panel.pixel * knob_cells)));
}
#endif

#ifdef PAGE_FRACTAL
vec3 pageColor(vec2 pixel) {
  Panel panel;
  int which = gridPanel(pixel, vec2(0.0), vec2(1.0), 4, 2, panel);
  if (which < 0) return vec3(0.0);
  square(panel);
  uint octaves = which % 4 == 3 ? uint(knob_octaves) : uint(which % 4) + 1u;
  vec2 place = fract(panel.uv);
  uint salt = uint(knob_seed);
  if (which < 4) return grey(0.5 + 0.7 * perlinFractal(place, uint(knob_cells), octaves, knob_gain, salt));
  return grey(voronoiFractal(place, uint(knob_cells), octaves, knob_gain, salt));
}
#endif

#ifdef PAGE_SPECTRUM
vec3 pageColor(vec2 pixel) {
  Panel panel;
  vec2 plots = vec2(0.45, 0.0);
  int which = gridPanel(pixel, plots, vec2(1.0), 1, 2, panel);
  if (which >= 0) return plotOf(panel, 2 * which, 2);
  which = gridPanel(pixel, vec2(0.0), vec2(0.45, 1.0), 1, 2, panel);
  if (which < 0) return vec3(0.0);
  square(panel);
  vec2 place = fract(panel.uv);
  uint salt = uint(knob_seed);
  if (which == 0) return grey(0.5 + 0.7 * perlinFractal(place, uint(knob_cells), uint(knob_octaves), knob_gain, salt));
  return grey(voronoiFractal(place, uint(knob_cells), uint(knob_octaves), knob_gain, salt));
}
#endif
