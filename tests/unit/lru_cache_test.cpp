#include "skydrop/core/lru_cache.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace skydrop::core {
namespace {

using Cache = LRUCache<int, std::string>;

TEST(LRUCache, theLeastRecentlyUsedEntryGoesFirst) {
  // Room for three: a look at the oldest saves it, and the second oldest goes instead.
  Cache cache(30);
  for (int key : {1, 2, 3}) ASSERT_TRUE(cache.insert(key, "v", 10));
  ASSERT_NE(cache.find(1), nullptr);
  ASSERT_TRUE(cache.insert(4, "v", 10));
  EXPECT_TRUE(cache.contains(1));
  EXPECT_FALSE(cache.contains(2));
  EXPECT_TRUE(cache.contains(3));
  EXPECT_EQ(cache.statistics().evictions, 1u);
}

TEST(LRUCache, theSumOfBytesNeverExceedsTheBudget) {
  // Entries of many sizes, inserted and replaced in a scrambled order.
  Cache cache(1000);
  for (int i = 0; i < 5000; ++i) {
    cache.insert((i * 7919) % 97, "v", static_cast<std::size_t>((i * 31) % 300));
    ASSERT_LE(cache.statistics().bytes, 1000u);
  }
  std::size_t sum = 0;
  for (int key = 0; key < 97; ++key) sum += cache.contains(key);
  EXPECT_EQ(sum, cache.statistics().entries);
}

TEST(LRUCache, theWorkingSetIsNeverEvicted) {
  // Three pinned entries in a cache of four: any number of other inserts leaves them alone.
  Cache cache(40);
  const std::vector<int> needed{1, 2, 3};
  cache.setWorkingSet(needed);  // before they are present
  for (int key : needed) ASSERT_TRUE(cache.insert(key, "v", 10));
  for (int key = 100; key < 200; ++key) cache.insert(key, "v", 10);
  for (int key : needed) EXPECT_TRUE(cache.contains(key));
  EXPECT_EQ(cache.statistics().pinnedBytes, 30u);
}

TEST(LRUCache, anInsertThatOnlyTheWorkingSetCouldMakeRoomForIsRefusedAndCounted) {
  Cache cache(30);
  const std::vector<int> needed{1, 2, 3};
  for (int key : needed) ASSERT_TRUE(cache.insert(key, "v", 10));
  cache.setWorkingSet(needed);
  EXPECT_FALSE(cache.insert(4, "v", 10));
  EXPECT_FALSE(cache.insert(5, "v", 31));
  EXPECT_EQ(cache.statistics().refused, 2u);
  cache.setWorkingSet(std::vector<int>{2});
  EXPECT_TRUE(cache.insert(4, "v", 10));
  EXPECT_TRUE(cache.contains(2));
}

TEST(LRUCache, replacingAnEntryCountsItsBytesOnce) {
  Cache cache(30);
  cache.setWorkingSet(std::vector<int>{1});
  ASSERT_TRUE(cache.insert(1, "old", 20));
  ASSERT_TRUE(cache.insert(1, "new", 25));
  EXPECT_EQ(*cache.find(1), "new");
  EXPECT_EQ(cache.statistics().bytes, 25u);
  EXPECT_EQ(cache.statistics().pinnedBytes, 25u);
  cache.erase(1);
  EXPECT_EQ(cache.statistics().bytes, 0u);
  EXPECT_EQ(cache.statistics().pinnedBytes, 0u);
}

TEST(LRUCache, aSmallerBudgetTakesEffectAsSoonAsTheWorkingSetAllows) {
  Cache cache(100);
  std::vector<int> needed;
  for (int key = 0; key < 10; ++key) {
    ASSERT_TRUE(cache.insert(key, "v", 10));
    if (key < 5) needed.push_back(key);
  }
  cache.setWorkingSet(needed);
  cache.setBudget(30);
  EXPECT_EQ(cache.statistics().bytes, 50u);
  cache.setWorkingSet(std::vector<int>{1});
  EXPECT_LE(cache.statistics().bytes, 30u);
  EXPECT_TRUE(cache.contains(1));
}

}  // namespace
}  // namespace skydrop::core
