#version 330 core
// SPDX-License-Identifier: Apache-2.0
uniform vec3 fill_color;  // sRGB.
uniform float pixel_ratio;
uniform uint id;
layout(location = 0) out vec4 color;
layout(location = 1) out uint identity;
void main() {
  // Hatched as a cut is in a drawing: thin lines at 45 degrees.
  float along = mod(gl_FragCoord.x + gl_FragCoord.y, 10.0 * pixel_ratio);
  float line = clamp(0.75 * pixel_ratio + 0.5 - abs(along - 5.0 * pixel_ratio), 0.0, 1.0);
  color = vec4(fill_color * mix(0.85, 0.45, line), 1.0);
  identity = id;
}
