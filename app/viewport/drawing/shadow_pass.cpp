// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/drawing/shadow_pass.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace hapticell::app {
namespace {

// Texels a side: 5 mm in a cell of 10 m. Half: steps at rims of shadows; twice: four times the time without a card.
constexpr int kMapSize = 2048;
// Of the light as seen from the scene, rad: 2 degrees, our choice (the sun has 0.26). Half, twice: harder or softer
// shadows.
constexpr double kLightRadius = 0.035;
const RenderTarget::Format kFormat{{}, true, false, true, false};

dvec3 lightDirection(int sample) {
  const dvec3 middle = keyLightDirection_W();
  if (sample == 0) return middle;
  const dvec3 x = glm::normalize(glm::cross(middle, dvec3(0, 0, 1)));
  const dvec3 y = glm::cross(middle, x);
  const double radius = kLightRadius * std::sqrt(samplePlace(sample).x + 0.5);
  const double angle = 2.0 * std::numbers::pi * samplePlace(sample).y;
  return glm::normalize(middle + radius * (std::cos(angle) * x + std::sin(angle) * y));
}

}  // namespace

ShadowPass::ShadowPass(Gl& gl)
    : gl_(gl),
      program_(loadProgram("shadow", "depth")),
      targets_{RenderTarget(gl, kFormat), RenderTarget(gl, kFormat)},
      uses_(gl) {}

ShadowPass::View ShadowPass::viewOf(const Frame& frame) {
  // What is shadowed is what is looked at: a huge cell must not make the map coarse.
  const double scene = frame.bounds_W.radius();
  const double radius = std::min(scene, std::max(4.0, 2.5 * frame.camera.distance)) * 1.02 + 0.01;
  const dvec3 middle = radius < scene ? frame.camera.target_W : frame.bounds_W.center();
  const dvec3 light = lightDirection(frame.sample);
  const glm::dmat4 view = glm::lookAt(middle + light, middle, dvec3(0, 1, 0));
  return {glm::ortho(-radius, radius, -radius, radius, -scene - radius, scene + radius) * view,
          2.0 * radius / kMapSize};
}

void ShadowPass::begin(const Frame& frame, GpuMeshCache& meshes) {
  const View view = viewOf(frame);
  std::vector<ItemBatch> batches = shadowBatches(frame, view.texel, meshes);
  std::vector<ItemInstance> uses;
  for (const ItemBatch& batch : batches)
    for (const std::uint32_t item : batch.items)
      setRows(uses.emplace_back(), view.light_from_world * worldFromDisplay(frame.items[item], batch.mesh->center()));
  uses_.fill(uses);
  RenderTarget& target = targets_[1 - shown_target_];
  target.resize(kMapSize, kMapSize);
  target.bind();
  gl_.glDepthMask(GL_TRUE);
  gl_.glClear(GL_DEPTH_BUFFER_BIT);
  begun_.emplace(Begun{view, std::move(batches)});
}

void ShadowPass::prepare(const Frame& frame) {
  targets_[1 - shown_target_].bind();
  gl_.glEnable(GL_DEPTH_TEST);
  gl_.glDepthMask(GL_TRUE);
  gl_.glEnable(GL_POLYGON_OFFSET_FILL);
  gl_.glPolygonOffset(2.5f, 6.0f);
  if (frame.section) gl_.glEnable(GL_CLIP_DISTANCE0);
  program_->bind();
  const glm::vec4 section = sectionIn(frame, begun_->view.light_from_world);
  program_->setUniformValue("section", section.x, section.y, section.z, section.w);
}

void ShadowPass::endDrawing() {
  gl_.glDisable(GL_CLIP_DISTANCE0);
  gl_.glDisable(GL_POLYGON_OFFSET_FILL);
}

void ShadowPass::show() {
  shown_target_ = 1 - shown_target_;
  shown_ = begun_->view;
  begun_.reset();
  ready_ = true;
}

bool ShadowPass::canDraw(const Frame& frame) {
  if (program_ && !frame.bounds_W.isEmpty()) return true;
  begun_.reset();
  ready_ = false;
  return false;
}

bool ShadowPass::draw(const Frame& frame, GpuMeshCache& meshes, DrawShare& share) {
  if (!canDraw(frame)) return true;
  if (!begun_) begin(frame, meshes);
  prepare(frame);
  std::size_t before = 0;
  for (const ItemBatch& batch : begun_->batches) {
    share.offer({batch.mesh->trianglesOf(batch.step), batch.items.size()},
                [&](const DrawPart& part) { batch.mesh->drawUses(batch.step, uses_, before, part); });
    before += batch.items.size();
  }
  endDrawing();
  if (share.isWhole()) show();
  return share.isWhole();
}

}  // namespace hapticell::app
