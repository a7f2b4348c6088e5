// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/drawing/cap_pass.h"

#include <algorithm>
#include <cmath>

namespace hapticell::app {
namespace {

/// A square in the plane that covers everything in sight of the scene: centre and both half sides as columns.
glm::dmat4 worldFromCap(const SectionPlane& plane, const geometry::Bounds& bounds_W) {
  const dvec3 n = plane.nhat_W;
  const dvec3 u = glm::normalize(glm::cross(n, std::abs(n.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(1, 0, 0)));
  const double half = bounds_W.radius() * 1.01;
  const dvec3 middle = bounds_W.center() + (plane.offset - glm::dot(n, bounds_W.center())) * n;
  return {glm::dvec4(half * u, 0.0), glm::dvec4(half * glm::cross(n, u), 0.0), glm::dvec4(n, 0.0),
          glm::dvec4(middle, 1.0)};
}

}  // namespace

CapPass::CapPass(Gl& gl) : gl_(gl), counter_(loadProgram("depth", "depth")), cap_(loadProgram("cap", "cap")) {
  gl_.glGenVertexArrays(1, &vertex_array_);
}
CapPass::~CapPass() {
  gl_.glDeleteVertexArrays(1, &vertex_array_);
}

bool CapPass::cuts(const DrawContext& context, const RenderItem& item) const {
  if (!item.mesh || item.unseen || item.over_scene || item.ghost != Ghost::kNone) return false;
  const geometry::Bounds box = geometry::transformed(item.X_WM, item.bounds_M);
  if (isOutside(context.view.band_from_world, box.center(), box.radius())) return false;
  const dvec3 n = context.frame.section->nhat_W;
  const double middle = glm::dot(n, box.center()) - context.frame.section->offset;
  return std::abs(middle) <= 0.5 * glm::dot(glm::abs(n), box.size());
}

void CapPass::count(const Frame& frame, const FrameView& view, const RenderItem& item, GpuMesh& mesh) {
  const glm::dmat4 world_from_model = worldFromDisplay(item, mesh.center());
  counter_->bind();
  setMatrix(gl_, *counter_, "clip_from_model", view.clip_from_world * world_from_model);
  const glm::vec4 section = sectionInModel(frame, item, world_from_model);
  counter_->setUniformValue("section", section.x, section.y, section.z, section.w);
  gl_.glEnable(GL_CLIP_DISTANCE0);
  gl_.glDisable(GL_DEPTH_TEST);
  gl_.glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl_.glStencilFunc(GL_ALWAYS, 0, 0xff);
  gl_.glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
  gl_.glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
  mesh.drawFaces();
  gl_.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.glEnable(GL_DEPTH_TEST);
  gl_.glDisable(GL_CLIP_DISTANCE0);
}

void CapPass::fill(const Frame& frame, const FrameView& view, const RenderItem& item, std::uint32_t id) {
  cap_->bind();
  setMatrix(gl_, *cap_, "clip_from_cap", view.clip_from_world * worldFromCap(*frame.section, frame.bounds_W));
  const bool contact = (item.state & kContact) != 0;
  const fvec3 color = contact ? frame.colors.contact : fvec3(item.color[0], item.color[1], item.color[2]);
  cap_->setUniformValue("fill_color", color.x, color.y, color.z);
  cap_->setUniformValue("pixel_ratio", static_cast<float>(frame.pixel_ratio));
  gl_.glUniform1ui(cap_->uniformLocation("id"), id | (item.state | kCap) << 24);
  gl_.glStencilFunc(GL_NOTEQUAL, 0, 0xff);
  gl_.glStencilOp(GL_KEEP, GL_ZERO, GL_ZERO);  // Ready for the next part.
  gl_.glBindVertexArray(vertex_array_);
  gl_.glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void CapPass::draw(const DrawContext& context) {
  const Frame& frame = context.frame;
  if (!frame.section || !counter_ || !cap_ || frame.detail == DetailLevel::kCoarse) return;
  gl_.glClearStencil(0);
  gl_.glClear(GL_STENCIL_BUFFER_BIT);
  gl_.glEnable(GL_STENCIL_TEST);
  gl_.glEnable(GL_DEPTH_TEST);
  gl_.glDepthMask(GL_TRUE);
  gl_.glDisable(GL_BLEND);
  for (std::uint32_t i = 0; i < frame.items.size(); ++i) {
    const RenderItem& item = frame.items[i];
    if (!cuts(context, item)) continue;
    GpuMesh* mesh = context.meshes.of(item);
    if (!mesh || !mesh->closed()) continue;
    // Not to be cut: the stencil counts all faces of a part before its cap is filled.
    context.share.once(mesh->triangles(), [&] {
      count(frame, context.view, item, *mesh);
      fill(frame, context.view, item, i + 1);
    });
  }
  gl_.glDisable(GL_STENCIL_TEST);
}

}  // namespace hapticell::app
