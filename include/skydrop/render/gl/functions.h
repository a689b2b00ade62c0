// The functions of OpenGL 4.5 core that the game calls, as an own table: types from <GL/glcorearb.h>,
// pointers from the context's own getProcAddress, because no loader library works with EGL and OSMesa in one
// process (docs/headless.md). A function that is missing from the list is added to it by one line.
#pragma once

#include <GL/glcorearb.h>

// X(NAME OF THE POINTER TYPE, name): state, transfers, queries of what exists.
#define SKYDROP_GL_FUNCTIONS(X)                                     \
  X(BEGINQUERY, BeginQuery)                                         \
  X(BINDBUFFER, BindBuffer)                                         \
  X(BINDBUFFERBASE, BindBufferBase)                                 \
  X(BINDBUFFERRANGE, BindBufferRange)                               \
  X(BINDFRAMEBUFFER, BindFramebuffer)                               \
  X(BINDIMAGETEXTURE, BindImageTexture)                             \
  X(BINDSAMPLER, BindSampler)                                       \
  X(BINDTEXTUREUNIT, BindTextureUnit)                               \
  X(BINDVERTEXARRAY, BindVertexArray)                               \
  X(BLENDEQUATION, BlendEquation)                                   \
  X(BLENDFUNC, BlendFunc)                                           \
  X(BLENDFUNCSEPARATE, BlendFuncSeparate)                           \
  X(BLITNAMEDFRAMEBUFFER, BlitNamedFramebuffer)                     \
  X(CHECKNAMEDFRAMEBUFFERSTATUS, CheckNamedFramebufferStatus)       \
  X(CLEAR, Clear)                                                   \
  X(CLEARCOLOR, ClearColor)                                         \
  X(CLEARDEPTHF, ClearDepthf)                                       \
  X(CLEARNAMEDBUFFERDATA, ClearNamedBufferData)                     \
  X(CLEARNAMEDBUFFERSUBDATA, ClearNamedBufferSubData)               \
  X(CLEARNAMEDFRAMEBUFFERFI, ClearNamedFramebufferfi)               \
  X(CLEARNAMEDFRAMEBUFFERFV, ClearNamedFramebufferfv)               \
  X(CLEARNAMEDFRAMEBUFFERIV, ClearNamedFramebufferiv)               \
  X(CLEARTEXIMAGE, ClearTexImage)                                   \
  X(CLIPCONTROL, ClipControl)                                       \
  X(COLORMASK, ColorMask)                                           \
  X(COPYIMAGESUBDATA, CopyImageSubData)                             \
  X(COPYNAMEDBUFFERSUBDATA, CopyNamedBufferSubData)                 \
  X(CULLFACE, CullFace)                                             \
  X(DEBUGMESSAGECALLBACK, DebugMessageCallback)                     \
  X(DEBUGMESSAGECONTROL, DebugMessageControl)                       \
  X(DEBUGMESSAGEINSERT, DebugMessageInsert)                         \
  X(DEPTHFUNC, DepthFunc)                                           \
  X(DEPTHMASK, DepthMask)                                           \
  X(DISABLE, Disable)                                               \
  X(DISABLEI, Disablei)                                             \
  X(ENABLE, Enable)                                                 \
  X(ENABLEVERTEXARRAYATTRIB, EnableVertexArrayAttrib)               \
  X(ENABLEI, Enablei)                                               \
  X(ENDQUERY, EndQuery)                                             \
  X(FINISH, Finish)                                                 \
  X(FLUSH, Flush)                                                   \
  X(FLUSHMAPPEDNAMEDBUFFERRANGE, FlushMappedNamedBufferRange)       \
  X(FRONTFACE, FrontFace)                                           \
  X(GENERATETEXTUREMIPMAP, GenerateTextureMipmap)                   \
  X(GETACTIVEUNIFORM, GetActiveUniform)                             \
  X(GETACTIVEUNIFORMBLOCKIV, GetActiveUniformBlockiv)               \
  X(GETACTIVEUNIFORMSIV, GetActiveUniformsiv)                       \
  X(GETERROR, GetError)                                             \
  X(GETFLOATV, GetFloatv)                                           \
  X(GETINTEGER64V, GetInteger64v)                                   \
  X(GETINTEGERI_V, GetIntegeri_v)                                   \
  X(GETINTEGERV, GetIntegerv)                                       \
  X(GETNAMEDBUFFERSUBDATA, GetNamedBufferSubData)                   \
  X(GETPROGRAMINTERFACEIV, GetProgramInterfaceiv)                   \
  X(GETPROGRAMRESOURCEINDEX, GetProgramResourceIndex)               \
  X(GETPROGRAMRESOURCENAME, GetProgramResourceName)                 \
  X(GETPROGRAMRESOURCEIV, GetProgramResourceiv)                     \
  X(GETPROGRAMIV, GetProgramiv)                                     \
  X(GETQUERYOBJECTIV, GetQueryObjectiv)                             \
  X(GETQUERYOBJECTUI64V, GetQueryObjectui64v)                       \
  X(GETQUERYOBJECTUIV, GetQueryObjectuiv)                           \
  X(GETSTRING, GetString)                                           \
  X(GETSTRINGI, GetStringi)                                         \
  X(GETTEXTUREIMAGE, GetTextureImage)                               \
  X(GETTEXTURELEVELPARAMETERIV, GetTextureLevelParameteriv)         \
  X(GETTEXTURESUBIMAGE, GetTextureSubImage)                         \
  X(GETUNIFORMBLOCKINDEX, GetUniformBlockIndex)                     \
  X(GETUNIFORMINDICES, GetUniformIndices)                           \
  X(GETUNIFORMLOCATION, GetUniformLocation)                         \
  X(INVALIDATENAMEDFRAMEBUFFERDATA, InvalidateNamedFramebufferData) \
  X(ISENABLED, IsEnabled)                                           \
  X(LINEWIDTH, LineWidth)                                           \
  X(MAPNAMEDBUFFERRANGE, MapNamedBufferRange)                       \
  X(MEMORYBARRIER, MemoryBarrier)                                   \
  X(NAMEDBUFFERSTORAGE, NamedBufferStorage)                         \
  X(NAMEDBUFFERSUBDATA, NamedBufferSubData)                         \
  X(NAMEDFRAMEBUFFERDRAWBUFFER, NamedFramebufferDrawBuffer)         \
  X(NAMEDFRAMEBUFFERDRAWBUFFERS, NamedFramebufferDrawBuffers)       \
  X(NAMEDFRAMEBUFFERREADBUFFER, NamedFramebufferReadBuffer)         \
  X(NAMEDFRAMEBUFFERTEXTURE, NamedFramebufferTexture)               \
  X(NAMEDFRAMEBUFFERTEXTURELAYER, NamedFramebufferTextureLayer)     \
  X(OBJECTLABEL, ObjectLabel)                                       \
  X(PIXELSTOREI, PixelStorei)                                       \
  X(POINTSIZE, PointSize)                                           \
  X(POLYGONMODE, PolygonMode)                                       \
  X(POLYGONOFFSET, PolygonOffset)                                   \
  X(POPDEBUGGROUP, PopDebugGroup)                                   \
  X(PROGRAMUNIFORM1F, ProgramUniform1f)                             \
  X(PROGRAMUNIFORM1FV, ProgramUniform1fv)                           \
  X(PROGRAMUNIFORM1I, ProgramUniform1i)                             \
  X(PROGRAMUNIFORM1IV, ProgramUniform1iv)                           \
  X(PROGRAMUNIFORM1UI, ProgramUniform1ui)                           \
  X(PROGRAMUNIFORM2FV, ProgramUniform2fv)                           \
  X(PROGRAMUNIFORM2IV, ProgramUniform2iv)                           \
  X(PROGRAMUNIFORM3FV, ProgramUniform3fv)                           \
  X(PROGRAMUNIFORM3IV, ProgramUniform3iv)                           \
  X(PROGRAMUNIFORM4FV, ProgramUniform4fv)                           \
  X(PROGRAMUNIFORM4IV, ProgramUniform4iv)                           \
  X(PROGRAMUNIFORMMATRIX3FV, ProgramUniformMatrix3fv)               \
  X(PROGRAMUNIFORMMATRIX4FV, ProgramUniformMatrix4fv)               \
  X(PUSHDEBUGGROUP, PushDebugGroup)                                 \
  X(QUERYCOUNTER, QueryCounter)                                     \
  X(READBUFFER, ReadBuffer)                                         \
  X(READPIXELS, ReadPixels)                                         \
  X(SAMPLERPARAMETERF, SamplerParameterf)                           \
  X(SAMPLERPARAMETERFV, SamplerParameterfv)                         \
  X(SAMPLERPARAMETERI, SamplerParameteri)                           \
  X(SCISSOR, Scissor)                                               \
  X(SHADERSTORAGEBLOCKBINDING, ShaderStorageBlockBinding)           \
  X(STENCILFUNC, StencilFunc)                                       \
  X(STENCILMASK, StencilMask)                                       \
  X(STENCILOP, StencilOp)                                           \
  X(TEXTUREBARRIER, TextureBarrier)                                 \
  X(TEXTUREPARAMETERF, TextureParameterf)                           \
  X(TEXTUREPARAMETERFV, TextureParameterfv)                         \
  X(TEXTUREPARAMETERI, TextureParameteri)                           \
  X(TEXTURESTORAGE2D, TextureStorage2D)                             \
  X(TEXTURESTORAGE2DMULTISAMPLE, TextureStorage2DMultisample)       \
  X(TEXTURESTORAGE3D, TextureStorage3D)                             \
  X(TEXTURESUBIMAGE2D, TextureSubImage2D)                           \
  X(TEXTURESUBIMAGE3D, TextureSubImage3D)                           \
  X(UNIFORMBLOCKBINDING, UniformBlockBinding)                       \
  X(UNMAPNAMEDBUFFER, UnmapNamedBuffer)                             \
  X(USEPROGRAM, UseProgram)                                         \
  X(VERTEXARRAYATTRIBBINDING, VertexArrayAttribBinding)             \
  X(VERTEXARRAYATTRIBFORMAT, VertexArrayAttribFormat)               \
  X(VERTEXARRAYATTRIBIFORMAT, VertexArrayAttribIFormat)             \
  X(VERTEXARRAYBINDINGDIVISOR, VertexArrayBindingDivisor)           \
  X(VERTEXARRAYELEMENTBUFFER, VertexArrayElementBuffer)             \
  X(VERTEXARRAYVERTEXBUFFER, VertexArrayVertexBuffer)               \
  X(VIEWPORT, Viewport)

namespace skydrop::render::gl {

// Called as api().Clear(...). What creates, deletes, compiles, draws and dispatches is not in here: objects
// are move-only values, and draws go through Context, which counts them.
struct Functions {
#define SKYDROP_GL_MEMBER(TYPE, name) PFNGL##TYPE##PROC name = nullptr;
  SKYDROP_GL_FUNCTIONS(SKYDROP_GL_MEMBER)
#undef SKYDROP_GL_MEMBER
};

}  // namespace skydrop::render::gl
