#include <cstdio>
#include <thread>

#include "app/open_context.h"
#include "app/verbs.h"
#include "app/version.h"
#include "skydrop/core/assets.h"
#include "skydrop/render/gl/limits.h"

namespace skydrop::app {

int info(const CommandLine& line) {
  std::printf("skydrop %s\n", kVersion);
  std::printf("data %s\n", core::dataFolder().string().c_str());
  std::printf("processor threads %u\n", std::thread::hardware_concurrency());
  const auto context = openContext(line.backend, {64, 64});
  std::printf("backend %s\n", std::string(render::gl::backendName(context->backend())).c_str());
  std::printf("OpenGL %s\n", context->version().c_str());
  std::printf("renderer %s (%s)%s\n", context->renderer().c_str(), context->vendor().c_str(),
              context->isSoftware() ? ", software" : "");
  for (const auto& [name, limit] : render::gl::describeLimits(*context)) {
    std::printf("%s %lld\n", name.c_str(), static_cast<long long>(limit));
  }
  return 0;
}

}  // namespace skydrop::app
