#version 330 core
// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 view_from_model[3];  // Rows, of this use of the mesh.
layout(location = 5) in vec3 albedo_of_use;
layout(location = 6) in uint id_of_use;
uniform mat4 clip_from_view;
uniform mat3 world_from_view;
#ifdef SHADOWED
uniform mat4 light_from_view;
uniform vec3 key_direction;     // World, towards the light.
uniform float shadow_shift;     // Metres.
#endif
#ifdef SECTIONED
uniform vec4 section;  // Drawn is where dot(xyz, view_position) <= w.
#endif
out vec3 world_normal;
out vec3 view_position;
out vec4 light_position;
flat out vec3 albedo;
flat out uint id;
void main() {
  vec4 p = vec4(position, 1.0);
  view_position = vec3(dot(view_from_model[0], p), dot(view_from_model[1], p), dot(view_from_model[2], p));
  vec3 turned = vec3(dot(view_from_model[0].xyz, normal), dot(view_from_model[1].xyz, normal),
                     dot(view_from_model[2].xyz, normal));
  world_normal = world_from_view * turned;
#ifdef SHADOWED
  // A face that the light only grazes would lie in its own shadow here and there: it looks from a little nearer to the
  // light, along its normal, the more the flatter the light.
  vec3 n = normalize(world_normal);
  float facing = dot(n, key_direction);
  vec3 aside = n * (facing < 0.0 ? -1.0 : 1.0) * shadow_shift * sqrt(max(0.0, 1.0 - facing * facing));
  light_position = light_from_view * vec4(view_position + aside * world_from_view, 1.0);
#else
  light_position = vec4(0.0);
#endif
#ifdef SECTIONED
  gl_ClipDistance[0] = section.w - dot(section.xyz, view_position);
#endif
  albedo = albedo_of_use;
  id = id_of_use;
  gl_Position = clip_from_view * vec4(view_position, 1.0);
}
