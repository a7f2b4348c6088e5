#version 330 core
// SPDX-License-Identifier: Apache-2.0
in float across;
uniform vec4 line_color;
uniform float width;
uniform float dash;              // Pixels of a dash and its gap; 0: unbroken.
layout(location = 0) out vec4 color;
layout(location = 1) out uint identity;
void main() {
  if (dash > 0.0 && mod(gl_FragCoord.x + gl_FragCoord.y, dash) > 0.56 * dash) discard;
  float cover = clamp(0.5 * width + 0.5 - abs(across), 0.0, 1.0);
  color = vec4(line_color.rgb, line_color.a * cover);
  identity = 0u;
}
