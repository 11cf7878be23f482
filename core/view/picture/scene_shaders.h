// The shaders of scene_picture: how ground, solids and sky are lit.
#pragma once

namespace lsos::scene_shaders {

// Depth of a body as seen from the Sun.
inline constexpr const char* depth_vertex = R"(#version 330 core
uniform mat4 to_map;
layout(location = 0) in vec3 p_m;
void main() { gl_Position = to_map * vec4(p_m, 1.0); }
)";
inline constexpr const char* depth_fragment = R"(#version 330 core
void main() {}
)";

// Tone mapping from light to screen colours: highlights are compressed, not clipped, and air adds
// its own light with distance.
inline constexpr const char* tone = R"(
vec3 toned(vec3 bright, float distance_m, vec3 horizon, float sight_m) {
  bright = 1.12 * bright / (bright + 0.6);
  if (sight_m > 0.0) bright = mix(pow(horizon, vec3(2.2)), bright, exp(-distance_m / sight_m));
  return pow(bright, vec3(1.0 / 2.2));
}
)";

// Light is computed at vertices, which are a few pixels apart on the ground. The eye is the origin.
// kind 0: ground, 1: a solid, 2: a mark. Ground reflects light half as the Moon does (Lommel and
// Seeliger), half by Lambert's law. Exposure is fitted to level ground; solids get its square root,
// otherwise low sunlight would bleach them.
inline constexpr const char* surface_vertex = R"(
uniform int kind;
uniform mat4 to_picture;
uniform vec3 sun, up, anchor_m;
uniform float exposure, sky_light, moonlike, pixel_share;
layout(location = 0) in vec3 p_m;
layout(location = 1) in vec3 normal_in;
layout(location = 2) in vec3 colour_in;
layout(location = 3) in float sun_share;
out vec3 at_m, normal, colour;
out vec2 light;  // of the Sun, of all else
out vec3 plain;  // as it is drawn where no body shades it
uniform vec3 horizon;
uniform float sight_m;

float hash(vec2 at) { return fract(sin(dot(at, vec2(12.9898, 78.233))) * 43758.5453); }
float noise(vec2 at) {
  vec2 i = floor(at), f = fract(at);
  f = f * f * (3.0 - 2.0 * f);
  return mix(mix(hash(i), hash(i + vec2(1, 0)), f.x),
             mix(hash(i + vec2(0, 1)), hash(i + vec2(1, 1)), f.x), f.y);
}
// Grains of soil, where they are larger than what is between vertices.
float grain() {
  vec2 at = p_m.xy + anchor_m.xy;
  float pixel_m = pixel_share * length(p_m);
  float fine = 1.0 - smoothstep(0.02, 0.06, pixel_m), wide = 1.0 - smoothstep(0.1, 0.5, pixel_m);
  return 1.0 + 0.22 * fine * (noise(at * 7.0) - 0.5) + 0.14 * wide * (noise(at * 1.3) - 0.5);
}

void main() {
  at_m = p_m;
  normal = normal_in;
  gl_Position = to_picture * vec4(p_m, 1.0);
  float facing = max(0.0, dot(normal, sun)), seen = max(0.08, -dot(normal, normalize(p_m)));
  float moon = mix(facing, facing / (facing + seen) + 0.5 * facing, moonlike);
  light = vec2(sun_share * (kind == 0 ? exposure * moon : sqrt(exposure) * facing),
               sky_light * (kind == 0 ? 1.0 : 1.0 + 1.5 * moonlike) * (0.7 + 0.3 * dot(normal, up)));
  colour = colour_in * (kind == 0 ? grain() : 1.0);
  plain = kind == 2 ? colour_in : toned(colour * (light.x + light.y), length(p_m), horizon, sight_m);
}
)";

// Fragments that no body shades.
inline constexpr const char* plain_fragment = R"(#version 330 core
in vec3 plain;
out vec4 drawn;
void main() { drawn = vec4(plain, 1.0); }
)";

// Fragments that bodies may shade.
inline constexpr const char* shaded_fragment = R"(
const int bodies_max = 8, taps = 16, few_taps = 5;
uniform int bodies;
uniform vec3 horizon;
uniform float sight_m, disc_rad;
uniform mat4 to_map[bodies_max];
uniform float reach_m[bodies_max];
uniform sampler2DArrayShadow depths;
in vec3 at_m, normal, colour;
in vec2 light;
out vec4 drawn;

// Share of the Sun that bodies let through; its disc blurs shadows with distance.
float past_bodies(vec3 n) {
  float share = 1.0;
  for (int k = 0; k < bodies; ++k) {
    float texel = 2.0 / float(textureSize(depths, 0).x);
    vec3 at = (to_map[k] * vec4(at_m + 1.5 * texel * reach_m[k] * n, 1.0)).xyz;
    float blur = 0.5 * (disc_rad * max(0.0, at.z) + texel);
    vec2 uv = 0.5 * at.xy + 0.5;
    bool is_clear = light.x <= 0.0 || any(lessThan(uv, vec2(-blur))) || any(greaterThan(uv, vec2(1.0 + blur)));
    float depth = clamp(0.5 * at.z + 0.5 - 0.001, 0.0, 0.9999), lit = 0.0;
    // The kernel's middle and four of its edge; the others where these do not agree, or may miss much. Loops that
    // end at once are skipped by a renderer in software, branches are not.
    float few = 0.0;
    for (int i = is_clear ? few_taps : 0; i < few_taps; ++i) {
      float a = 1.5708 * float(i);
      vec2 aside = i == 0 ? vec2(0.0) : 0.9 * vec2(cos(a), sin(a));
      few += texture(depths, vec4(uv + blur * aside, float(k), depth));
    }
    bool is_soft = blur > 2.0 * texel && !is_clear;
    bool is_edge = is_soft || (few > 0.01 && few < float(few_taps) - 0.01);
    for (int i = is_edge ? 0 : taps; i < taps; ++i) {
      float r = sqrt((float(i) + 0.5) / float(taps)), a = 2.39996 * float(i);
      lit += texture(depths, vec4(uv + blur * r * vec2(cos(a), sin(a)), float(k), depth));
    }
    lit = is_edge ? lit / float(taps) : few / float(few_taps);
    share *= is_clear ? 1.0 : lit;
  }
  return share;
}

void main() {
  vec3 bright = colour * (light.x * past_bodies(normalize(normal)) + light.y);
  drawn = vec4(toned(bright, length(at_m), horizon, sight_m), 1.0);
}
)";

// One triangle that covers the picture.
inline constexpr const char* sky_vertex = R"(#version 330 core
uniform vec3 ahead, right, above;  // as long as the picture is deep, wide and high
out vec3 way;
void main() {
  vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  way = ahead + at.x * right + at.y * above;
  gl_Position = vec4(at, 1.0, 1.0);
}
)";
inline constexpr const char* sky_fragment = R"(#version 330 core
uniform vec3 sun, up, horizon, zenith;
uniform float disc_rad;
in vec3 way;
out vec4 drawn;
void main() {
  vec3 n = normalize(way);
  vec3 sky = mix(horizon, zenith, sqrt(clamp(dot(n, up), 0.0, 1.0)));
  float from_sun = atan(length(cross(n, sun)), dot(n, sun)) / disc_rad;
  float glow = from_sun < 1.0 ? 1.0 : 0.5 * exp(-0.5 * (from_sun - 1.0));
  drawn = vec4(mix(sky, vec3(1.0, 1.0, 0.97), glow), 1.0);
}
)";

}  // namespace lsos::scene_shaders
