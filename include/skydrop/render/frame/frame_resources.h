// What the passes of one frame make for each other, by type: a pass publishes a resource that it owns, and
// later passes ask for it without naming who made it. A resource that nobody published is not an error to ask
// for.
#pragma once

#include <cassert>
#include <typeindex>
#include <typeinfo>
#include <utility>
#include <vector>

namespace skydrop::render {

// Main thread. One registry lives as long as one frame, so nothing of an earlier frame can be found; a
// published object must stay where it is until the frame has been drawn. Few types are published, so a search
// compares a few pointers.
class FrameResources {
 public:
  FrameResources() = default;
  FrameResources(const FrameResources&) = delete;
  FrameResources& operator=(const FrameResources&) = delete;

  // Makes `resource` the frame's T for passes that are drawn after this one. At most one of a type in a
  // frame.
  template <class T>
  void publish(const T& resource) {
    assert(!find<T>());
    entries_.emplace_back(typeid(T), &resource);
  }

  // The same, in place of the T that an earlier pass has published; that one, null where there was none.
  template <class T>
  const T* replace(const T& resource) {
    for (auto& [type, entry] : entries_) {
      if (type == typeid(T)) return static_cast<const T*>(std::exchange(entry, &resource));
    }
    publish(resource);
    return nullptr;
  }

  // All that another registry has, of types that this one lacks.
  void publishAll(const FrameResources& other) {
    entries_.insert(entries_.end(), other.entries_.begin(), other.entries_.end());
  }
  // Later passes find no T.
  template <class T>
  void withdraw() {
    std::erase_if(entries_, [](const auto& entry) { return entry.first == typeid(T); });
  }

  // Null where no pass has published a T yet.
  template <class T>
  const T* find() const {
    for (const auto& [type, resource] : entries_) {
      if (type == typeid(T)) return static_cast<const T*>(resource);
    }
    return nullptr;
  }

  // For a pass that is added only beside the one that publishes T: there must be one.
  template <class T>
  const T& get() const {
    const T* resource = find<T>();
    assert(resource);
    return *resource;
  }

 private:
  std::vector<std::pair<std::type_index, const void*>> entries_;
};

}  // namespace skydrop::render
