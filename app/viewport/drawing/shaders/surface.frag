#version 330 core
// SPDX-License-Identifier: Apache-2.0
in vec3 world_normal;
in vec3 view_position;
in vec4 light_position;
flat in vec3 albedo;            // Linear, with a gamma of 2: a square root is cheap where there is no graphics card.
uniform vec3 eye_direction;     // World; from the scene to the eye, for the orthographic view.
uniform mat3 world_from_view;
uniform bool perspective;
uniform vec3 key_direction;     // World, towards the light.
uniform sampler2DShadow shadow_map;
flat in uint id;
uniform float turn;
uniform vec3 hatch_color;       // sRGB; of ghosts all is in it.
uniform float pixel_ratio;
uniform float pattern;          // Of a score: 0 plain, 1 hatched, 2 cross-hatched.
layout(location = 0) out vec4 color;
layout(location = 1) out uint identity;

const vec3 kSky = vec3(1.0);
const vec3 kGround = vec3(0.144, 0.174, 0.216);  // #6A7480, linear.

#ifdef SOFT
/// A place in a small disc, another for each pixel and sample, so that the few lights of a still picture leave no bands.
vec2 aside(float turn) {
  vec2 at = gl_FragCoord.xy;
  float angle = 6.2831853 * fract(52.9829189 * fract(dot(at, vec2(0.06711056, 0.00583715))) + 0.61803399 * turn);
  float out_of = fract(52.9829189 * fract(dot(at.yx + 37.0, vec2(0.06711056, 0.00583715))) + 0.75487767 * turn);
  return 2.0 / 2048.0 * sqrt(out_of) * vec2(cos(angle), sin(angle));
}
#endif

float lit() {
#ifdef SHADOWED
  vec3 p = light_position.xyz / light_position.w * 0.5 + 0.5;
#ifdef SOFT
  p.xy += aside(turn);
#endif
  return texture(shadow_map, p);  // Borders are softened by the samples of a still picture.
#else
  return 1.0;
#endif
}

void main() {
#ifdef GHOST
  // A screen door needs no sorting: every other pixel is left open.
  if (mod(floor(gl_FragCoord.x / max(pixel_ratio, 1.0)) + floor(gl_FragCoord.y / max(pixel_ratio, 1.0)), 2.0) < 0.5) discard;
#endif
  vec3 to_eye = perspective ? normalize(world_from_view * -view_position) : eye_direction;
  vec3 n = normalize(world_normal);
  if (dot(n, to_eye) < 0.0) n = -n;
  vec3 light = 1.55 * mix(kGround, kSky, 0.5 + 0.5 * n.z);
  float key = max(dot(n, key_direction), 0.0);
  key *= lit();
  light += 1.55 * key;
  light += 0.55 * max(dot(n, to_eye), 0.0);
  vec3 linear = albedo * light * 0.31831;
  vec3 shown = sqrt(linear);
  if (pattern > 0.5) {
    float period = 7.0 * pixel_ratio;
    float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, period) / period;
    float cross = pattern > 1.5 ? mod(gl_FragCoord.x - gl_FragCoord.y, period) / period : 1.0;
    if (min(stripe, cross) < 0.24) shown *= 0.42;
  }
#ifdef HATCHED
  {
    float period = 8.0 * pixel_ratio;
    float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, period) / period;
    float shade = dot(shown, vec3(0.3, 0.55, 0.15));
    shown = stripe < 0.34 ? hatch_color : hatch_color * (0.35 + 0.45 * shade);
  }
#endif
#ifdef GHOST
  shown = hatch_color * (0.45 + 0.55 * dot(shown, vec3(0.3, 0.55, 0.15)));
#endif
  color = vec4(shown, 1.0);
  identity = id;
}
