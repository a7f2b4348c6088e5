// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/scene_renderer.h"

#include <algorithm>

#include "app/viewport/surface_pass.h"

namespace hapticell::app {
namespace {

constexpr double kOcclusionRadius = 0.16;  // Metres.

void setColor(QOpenGLShaderProgram& program, const char* name, const fvec3& color) {
  program.setUniformValue(name, color.x, color.y, color.z);
}

}  // namespace

struct SceneRenderer::Passes {
  explicit Passes(Gl& gl)
      : meshes(gl),
        shadow(gl),
        surface(gl),
        edge(gl),
        floor(gl),
        triangle(gl),
        background(loadProgram("screen", "background")),
        occlusion(loadProgram("screen", "occlusion")),
        composite(loadProgram("screen", "composite")),
        present(loadProgram("screen", "present")),
        scene(gl, {{GL_RGBA8, GL_R32UI}, true, false, false}),
        openness(gl, {{GL_R8}, false, false, true}),
        mean(gl, {{GL_RGBA16F}, false, false, true}) {}
  GpuMeshCache meshes;
  ShadowPass shadow;
  SurfacePass surface;
  EdgePass edge;
  FloorPass floor;
  ScreenTriangle triangle;
  std::unique_ptr<QOpenGLShaderProgram> background, occlusion, composite, present;
  RenderTarget scene, openness, mean;
  FrameView view;
  bool complete() const { return background && occlusion && composite && present; }
};

SceneRenderer::SceneRenderer(Gl& gl) : gl_(gl), passes_(std::make_unique<Passes>(gl)) {}
SceneRenderer::~SceneRenderer() = default;

void SceneRenderer::drawScene(const Frame& frame) {
  Passes& p = *passes_;
  const bool shadows = frame.detail <= DetailLevel::kNoOcclusion;
  // Without occlusion the shadows of the last full picture stay: the cell seldom changes, the eye does.
  if (frame.detail == DetailLevel::kFull || (shadows && !p.shadow.ready())) p.shadow.draw(frame, p.meshes);
  p.view = viewOf(frame);
  p.scene.bind();
  gl_.glDisable(GL_BLEND);
  gl_.glDisable(GL_CULL_FACE);
  const GLfloat far_away = 1.0f;
  gl_.glDepthMask(GL_TRUE);
  gl_.glClearBufferfv(GL_DEPTH, 0, &far_away);
  gl_.glDisable(GL_DEPTH_TEST);
  p.background->bind();
  setColor(*p.background, "top", frame.colors.background_top);
  setColor(*p.background, "bottom", frame.colors.background_bottom);
  p.triangle.draw();
  const ShadowPass* shadow = shadows ? &p.shadow : nullptr;
  p.surface.draw(frame, p.view, shadow, p.meshes);
  p.floor.draw(frame, p.view, shadow);
  if (frame.edges && frame.detail < DetailLevel::kNoEdges)
    p.edge.draw(frame, p.view, frame.detail != DetailLevel::kFull, p.meshes);
  gl_.glDisable(GL_DEPTH_TEST);
}

void SceneRenderer::composite(const Frame& frame) {
  Passes& p = *passes_;
  const bool occluded = frame.detail == DetailLevel::kFull;
  if (occluded) {
    p.openness.resize((frame.width + 1) / 2, (frame.height + 1) / 2);
    p.openness.bind();
    p.occlusion->bind();
    bindTexture(gl_, *p.occlusion, "depth_map", 0, p.scene.depth());
    setMatrix(gl_, *p.occlusion, "clip_from_view", p.view.clip_from_view);
    setMatrix(gl_, *p.occlusion, "view_from_clip", glm::inverse(p.view.clip_from_view));
    p.occlusion->setUniformValue("radius", static_cast<float>(kOcclusionRadius));
    p.occlusion->setUniformValue("turn", static_cast<float>(frame.sample));
    p.triangle.draw();
  }
  p.mean.bind();
  p.composite->bind();
  bindTexture(gl_, *p.composite, "color_map", 0, p.scene.color(0));
  bindTexture(gl_, *p.composite, "id_map", 1, p.scene.color(1));
  bindTexture(gl_, *p.composite, "openness_map", 2, occluded ? p.openness.color(0) : p.scene.color(0));
  p.composite->setUniformValue("occluded", occluded);
  p.composite->setUniformValue("silhouettes", frame.edges && frame.detail < DetailLevel::kNoEdges);
  p.composite->setUniformValue(
      "states", std::any_of(frame.items.begin(), frame.items.end(), [](const RenderItem& i) { return i.state != 0; }));
  const glm::vec4& line = frame.colors.crease;
  p.composite->setUniformValue("silhouette_color", line.x, line.y, line.z);
  setColor(*p.composite, "selected_color", frame.colors.selected);
  setColor(*p.composite, "hovered_color", frame.colors.hovered);
  setColor(*p.composite, "near_color", frame.colors.near_miss);
  setColor(*p.composite, "contact_color", frame.colors.contact);
  const double ratio = frame.detail >= DetailLevel::kHalfSize ? 0.5 * frame.pixel_ratio : frame.pixel_ratio;
  p.composite->setUniformValue("pixel_ratio", static_cast<float>(ratio));
  p.composite->setUniformValue("share", 1.0f / static_cast<float>(frame.sample + 1));
  gl_.glEnable(GL_BLEND);
  gl_.glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  p.triangle.draw();
  gl_.glDisable(GL_BLEND);
}

void SceneRenderer::render(const Frame& wanted, GLuint framebuffer) {
  Passes& p = *passes_;
  if (!p.complete()) return;
  Frame frame = wanted;
  if (frame.detail >= DetailLevel::kHalfSize) {
    frame.width = std::max(1, frame.width / 2);
    frame.height = std::max(1, frame.height / 2);
  }
  p.scene.resize(frame.width, frame.height);
  if (p.mean.resize(frame.width, frame.height)) frame.sample = 0;
  drawScene(frame);
  composite(frame);
  if (frame.sample == 0) p.meshes.collect();
  present(wanted.width, wanted.height, framebuffer);
  last_ = std::move(frame);
}

void SceneRenderer::present(int width, int height, GLuint framebuffer) {
  Passes& p = *passes_;
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_.glViewport(0, 0, width, height);
  gl_.glDisable(GL_DEPTH_TEST);
  gl_.glDisable(GL_BLEND);
  if (!p.complete() || p.mean.width() == 0) {
    gl_.glClearColor(0.13f, 0.15f, 0.18f, 1.0f);
    gl_.glClear(GL_COLOR_BUFFER_BIT);
    return;
  }
  p.present->bind();
  bindTexture(gl_, *p.present, "picture", 0, p.mean.color(0));
  p.triangle.draw();
  p.present->release();
  gl_.glActiveTexture(GL_TEXTURE0);
}

std::optional<PickedPoint> SceneRenderer::pick(int x, int y) {
  Passes& p = *passes_;
  if (p.scene.width() == 0 || last_.width != p.scene.width()) return std::nullopt;
  if (last_.detail >= DetailLevel::kHalfSize) x /= 2, y /= 2;
  if (x < 0 || y < 0 || x >= last_.width || y >= last_.height) return std::nullopt;
  const int row = last_.height - 1 - y;
  GLuint id = 0;
  GLfloat depth = 1.0f;
  gl_.glBindFramebuffer(GL_READ_FRAMEBUFFER, p.scene.framebuffer());
  gl_.glReadBuffer(GL_COLOR_ATTACHMENT1);
  gl_.glReadPixels(x, row, 1, 1, GL_RED_INTEGER, GL_UNSIGNED_INT, &id);
  gl_.glReadPixels(x, row, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  gl_.glReadBuffer(GL_COLOR_ATTACHMENT0);
  id &= 0xffffffu;
  if (id == 0 || id > last_.items.size()) return std::nullopt;
  const glm::dvec4 clip(2.0 * (x + 0.5) / last_.width - 1.0, 2.0 * (row + 0.5) / last_.height - 1.0, 2.0 * depth - 1.0, 1.0);
  const glm::dvec4 world = glm::inverse(p.view.clip_from_world) * clip;
  return PickedPoint{id - 1, dvec3(world) / world.w};
}

}  // namespace hapticell::app
