// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/frame.h"

#include <glm/gtc/matrix_transform.hpp>

namespace hapticell::app {
namespace {

double halton(int index, int base) {
  double result = 0.0;
  double share = 1.0;
  for (; index > 0; index /= base) {
    share /= base;
    result += share * (index % base);
  }
  return result;
}

}  // namespace

double floorCell(const Camera& camera) {
  double cell = 0.5;
  while (camera.distance > 22.0 * cell) cell *= 10.0;
  while (camera.distance < 0.6 * cell) cell /= 10.0;
  return cell;
}

dvec3 keyLightDirection_W() {
  return glm::normalize(dvec3(-0.55, -0.62, 1.15));
}

glm::dmat4 worldFromDisplay(const RenderItem& item, const dvec3& center_M) {
  glm::dmat4 result = glm::mat4_cast(item.X_WM.q);
  result[3] = glm::dvec4(item.X_WM * (item.scale * center_M), 1.0);
  for (int i = 0; i < 3; ++i) result[i] *= item.scale;
  return result;
}

glm::dvec2 samplePlace(int sample) {
  if (sample == 0) return glm::dvec2(0.0);
  return {halton(sample, 2) - 0.5, halton(sample, 3) - 0.5};
}

}  // namespace hapticell::app
