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

TEST(FrameResources, anotherViewHasAllButWhatIsWithdrawn) {
  // The registry that it comes from stays as it is.
  FrameResources frame, view;
  const Map map;
  const FineMap fine;
  frame.publish(map);
  frame.publish(fine);
  view.publishAll(frame);
  view.withdraw<Map>();
  EXPECT_EQ(view.find<Map>(), nullptr);
  EXPECT_EQ(view.find<FineMap>(), &fine);
  EXPECT_EQ(frame.find<Map>(), &map);
}

}  // namespace
}  // namespace skydrop::render
