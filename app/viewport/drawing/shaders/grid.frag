#version 330 core
// SPDX-License-Identifier: Apache-2.0
in vec2 floor_place;
in vec4 light_position;
uniform vec2 origin;       // Of the world, in the floor's frame, less whole cells.
uniform float cell;        // Metres of a large cell; the small ones are a fifth.
uniform float fade_small;
uniform float fade_large;
uniform vec4 line_color;
uniform float shadow_strength;
uniform sampler2DShadow shadow_map;
uniform float turn;
layout(location = 0) out vec4 color;
layout(location = 1) out uint identity;

#ifdef SOFT
/// A place in a small disc, another for each pixel and sample, so that the few lights of a still picture leave no bands.
vec2 aside(float turn) {
  vec2 at = gl_FragCoord.xy;
  float angle = 6.2831853 * fract(52.9829189 * fract(dot(at, vec2(0.06711056, 0.00583715))) + 0.61803399 * turn);
  float out_of = fract(52.9829189 * fract(dot(at.yx + 37.0, vec2(0.06711056, 0.00583715))) + 0.75487767 * turn);
  return 2.0 / 2048.0 * sqrt(out_of) * vec2(cos(angle), sin(angle));
}
#endif

float lines(float size, float width) {
  vec2 place = (floor_place - origin) / size;
  vec2 rate = max(fwidth(place), vec2(1e-7));
  vec2 apart = abs(fract(place - 0.5) - 0.5) / rate;
  vec2 cover = clamp(0.5 * width + 0.5 - apart, 0.0, 1.0);
  // Lines closer than three pixels melt into grey, so fade them.
  cover *= clamp((0.33 - rate) / 0.2, 0.0, 1.0);
  return max(cover.x, cover.y);
}

void main() {
  float away = length(floor_place);
  if (away > fade_large) discard;
  float large = lines(cell, 1.0) * (1.0 - smoothstep(0.35 * fade_large, fade_large, away));
  float small = lines(0.2 * cell, 1.0) * 0.4 * (1.0 - smoothstep(0.35 * fade_small, fade_small, away));
  float alpha = line_color.a * max(large, small);
  vec3 shown = line_color.rgb;
#ifdef SHADOWED
  {
    vec3 p = light_position.xyz / light_position.w * 0.5 + 0.5;
    bool inside = all(greaterThan(p, vec3(0.0))) && all(lessThan(p, vec3(1.0)));
#ifdef SOFT
    p.xy += aside(turn);
#endif
    float lit = texture(shadow_map, p);
    float shade = inside ? shadow_strength * (1.0 - lit) * (1.0 - smoothstep(0.8 * fade_large, fade_large, away)) : 0.0;
    // Shadow below, line above it.
    float both = alpha + shade * (1.0 - alpha);
    shown = both > 0.0 ? shown * alpha / both : shown;
    alpha = both;
  }
#endif
  color = vec4(shown, alpha);
  identity = 0u;
}
