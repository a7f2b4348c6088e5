// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/drawing/frame.h"

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

glm::vec4 sectionInModel(const Frame& frame, const RenderItem& item, const glm::dmat4& world_from_model) {
  if (!frame.section || item.over_scene) return {0.0f, 0.0f, 0.0f, 1.0f};
  const dvec3 n = glm::transpose(glm::dmat3(world_from_model)) * frame.section->nhat_W;
  return glm::vec4(glm::dvec4(n, frame.section->offset - glm::dot(frame.section->nhat_W, dvec3(world_from_model[3]))));
}

glm::dvec2 samplePlace(int sample) {
  if (sample == 0) return glm::dvec2(0.0);
  return {halton(sample, 2) - 0.5, halton(sample, 3) - 0.5};
}

}  // namespace hapticell::app
