#version 330 core
// SPDX-License-Identifier: Apache-2.0
in vec2 place;
uniform vec3 top;
uniform vec3 bottom;
layout(location = 0) out vec4 color;
layout(location = 1) out uint identity;
void main() {
  // Half a step of noise, or the gradient shows bands.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  color = vec4(mix(bottom, top, place.y) + noise / 255.0, 1.0);
  identity = 0u;
}
