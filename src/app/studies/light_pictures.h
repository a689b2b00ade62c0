// A judged scene as one sees it: octaves, traced paths and the light volume beside each other, in the light
// of the default sky.
#pragma once

#include <functional>
#include <string_view>

#include "app/studies/light_scenes.h"
#include "app/types/size.h"
#include "skydrop/core/image.h"

namespace skydrop::app {

// A row for each of the scene's views; from the left octaves, `paths` traced paths a pixel, and the volume.
// Each picture has the size `each`, every pixel one ray through its middle. Six views of 128 x 72 with 400
// paths take 9 minutes of a core. Bits do not depend on the pool (null: this thread does it all).
core::Image lightPictures(const LightScene& scene, Size each, int paths, core::JobPool* pool,
                          const std::function<void(std::string_view)>& progress);

}  // namespace skydrop::app
