#include "skydrop/render/gl/query.h"

#include "render/gl/created.h"
#include "render/gl/owned_functions.h"

namespace skydrop::render::gl {
namespace {

GLuint createQuery(Context& context, GLenum target) {
  GLuint id = 0;
  context.owned().CreateQueries(target, 1, &id);
  return created(id, "query");
}

}  // namespace

Query::Query(Context& context, GLenum target)
    : Object(context, ObjectKind::query, createQuery(context, target)), target_(target) {}

void Query::begin() { context().api().BeginQuery(target_, id()); }

void Query::end() { context().api().EndQuery(target_); }

std::optional<std::uint64_t> Query::poll() const {
  GLuint available = 0;
  context().api().GetQueryObjectuiv(id(), GL_QUERY_RESULT_AVAILABLE, &available);
  if (!available) return std::nullopt;
  return result();
}

std::uint64_t Query::result() const {
  GLuint64 value = 0;
  context().api().GetQueryObjectui64v(id(), GL_QUERY_RESULT, &value);
  return value;
}

}  // namespace skydrop::render::gl
