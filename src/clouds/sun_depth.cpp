#include "skydrop/clouds/sun_depth.h"

#include <algorithm>

#include "skydrop/core/shared.h"

namespace skydrop::clouds {

double sunOpticalDepth(const CloudField& field, const glm::dvec3& place, const glm::dvec3& toSun,
                       int samples) {
  namespace f64 = core::shared::f64;
  const CloudLayerSettings& layer = field.layer();
  const double toBase = std::max(0.0, layer.cloudHeight - place.y) / toSun.y;
  const double wayM = (layer.cloudHeight + layer.thickness - place.y) / toSun.y - toBase;
  if (!(wayM > 0)) return 0;
  double depth = 0, begin = 0;
  for (int i = 1; i <= samples; ++i) {
    const double end = f64::sunPartBegin(i, samples, wayM);
    const glm::dvec3 middle = place + toSun * (toBase + 0.5 * (begin + end));
    depth += static_cast<double>(field.densityInFloat(middle)) * (end - begin);
    begin = end;
  }
  return depth * layer.extinction;
}

}  // namespace skydrop::clouds
