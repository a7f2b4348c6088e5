#version 330 core
// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec3 position;
layout(location = 2) in vec4 light_from_model[3];  // Rows, of this use of the mesh.
uniform vec4 section;  // Drawn is where dot(xyz, place) <= w.
void main() {
  vec4 p = vec4(position, 1.0);
  vec3 place = vec3(dot(light_from_model[0], p), dot(light_from_model[1], p), dot(light_from_model[2], p));
  gl_ClipDistance[0] = section.w - dot(section.xyz, place);
  gl_Position = vec4(place, 1.0);
}
