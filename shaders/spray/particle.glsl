// The particles of a burst (render::SprayPass): particle i is a function of the burst, of i and of the time alone.
#include "frame.glsl"
#include "shared/hash.glsl"
#include "shared/spray.glsl"

uniform vec4 burstPlace;    // relative to the eye (m); seconds since it happened
uniform vec4 burstTimes;    // seconds over which particles leave, and that each lasts; drag (1/s); fall (m/s^2)
uniform vec4 burstThrow;    // m/s outwards, upwards and at random; radius of where they leave (m)
uniform vec4 burstCarried;  // velocity of all (m/s); how much of what is thrown outwards goes to the sides, [0, 1]
uniform vec4 burstWind;     // m/s
uniform vec4 burstSize;     // radius as they leave and at their end (m), opacity, most of their length over their width
uniform vec4 burstUp;       // unit, of the surface
uniform vec4 burstAlbedo;   // rgb
uniform vec4 burstShares;   // of the light that reaches them
uniform ivec3 burstSeed;    // of the hashes; first particle; whether they are gone below the surface (0, 1)

struct Particle {
  vec3 middle;    // relative to the eye
  vec3 velocity;  // m/s
  float radiusM;
  float opacity;  // 0: there is none
  float turn;     // [0, 1), of its look
  float age;      // share of its life
};

// A level unit vector, or one to either side of the way that all are carried along.
vec2 outwards(float turn) {
  float angle = 6.2831853 * turn;
  vec2 around = vec2(cos(angle), sin(angle));
  vec2 way = burstCarried.xz / max(length(burstCarried.xz), 1e-3);
  vec2 aside = around - way * (dot(around, way) * burstCarried.w);
  return aside / max(length(aside), 1e-2);
}

Particle particleOf(int number) {
  uvec3 bits = hash3(uvec3(uint(number), uint(burstSeed.x), 0x51f15e5du));
  uvec3 more = hash3(bits ^ uvec3(0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u));
  float seconds = burstPlace.w - burstTimes.x * unitOf(bits.x);
  float life = burstTimes.y * (0.6 + 0.4 * unitOf(more.z));
  vec2 out2 = outwards(unitOf(bits.y));
  // What is thrown far is thrown high.
  float strength = mix(0.25, 1.0, sqrt(unitOf(bits.z)));
  vec3 aside = vec3(unitOf(more.x), unitOf(more.y), unitOf(more.x * 0x2545f491u)) * 2.0 - 1.0;
  vec3 out3 = vec3(out2.x, 0.0, out2.y);
  out3 -= burstUp.xyz * dot(out3, burstUp.xyz);
  vec3 thrown = burstCarried.xyz * (0.4 + 0.6 * unitOf(more.y * 0x85ebca77u)) + out3 * (burstThrow.x * strength) +
                burstUp.xyz * (burstThrow.y * strength) + aside * burstThrow.z;
  float t = clamp(seconds, 0.0, life);
  Particle particle;
  particle.age = t / life;
  particle.radiusM = mix(burstSize.x, burstSize.y, sqrt(particle.age)) * (0.7 + 0.6 * unitOf(more.x * 0x9e3779b1u));
  particle.middle = burstPlace.xyz + out3 * (burstThrow.w * sqrt(unitOf(more.z * 0x27d4eb2fu))) +
                    sprayWay(thrown, burstWind.xyz, burstTimes.z, burstTimes.w, t);
  particle.velocity = sprayVelocity(thrown, burstWind.xyz, burstTimes.z, burstTimes.w, t);
  float above = dot(particle.middle - burstPlace.xyz, burstUp.xyz);
  bool isThere = seconds >= 0.0 && seconds < life && (burstSeed.z == 0 || above > -particle.radiusM);
  particle.opacity = isThere ? burstSize.z : 0.0;
  particle.turn = unitOf(more.y);
  return particle;
}

const vec2 kCorners[6] = vec2[](vec2(-1.0, -1.0), vec2(1.0, -1.0), vec2(-1.0, 1.0), vec2(-1.0, 1.0), vec2(1.0, -1.0),
                                vec2(1.0, 1.0));
const float kNearestM = 0.3;  // particles are gone so near to the eye, and whole at eight times that

// Of the picture: nothing where a particle is not seen.
vec4 clipOf(vec3 place, float opacity) {
  vec4 clip = frame.viewProjection * vec4(place, 1.0);
  return opacity > 0.0 ? clip : vec4(2.0, 2.0, 0.5, 1.0);
}

float nearFade(float distanceM) { return smoothstep(kNearestM, 8.0 * kNearestM, distanceM); }

// What the air before a place adds, and what it leaves of a unit of light.
vec3 airBefore(vec3 place) { return applyAerialPerspective(vec3(0.0), place); }
vec3 airLeftOf(vec3 place, vec3 added) { return applyAerialPerspective(vec3(1.0), place) - added; }
