// What all pages of the laboratory have in common: knobs, panels of a picture, marks, plots, and the way to the screen.
#include "shared/guards.glsl"
#include "shared/tone_map.glsl"
#include "shared/lab/orbit.glsl"

const int kPlotPlaces = 24;

uniform vec2 pictureSize;   // pixels
uniform float knobs[32];    // by the page's table; the defines knob_NAME name them
uniform float curves[96];   // kPlotPlaces a curve
uniform int curveCount;

const vec3 kPaper = vec3(0.012, 0.015, 0.02);
const vec3 kGrid = vec3(0.05, 0.06, 0.075);
const vec3 kInk = vec3(0.85, 0.86, 0.88);

// A part of the picture. `at` is 0 in its middle and +-1 at its lower and upper edge, `uv` in [0, 1].
struct Panel {
  vec2 at;
  vec2 uv;
  float pixel;   // a pixel's size in `at`
  float aspect;  // width over height
};

// Whether the pixel is in this rectangle (low and high corner, in shares of the picture); leaves a seam between two.
bool panelAt(vec2 pixel, vec2 low, vec2 high, out Panel panel) {
  vec2 from = low * pictureSize;
  vec2 size = (high - low) * pictureSize;
  vec2 place = pixel - from;
  panel.uv = place / size;
  panel.at = (place - 0.5 * size) * 2.0 / size.y;
  panel.pixel = 2.0 / size.y;
  panel.aspect = size.x / size.y;
  return all(greaterThan(place, vec2(1.0))) && all(lessThan(place, size - 1.0));
}

// One of columns * rows equal panels, counted from the upper left one; -1 on a seam.
int gridPanel(vec2 pixel, vec2 low, vec2 high, int columns, int rows, out Panel panel) {
  vec2 uv = (pixel / pictureSize - low) / (high - low);
  if (any(lessThan(uv, vec2(0.0))) || any(greaterThanEqual(uv, vec2(1.0)))) return -1;
  vec2 count = vec2(columns, rows);
  vec2 cell = floor(uv * count);
  bool inside = panelAt(pixel, mix(low, high, cell / count), mix(low, high, (cell + 1.0) / count), panel);
  return inside ? (rows - 1 - int(cell.y)) * columns + int(cell.x) : -1;
}

float radiansOf(float angle) { return angle * 0.017453292519943295; }

// 1 on a line or a disc, 0 away from it, softened over a pixel.
float markDisc(vec2 at, vec2 middle, float radius, float pixel) {
  return saturate((radius - length(at - middle)) / pixel + 0.5);
}
float markCircle(vec2 at, vec2 middle, float radius, float pixel) {
  return saturate(1.0 - abs(length(at - middle) - radius) / pixel);
}
float markLine(vec2 at, vec2 from, vec2 to, float width) {
  vec2 way = to - from;
  float t = saturate(dot(at - from, way) / max(dot(way, way), 1e-12));
  return saturate(1.0 - length(at - from - way * t) / width);
}

vec3 curveColor(int i) {
  if (i == 0) return vec3(1.0, 0.45, 0.1);
  if (i == 1) return vec3(0.15, 0.55, 1.0);
  return i == 2 ? vec3(0.3, 0.9, 0.3) : vec3(0.8, 0.3, 0.9);
}

// A function's value drawn as a line: `value` and its slope over a pixel, at the height `y`, all in [0, 1].
float markValue(float y, float value, float slope, float pixel) {
  return saturate(1.5 - abs(y - value) / (pixel * sqrt(1.0 + slope * slope)));
}

vec3 plotPaper(vec2 uv) {
  vec2 cell = abs(fract(uv * 6.0 + 0.5) - 0.5) / 6.0;
  return mix(kPaper, kGrid, step(min(cell.x * pictureSize.x, cell.y * pictureSize.y), 1.0));
}

// Of the curves, `count` from `first` on.
vec3 plotOf(Panel panel, int first, int count) {
  vec3 color = plotPaper(panel.uv);
  float x = panel.uv.x * float(kPlotPlaces - 1);
  int left = clamp(int(x), 0, kPlotPlaces - 2);
  for (int i = 0; i < count; ++i) {
    float a = curves[(first + i) * kPlotPlaces + left];
    float b = curves[(first + i) * kPlotPlaces + left + 1];
    float slope = (b - a) * float(kPlotPlaces - 1) * 0.5;
    color = mix(color, curveColor(i), markValue(panel.uv.y, mix(a, b, x - float(left)), slope, 0.5 * panel.pixel));
  }
  return color;
}
vec3 plotColor(Panel panel) { return plotOf(panel, 0, curveCount); }

vec3 encoded(vec3 light) { return srgbEncode(clamp(light, vec3(0.0), vec3(1.0))); }
