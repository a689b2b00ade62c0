// The layer of models (include/skydrop/render/models/model_layer.h): four samples a pixel, alpha 1 where a model is.
layout(binding = 0) uniform sampler2DMS layerColor;
layout(binding = 1) uniform sampler2DMS layerDepth;

uniform ivec2 layerLow;  // the pixel of the picture that the layer begins with

const int kLayerSamples = 4;

struct LayerPixel {
  vec4 color;   // the mean of the samples: premultiplied by coverage
  float depth;  // of the nearest sample
};

LayerPixel layerPixel(ivec2 pixel) {
  LayerPixel mean = LayerPixel(vec4(0.0), 0.0);
  for (int i = 0; i < kLayerSamples; ++i) {
    mean.color += texelFetch(layerColor, pixel - layerLow, i) / float(kLayerSamples);
    mean.depth = max(mean.depth, texelFetch(layerDepth, pixel - layerLow, i).r);
  }
  return mean;
}
