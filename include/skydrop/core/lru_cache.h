// A bounded cache: the least recently used entry goes first, and what the current frame needs never goes.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <list>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace skydrop::core {

struct CacheStatistics {
  std::size_t entries = 0, bytes = 0, pinnedBytes = 0, budgetBytes = 0;
  std::uint64_t hits = 0, misses = 0;  // of find() and of the keys handed to setWorkingSet()
  std::uint64_t evictions = 0;
  std::uint64_t refused = 0;  // inserts that would have pushed out the working set
};

// Owner: one thread. Values live until they are evicted: a pointer from find() is good until the next
// insert(), setBudget() or erase(). Each entry brings its own size in bytes; the sum never exceeds the
// budget, except after setBudget() to less than the working set needs (then it shrinks as soon as the working
// set does).
template <class Key, class Value, class Hash = std::hash<Key>>
class LRUCache {
 public:
  explicit LRUCache(std::size_t budgetBytes) : budgetBytes_(budgetBytes) {}

  // Declares what the current frame needs: these keys, whether present yet or not, are not evicted until the
  // next call. Present ones become the most recently used, the first key the most recent of all.
  void setWorkingSet(std::span<const Key> keys) {
    pinned_.clear();
    pinned_.insert(keys.begin(), keys.end());
    pinnedBytes_ = 0;
    for (std::size_t i = keys.size(); i-- > 0;) {
      const auto at = index_.find(keys[i]);
      at == index_.end() ? ++misses_ : ++hits_;
      if (at == index_.end()) continue;
      entries_.splice(entries_.begin(), entries_, at->second);
    }
    for (const Key& key : pinned_) {
      const auto at = index_.find(key);
      if (at != index_.end()) pinnedBytes_ += at->second->bytes;
    }
    shrinkTo(budgetBytes_);
  }

  // The value, now the most recently used; null when absent.
  Value* find(const Key& key) {
    const auto at = index_.find(key);
    at == index_.end() ? ++misses_ : ++hits_;
    if (at == index_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, at->second);
    return &at->second->value;
  }

  // Looks without touching order or statistics.
  bool contains(const Key& key) const { return index_.contains(key); }
  const Value* peek(const Key& key) const {
    const auto at = index_.find(key);
    return at == index_.end() ? nullptr : &at->second->value;
  }

  // Takes the value (replacing one under the same key) and evicts what does not fit any more. False, and
  // counted, when only the working set could make room: then nothing changes.
  bool insert(const Key& key, Value value, std::size_t bytes) {
    const auto old = index_.find(key);
    const std::size_t oldBytes = old == index_.end() ? 0 : old->second->bytes;
    const bool wanted = pinned_.contains(key);
    const std::size_t untouchable = pinnedBytes_ - (wanted ? oldBytes : 0);
    if (bytes > budgetBytes_ || untouchable > budgetBytes_ - bytes) {
      ++refused_;
      return false;
    }
    if (old != index_.end()) erase(key);
    shrinkTo(budgetBytes_ - bytes);
    entries_.push_front(Entry{key, std::move(value), bytes});
    index_.emplace(key, entries_.begin());
    bytes_ += bytes;
    if (wanted) pinnedBytes_ += bytes;
    assert(bytes_ <= budgetBytes_);
    return true;
  }

  // Evicts the least recently used entries outside the working set until `bytes` more would fit.
  void makeRoom(std::size_t bytes) { shrinkTo(budgetBytes_ - std::min(bytes, budgetBytes_)); }

  void erase(const Key& key) {
    const auto at = index_.find(key);
    if (at == index_.end()) return;
    bytes_ -= at->second->bytes;
    if (pinned_.contains(key)) pinnedBytes_ -= at->second->bytes;
    entries_.erase(at->second);
    index_.erase(at);
  }

  void clear() {
    entries_.clear();
    index_.clear();
    bytes_ = pinnedBytes_ = 0;
  }

  void setBudget(std::size_t bytes) {
    budgetBytes_ = bytes;
    shrinkTo(budgetBytes_);
  }

  CacheStatistics statistics() const {
    return {index_.size(), bytes_, pinnedBytes_, budgetBytes_, hits_, misses_, evictions_, refused_};
  }

 private:
  struct Entry {
    Key key;
    Value value;
    std::size_t bytes;
  };

  void shrinkTo(std::size_t limit) {
    for (auto at = entries_.end(); bytes_ > limit && at != entries_.begin();) {
      --at;
      if (pinned_.contains(at->key)) continue;
      bytes_ -= at->bytes;
      index_.erase(at->key);
      at = entries_.erase(at);
      ++evictions_;
    }
  }

  std::list<Entry> entries_;  // most recently used first
  std::unordered_map<Key, typename std::list<Entry>::iterator, Hash> index_;
  std::unordered_set<Key, Hash> pinned_;
  std::size_t budgetBytes_ = 0, bytes_ = 0, pinnedBytes_ = 0;
  std::uint64_t hits_ = 0, misses_ = 0, evictions_ = 0, refused_ = 0;
};

}  // namespace skydrop::core
