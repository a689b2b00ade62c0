#include "skydrop/render/frame/frame_resources.h"

#include <gtest/gtest.h>

namespace skydrop::render {
namespace {

struct Map {
  int texels = 0;
};
struct FineMap : Map {};

TEST(FrameResources, whatNobodyPublishedIsNull) {
  // In an empty registry, and beside resources of other types.
  FrameResources resources;
  EXPECT_EQ(resources.find<Map>(), nullptr);
  const int number = 1;
  resources.publish(number);
  EXPECT_EQ(resources.find<Map>(), nullptr);
  EXPECT_EQ(resources.find<unsigned>(), nullptr);
}

TEST(FrameResources, aPublishedResourceIsTheOwnersObject) {
  // By reference: what the owner changes after publishing is seen.
  FrameResources resources;
  Map map{256};
  resources.publish(map);
  ASSERT_EQ(resources.find<Map>(), &map);
  map.texels = 512;
  EXPECT_EQ(resources.get<Map>().texels, 512);
}

TEST(FrameResources, resourcesAreToldApartByTheirExactType) {
  // A base class and what derives from it are two resources, in whatever order they are published.
  FrameResources resources;
  const FineMap fine;
  resources.publish(fine);
  EXPECT_EQ(resources.find<Map>(), nullptr);
  const Map map;
  resources.publish(map);
  EXPECT_EQ(resources.find<Map>(), &map);
  EXPECT_EQ(resources.find<FineMap>(), &fine);
}

}  // namespace
}  // namespace skydrop::render
