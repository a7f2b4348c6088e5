// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/shadow_pass.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace hapticell::app {
namespace {

constexpr int kMapSize = 2048;
constexpr double kLightRadius = 0.035;  // Of the light as seen from the scene, rad.

dvec3 lightDirection(int sample) {
  const dvec3 middle = keyLightDirection_W();
  if (sample == 0) return middle;
  const dvec3 x = glm::normalize(glm::cross(middle, dvec3(0, 0, 1)));
  const dvec3 y = glm::cross(middle, x);
  const double radius = kLightRadius * std::sqrt(samplePlace(sample).x + 0.5);
  const double angle = 6.283185307 * samplePlace(sample).y;
  return glm::normalize(middle + radius * (std::cos(angle) * x + std::sin(angle) * y));
}

}  // namespace

ShadowPass::ShadowPass(Gl& gl)
    : gl_(gl), program_(loadProgram("shadow", "depth")), target_(gl, {{}, true, false, true, false}), uses_(gl) {}

void ShadowPass::draw(const Frame& frame, GpuMeshCache& meshes) {
  ready_ = false;
  if (!program_ || frame.bounds_W.isEmpty()) return;
  target_.resize(kMapSize, kMapSize);
  // What is shadowed is what is looked at: a huge cell must not make the map coarse.
  const double scene = frame.bounds_W.radius();
  const double radius = std::min(scene, std::max(4.0, 2.5 * frame.camera.distance)) * 1.02 + 0.01;
  const dvec3 middle = radius < scene ? frame.camera.target_W : frame.bounds_W.center();
  const dvec3 light = lightDirection(frame.sample);
  const glm::dmat4 view = glm::lookAt(middle + light, middle, dvec3(0, 1, 0));
  light_from_world_ = glm::ortho(-radius, radius, -radius, radius, -scene - radius, scene + radius) * view;
  texel_ = 2.0 * radius / kMapSize;
  target_.bind();
  gl_.glClear(GL_DEPTH_BUFFER_BIT);
  gl_.glEnable(GL_DEPTH_TEST);
  gl_.glEnable(GL_POLYGON_OFFSET_FILL);
  gl_.glPolygonOffset(2.5f, 6.0f);
  if (frame.section) gl_.glEnable(GL_CLIP_DISTANCE0);
  program_->bind();
  const std::vector<ItemBatch> batches = shadowBatches(frame, texel_, meshes);
  std::vector<ItemInstance> uses;
  for (const ItemBatch& batch : batches)
    for (const std::uint32_t item : batch.items)
      setRows(uses.emplace_back(), light_from_world_ * worldFromDisplay(frame.items[item], batch.mesh->center()));
  uses_.fill(uses);
  const glm::vec4 section = sectionIn(frame, light_from_world_);
  program_->setUniformValue("section", section.x, section.y, section.z, section.w);
  std::size_t first = 0;
  for (const ItemBatch& batch : batches) {
    batch.mesh->drawUses(batch.step, uses_, first, batch.items.size());
    first += batch.items.size();
  }
  gl_.glDisable(GL_CLIP_DISTANCE0);
  gl_.glDisable(GL_POLYGON_OFFSET_FILL);
  ready_ = true;
}

}  // namespace hapticell::app
