#version 330 core
// SPDX-License-Identifier: Apache-2.0
in vec2 place;
uniform sampler2D picture;
out vec4 color;
void main() { color = vec4(texture(picture, place).rgb, 1.0); }
