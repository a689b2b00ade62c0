// Which pixels of a picture a layer of ice may touch.
#pragma once

#include "skydrop/clouds/ice_clouds.h"
#include "skydrop/render/frame/pixel_box.h"
#include "skydrop/render/frame/view.h"

namespace skydrop::render {

// Conservative; empty where no ray of the picture meets the layer.
PixelBox pixelsOfIce(const View& view, const clouds::IceLayer& layer);

}  // namespace skydrop::render
