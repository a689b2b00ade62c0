// What a model is made of: the textures of its material, several of a kind multiplied with each other.
#ifdef DIFFUSE_TEXTURES
layout(binding = 0) uniform sampler2D texture_diffuse1;
layout(binding = 4) uniform sampler2D texture_specular1;
#if DIFFUSE_TEXTURES > 1
layout(binding = 1) uniform sampler2D texture_diffuse2;
#endif
#if DIFFUSE_TEXTURES > 2
layout(binding = 2) uniform sampler2D texture_diffuse3;
#endif
#if DIFFUSE_TEXTURES > 3
layout(binding = 3) uniform sampler2D texture_diffuse4;
#endif
#if SPECULAR_TEXTURES > 1
layout(binding = 5) uniform sampler2D texture_specular2;
#endif
#if SPECULAR_TEXTURES > 2
layout(binding = 6) uniform sampler2D texture_specular3;
#endif
#if SPECULAR_TEXTURES > 3
layout(binding = 7) uniform sampler2D texture_specular4;
#endif
#endif

struct Material {
  vec3 albedo;
  vec3 reflectance;  // at normal incidence
  float gloss;       // 0 matt .. 1 mirror
};

// Sharper than the coarser of the two directions asks for: the livery is unrolled, with unequal scales.
const float kSharper = -0.5;

Material materialAt(vec2 uv) {
  vec4 diffuse = texture(texture_diffuse1, uv, kSharper);
  vec4 specular = texture(texture_specular1, uv, kSharper);
#if DIFFUSE_TEXTURES > 1
  diffuse *= texture(texture_diffuse2, uv, kSharper);
#endif
#if DIFFUSE_TEXTURES > 2
  diffuse *= texture(texture_diffuse3, uv, kSharper);
#endif
#if DIFFUSE_TEXTURES > 3
  diffuse *= texture(texture_diffuse4, uv, kSharper);
#endif
#if SPECULAR_TEXTURES > 1
  specular *= texture(texture_specular2, uv, kSharper);
#endif
#if SPECULAR_TEXTURES > 2
  specular *= texture(texture_specular3, uv, kSharper);
#endif
#if SPECULAR_TEXTURES > 3
  specular *= texture(texture_specular4, uv, kSharper);
#endif
  return Material(diffuse.rgb, specular.rgb, specular.a);
}
