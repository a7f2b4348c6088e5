#version 330 core
// SPDX-License-Identifier: Apache-2.0
uniform mat4 clip_from_cap;
void main() {
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, gl_VertexID < 2 ? -1.0 : 1.0);
  gl_Position = clip_from_cap * vec4(corner, 0.0, 1.0);
}
