#version 330 core
// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec3 normal_a;
layout(location = 3) in vec3 normal_b;
uniform mat4 clip_from_model;
uniform vec3 eye_in_model;       // Of the eye, or the direction to it in the orthographic view.
uniform bool perspective;
uniform float crease_cosine;
uniform vec2 pixels;             // Size of the picture.
uniform float width;             // Pixels.
uniform float nearer;            // How far the line stands in front of its face, in parts of its distance (or of NDC depth).
uniform float depth_offset;      // clip_from_view[3][2].
uniform vec4 section;            // Drawn is where dot(xyz, position) <= w.
out float across;
const float kNear = 1e-5;
void main() {
  vec3 to_eye = perspective ? eye_in_model - from : eye_in_model;
  float side_a = dot(normal_a, to_eye);
  float side_b = dot(normal_b, to_eye);
  bool crease = dot(normal_a, normal_b) < crease_cosine;
  bool outline = side_a * side_b < 0.0;
  vec4 p = clip_from_model * vec4(from, 1.0);
  vec4 q = clip_from_model * vec4(to, 1.0);
  if (!(crease || outline) || (p.w < kNear && q.w < kNear)) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    gl_ClipDistance[0] = 1.0;
    across = 0.0;
    return;
  }
  // Cut off what lies behind the eye before dividing.
  vec3 a = from, b = to;
  if (p.w < kNear) {
    a = mix(to, from, (q.w - kNear) / (q.w - p.w));
    p = clip_from_model * vec4(a, 1.0);
  }
  if (q.w < kNear) {
    b = mix(a, to, (p.w - kNear) / (p.w - q.w));
    q = clip_from_model * vec4(b, 1.0);
  }
  gl_ClipDistance[0] = section.w - dot(section.xyz, gl_VertexID < 2 ? a : b);
  vec2 direction = (q.xy / q.w - p.xy / p.w) * pixels;
  float length = length(direction);
  direction = length > 1e-4 ? direction / length : vec2(1.0, 0.0);
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec4 corner = gl_VertexID < 2 ? p : q;
  float half_width = 0.5 * width + 0.5;
  corner.xy += side * vec2(-direction.y, direction.x) * half_width * 2.0 / pixels * corner.w;
  if (perspective) {
    // The same place in the picture, a little nearer to the eye.
    float s = 1.0 - nearer;
    corner = vec4(s * corner.xy, s * (corner.z - depth_offset) + depth_offset, s * corner.w);
  } else {
    corner.z -= nearer;
  }
  across = side * half_width;
  gl_Position = corner;
}
