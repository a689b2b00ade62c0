// A photograph over the picture: what of it is drawn where, in windows of any size.
#include "skydrop/ui/photo_layer.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <vector>

#include "ui/interface_driver.h"
#include "ui/texture_id.h"

namespace skydrop::ui {
namespace {

// A mesh of 5 x 3 over the picture; the photograph's middle is the picture's and it has so many times its
// width.
struct Mesh {
  explicit Mesh(float width) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 5; ++column) {
        const float x = static_cast<float>(column) / 4, y = static_cast<float>(row) / 2;
        vertices.push_back({x, y, 0.5F + (x - 0.5F) / width, 0.5F + (y - 0.5F) / width});
      }
    }
    layer.texture = 7;
    layer.columns = 5;
    layer.rows = 3;
    layer.vertices = vertices;
  }
  std::vector<PhotoVertex> vertices;
  PhotoLayer layer;
};

struct Drawn {
  float left = 1e9F, right = -1e9F, lowU = 1e9F, highU = -1e9F;
  ImVec4 clip{};
  int opacity = 0;
};

Drawn draw(const PhotoLayer& layer, int width, int height) {
  Drawn drawn;
  test::InterfaceDriver driver(width, height, [&](const Interface&) {
    drawPhotoLayer(layer, static_cast<float>(width), static_cast<float>(height));
  });
  driver.frames(1);
  const ImDrawData* data = driver.drawData();
  for (int i = 0; i < data->CmdListsCount; ++i) {
    const ImDrawList& list = *data->CmdLists[i];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.GetTexID() != textureId(7)) continue;
      drawn.clip = command.ClipRect;
      for (unsigned k = 0; k < command.ElemCount; ++k) {
        const ImDrawVert& vertex =
            list.VtxBuffer[static_cast<int>(list.IdxBuffer[static_cast<int>(command.IdxOffset + k)]) +
                           static_cast<int>(command.VtxOffset)];
        drawn.left = std::min(drawn.left, vertex.pos.x);
        drawn.right = std::max(drawn.right, vertex.pos.x);
        drawn.lowU = std::min(drawn.lowU, vertex.uv.x);
        drawn.highU = std::max(drawn.highU, vertex.uv.x);
        drawn.opacity = static_cast<int>(vertex.col >> IM_COL32_A_SHIFT & 255);
      }
    }
  }
  return drawn;
}

TEST(PhotoLayer, aNarrowPhotographEndsWhereItEnds) {
  // Half as wide as the picture: a quarter of the width is free on both sides, at 640 x 360 and 4K.
  for (const int width : {640, 3840}) {
    const Drawn drawn = draw(Mesh(0.5F).layer, width, width * 9 / 16);
    EXPECT_NEAR(drawn.left, 0.25 * width, 1) << width;
    EXPECT_NEAR(drawn.right, 0.75 * width, 1) << width;
    EXPECT_NEAR(drawn.lowU, 0, 1e-5);
    EXPECT_NEAR(drawn.highU, 1, 1e-5);
    EXPECT_EQ(drawn.opacity, 255);
  }
}

TEST(PhotoLayer, aWideOneIsCutByThePictureAndAWipeByItsShare) {
  Mesh mesh(2);
  mesh.layer.opacity = 0.4F;
  mesh.layer.right = 0.3F;
  const Drawn drawn = draw(mesh.layer, 640, 360);
  EXPECT_NEAR(drawn.lowU, 0.25, 1e-5);
  EXPECT_NEAR(drawn.clip.z, 0.3 * 640, 1);
  EXPECT_EQ(drawn.opacity, 102);
}

TEST(PhotoLayer, aPanoramaGoesOnAcrossItsSeam) {
  // Its left edge lies in the middle of the picture: no cell is drawn backwards through all of it.
  Mesh mesh(1);
  for (PhotoVertex& vertex : mesh.vertices) {
    vertex.u = 0.95F + 0.1F * vertex.x;
    vertex.u -= vertex.u > 1 ? 1.0F : 0.0F;
  }
  mesh.layer.goesRound = true;
  const Drawn drawn = draw(mesh.layer, 640, 360);
  EXPECT_NEAR(drawn.left, 0, 1);
  EXPECT_NEAR(drawn.right, 640, 1);
  EXPECT_LE(drawn.highU - drawn.lowU, 1.1F);
  EXPECT_GE(drawn.lowU, -0.1F);
}

}  // namespace
}  // namespace skydrop::ui
