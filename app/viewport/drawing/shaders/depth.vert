#version 330 core
// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec3 position;
uniform mat4 clip_from_model;
uniform vec4 section;  // Drawn is where dot(xyz, position) <= w.
void main() {
  gl_ClipDistance[0] = section.w - dot(section.xyz, position);
  gl_Position = clip_from_model * vec4(position, 1.0);
}
