#version 330 core
// SPDX-License-Identifier: Apache-2.0
// Puts the picture together: faces and lines, occlusion (OCCLUDED), silhouettes (SILHOUETTES), and the outlines of
// states (STATES).
in vec2 place;
uniform sampler2D color_map;
uniform usampler2D id_map;
uniform sampler2D openness_map;
uniform vec3 silhouette_color;
uniform vec3 selected_color, hovered_color;
uniform vec3 near_colors[8], contact_colors[8];  // By pair set; the first is the theme's.
uniform float pixel_ratio;
uniform float share;            // Of this sample in the mean.
layout(location = 0) out vec4 color;

const uint kSelected = 1u, kHovered = 2u, kNearMiss = 4u, kContact = 8u;
uint stateOf(uint id) { return id >> 24; }
/// The first of eight neighbours that has the mark; 0 where none does.
uint marked(uint s[8], uint mark) {
  for (int i = 0; i < 8; ++i)
    if ((s[i] & mark) != 0u) return s[i];
  return 0u;
}
uint itemOf(uint id) { return id & 0x10ffffffu; }  // A cut face and the faces about it are two.

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(id_map, 0) - 1;
  vec3 shown = texelFetch(color_map, here, 0).rgb;
  uint own = texelFetch(id_map, here, 0).r;
#ifdef OCCLUDED
  float open = own != 0u ? texture(openness_map, place).r : 1.0;
  shown *= mix(0.30, 1.0, open);
#endif
#ifdef SILHOUETTES
  {
    uint right = itemOf(texelFetch(id_map, min(here + ivec2(1, 0), last), 0).r);
    uint above = itemOf(texelFetch(id_map, min(here + ivec2(0, 1), last), 0).r);
    uint item = itemOf(own);
    // What is thinner than a few pixels (a fence, a cable) would be all line: its own colour shows through.
    int t = int(4.0 * pixel_ratio + 0.5);
    float strength = 0.0;
    if (item != right) {
      uint beyond = itemOf(texelFetch(id_map, min(here + ivec2(t, 0), last), 0).r);
      uint before = itemOf(texelFetch(id_map, max(here - ivec2(t - 1, 0), ivec2(0)), 0).r);
      strength = beyond == item || before == right ? 0.22 : 0.72;
    }
    if (item != above) {
      uint beyond = itemOf(texelFetch(id_map, min(here + ivec2(0, t), last), 0).r);
      uint before = itemOf(texelFetch(id_map, max(here - ivec2(0, t - 1), ivec2(0)), 0).r);
      strength = max(strength, beyond == item || before == above ? 0.22 : 0.72);
    }
    shown = mix(shown, silhouette_color, strength);
  }
#endif
#ifdef STATES
  {
    int r = int(2.0 * pixel_ratio + 0.5);
    int d = max(1, int(1.5 * pixel_ratio));
    uint east = stateOf(texelFetch(id_map, clamp(here + ivec2(r, 0), ivec2(0), last), 0).r);
    uint west = stateOf(texelFetch(id_map, clamp(here - ivec2(r, 0), ivec2(0), last), 0).r);
    uint north = stateOf(texelFetch(id_map, clamp(here + ivec2(0, r), ivec2(0), last), 0).r);
    uint south = stateOf(texelFetch(id_map, clamp(here - ivec2(0, r), ivec2(0), last), 0).r);
    uint ne = stateOf(texelFetch(id_map, clamp(here + ivec2(d, d), ivec2(0), last), 0).r);
    uint nw = stateOf(texelFetch(id_map, clamp(here + ivec2(-d, d), ivec2(0), last), 0).r);
    uint se = stateOf(texelFetch(id_map, clamp(here + ivec2(d, -d), ivec2(0), last), 0).r);
    uint sw = stateOf(texelFetch(id_map, clamp(here + ivec2(-d, -d), ivec2(0), last), 0).r);
    uint near_by = (east | west | north | south | ne | nw | se | sw) & ~stateOf(own);
    if ((near_by & kHovered) != 0u) shown = mix(shown, hovered_color, 0.8);
    if ((near_by & kSelected) != 0u) shown = selected_color;
    uint around[8] = uint[8](east, west, north, south, ne, nw, se, sw);
    if ((near_by & kNearMiss) != 0u) {
      vec3 near_color = near_colors[marked(around, kNearMiss) >> 5];
      // Dashes run along the border: along y where it stands upright, else along x.
      float gx = float((east >> 2) & 1u) - float((west >> 2) & 1u);
      float gy = float((north >> 2) & 1u) - float((south >> 2) & 1u);
      float along = abs(gx) > abs(gy) ? gl_FragCoord.y : gl_FragCoord.x;
      shown = mod(along, 9.0 * pixel_ratio) < 5.5 * pixel_ratio ? near_color : mix(shown, vec3(0.06), 0.55);
    }
    if ((near_by & kContact) != 0u) shown = contact_colors[marked(around, kContact) >> 5];
  }
#endif
  color = vec4(shown, share);
}
