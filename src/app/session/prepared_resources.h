#pragma once

#include <map>
#include <memory>
#include <typeindex>
#include <typeinfo>
#include <utility>

namespace skydrop::app {

// What preparations have made for the passes of a scene, by type: each effect puts and finds types of its
// own. A value; copies share the resources.
class PreparedResources {
 public:
  PreparedResources() = default;
  template <class T>
  explicit PreparedResources(std::shared_ptr<const T> resource) {
    put(std::move(resource));
  }

  // In place of an earlier one of this type; null counts as none.
  template <class T>
  void put(std::shared_ptr<const T> resource) {
    resources_.insert_or_assign(typeid(T), std::move(resource));
  }

  // Null where there is none.
  template <class T>
  std::shared_ptr<const T> find() const {
    const auto found = resources_.find(typeid(T));
    return found == resources_.end() ? nullptr : std::static_pointer_cast<const T>(found->second);
  }

 private:
  std::map<std::type_index, std::shared_ptr<const void>> resources_;
};

}  // namespace skydrop::app
