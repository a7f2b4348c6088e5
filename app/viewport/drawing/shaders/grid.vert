#version 330 core
// SPDX-License-Identifier: Apache-2.0
uniform mat4 clip_from_floor;   // The floor's frame: origin below the target, metres.
uniform mat4 light_from_floor;
uniform float reach;
out vec2 floor_place;
out vec4 light_position;
void main() {
  vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1) * reach;
  floor_place = corner;
  light_position = light_from_floor * vec4(corner, 0.0, 1.0);
  gl_Position = clip_from_floor * vec4(corner, 0.0, 1.0);
}
