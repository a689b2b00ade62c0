#include "app/verbs.h"
#include "skydrop/core/error.h"
namespace skydrop::app {
int fly(const CommandLine&) { throw core::GraphicsUnavailable("no display; `skydrop render` needs none"); }
}
