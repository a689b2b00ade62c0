#include <thread>

#include "app/cli/verbs.h"
#include "app/console/standard_output.h"
#include "app/session/open_context.h"
#include "app/types/version.h"
#include "skydrop/core/assets.h"
#include "skydrop/render/gl/limits.h"

namespace skydrop::app {

int info(const CommandLine& line) {
  print("skydrop %s\n", kVersion);
  print("data %s\n", core::dataFolder().string().c_str());
  print("processor threads %u\n", std::thread::hardware_concurrency());
  const auto context = openContext(line.backend, {64, 64});
  print("backend %s\n", std::string(render::gl::backendName(context->backend())).c_str());
  print("OpenGL %s\n", context->version().c_str());
  print("renderer %s (%s)%s\n", context->renderer().c_str(), context->vendor().c_str(),
        context->isSoftware() ? ", software" : "");
  for (const auto& [name, limit] : render::gl::describeLimits(*context)) {
    print("%s %lld\n", name.c_str(), static_cast<long long>(limit));
  }
  return 0;
}

}  // namespace skydrop::app
