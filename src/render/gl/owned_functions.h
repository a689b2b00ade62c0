// The functions that only the sources of render/gl may call: they create and delete objects, compile, draw
// and dispatch, and so must pass through the objects and the resource tracker; and the driver's own state.
#pragma once

#include <GL/glcorearb.h>

#define SKYDROP_GL_OWNED_FUNCTIONS(X)                                                         \
  X(ATTACHSHADER, AttachShader)                                                               \
  X(COMPILESHADER, CompileShader)                                                             \
  X(CREATEBUFFERS, CreateBuffers)                                                             \
  X(CREATEFRAMEBUFFERS, CreateFramebuffers)                                                   \
  X(CREATEPROGRAM, CreateProgram)                                                             \
  X(CREATEQUERIES, CreateQueries)                                                             \
  X(CREATESAMPLERS, CreateSamplers)                                                           \
  X(CREATESHADER, CreateShader)                                                               \
  X(CREATETEXTURES, CreateTextures)                                                           \
  X(CREATEVERTEXARRAYS, CreateVertexArrays)                                                   \
  X(DELETEBUFFERS, DeleteBuffers)                                                             \
  X(DELETEFRAMEBUFFERS, DeleteFramebuffers)                                                   \
  X(DELETEPROGRAM, DeleteProgram)                                                             \
  X(DELETEQUERIES, DeleteQueries)                                                             \
  X(DELETESAMPLERS, DeleteSamplers)                                                           \
  X(DELETESHADER, DeleteShader)                                                               \
  X(DELETETEXTURES, DeleteTextures)                                                           \
  X(DELETEVERTEXARRAYS, DeleteVertexArrays)                                                   \
  X(DETACHSHADER, DetachShader)                                                               \
  X(DISPATCHCOMPUTE, DispatchCompute)                                                         \
  X(DISPATCHCOMPUTEINDIRECT, DispatchComputeIndirect)                                         \
  X(DRAWARRAYS, DrawArrays)                                                                   \
  X(DRAWARRAYSINSTANCED, DrawArraysInstanced)                                                 \
  X(DRAWELEMENTS, DrawElements)                                                               \
  X(DRAWELEMENTSBASEVERTEX, DrawElementsBaseVertex)                                           \
  X(DRAWELEMENTSINSTANCED, DrawElementsInstanced)                                             \
  X(DRAWELEMENTSINSTANCEDBASEVERTEXBASEINSTANCE, DrawElementsInstancedBaseVertexBaseInstance) \
  X(GETGRAPHICSRESETSTATUS, GetGraphicsResetStatus)                                           \
  X(GETPROGRAMINFOLOG, GetProgramInfoLog)                                                     \
  X(GETSHADERINFOLOG, GetShaderInfoLog)                                                       \
  X(GETSHADERIV, GetShaderiv)                                                                 \
  X(LINKPROGRAM, LinkProgram)                                                                 \
  X(MULTIDRAWELEMENTSINDIRECT, MultiDrawElementsIndirect)                                     \
  X(SHADERSOURCE, ShaderSource)

namespace skydrop::render::gl {

struct OwnedFunctions {
#define SKYDROP_GL_MEMBER(TYPE, name) PFNGL##TYPE##PROC name = nullptr;
  SKYDROP_GL_OWNED_FUNCTIONS(SKYDROP_GL_MEMBER)
#undef SKYDROP_GL_MEMBER
};

}  // namespace skydrop::render::gl
