#version 330 core
// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 clip_from_model;
uniform mat4 view_from_model;
uniform mat4 light_from_model;
uniform mat3 world_from_model;
#ifdef SECTIONED
uniform vec4 section;  // Drawn is where dot(xyz, position) <= w.
#endif
out vec3 world_normal;
out vec3 view_position;
out vec4 light_position;
void main() {
  world_normal = world_from_model * normal;
  view_position = (view_from_model * vec4(position, 1.0)).xyz;
  light_position = light_from_model * vec4(position, 1.0);
#ifdef SECTIONED
  gl_ClipDistance[0] = section.w - dot(section.xyz, position);
#endif
  gl_Position = clip_from_model * vec4(position, 1.0);
}
