#version 330 core
// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion from the depth buffer: points in the half sphere over a pixel that lie behind what is seen there.
in vec2 place;
uniform sampler2D depth_map;
uniform mat4 clip_from_view;
uniform mat4 view_from_clip;
uniform float radius;           // Metres.
uniform float turn;             // Another pattern each sample of a still picture.
layout(location = 0) out vec4 openness;
const int kSamples = 10;

vec3 viewAt(vec2 at, float depth) {
  vec4 p = view_from_clip * vec4(2.0 * at - 1.0, 2.0 * depth - 1.0, 1.0);
  return p.xyz / p.w;
}
float depthAt(vec2 at) { return textureLod(depth_map, at, 0.0).r; }

vec3 normalAt(vec2 at, vec3 p, vec2 texel) {
  vec3 right = viewAt(at + vec2(texel.x, 0.0), depthAt(at + vec2(texel.x, 0.0))) - p;
  vec3 left = p - viewAt(at - vec2(texel.x, 0.0), depthAt(at - vec2(texel.x, 0.0)));
  vec3 up = viewAt(at + vec2(0.0, texel.y), depthAt(at + vec2(0.0, texel.y))) - p;
  vec3 down = p - viewAt(at - vec2(0.0, texel.y), depthAt(at - vec2(0.0, texel.y)));
  // The nearer neighbour lies on the same face.
  vec3 x = abs(right.z) < abs(left.z) ? right : left;
  vec3 y = abs(up.z) < abs(down.z) ? up : down;
  return normalize(cross(x, y));
}

void main() {
  // At half the size a pixel's middle lies where four texels meet, and rounding would choose another one in some columns
  // and rows: lines over the whole picture. The middle of one of them it is.
  vec2 texel = 1.0 / vec2(textureSize(depth_map, 0));
  vec2 here = (floor(place / texel - 0.25) + 0.5) * texel;
  float depth = depthAt(here);
  if (depth >= 1.0) {
    openness = vec4(1.0);
    return;
  }
  vec3 p = viewAt(here, depth);
  vec3 n = normalAt(here, p, texel);
  p += 0.004 * radius * n;
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy + 5.588238 * turn, vec2(0.06711056, 0.00583715))));
  float closed = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    // Golden-angle spiral over the sphere, folded to the side of the normal; nearer points count more.
    float share = (float(i) + 0.5) / float(kSamples);
    float angle = 2.399963 * float(i) + 6.2831853 * noise;
    float z = 1.0 - 2.0 * share;
    float around = sqrt(1.0 - z * z);
    vec3 d = vec3(around * cos(angle), around * sin(angle), z);
    if (dot(d, n) < 0.0) d = -d;
    float length = radius * mix(0.08, 1.0, fract(share * 7.0 + noise) * fract(share * 7.0 + noise));
    vec3 q = p + length * d;
    vec4 clip = clip_from_view * vec4(q, 1.0);
    vec2 at = clip.xy / clip.w * 0.5 + 0.5;
    float seen = viewAt(at, depthAt(at)).z;
    float behind = seen - q.z;
    if (behind > 0.002 * radius) closed += smoothstep(0.0, 1.0, radius / max(abs(p.z - seen), 1e-5)) * dot(d, n) * 2.0;
  }
  openness = vec4(clamp(1.0 - closed / float(kSamples), 0.0, 1.0));
}
