// Permissions do not bind root: as nobody they do.
#pragma once

#include <unistd.h>

#include <cstdlib>

namespace skydrop::test {

// While it lives, a process that root started acts for a user without rights.
class AsNobody {
 public:
  AsNobody() : id_(::geteuid()) {
    if (id_ == 0 && ::seteuid(65534) != 0) std::abort();
  }
  ~AsNobody() {
    if (id_ == 0 && ::seteuid(0) != 0) std::abort();
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  uid_t id_;
};

}  // namespace skydrop::test
