// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/drawing/scene_renderer.h"

#include <algorithm>
#include <chrono>

#include "app/viewport/drawing/cap_pass.h"
#include "app/viewport/drawing/surface_pass.h"

namespace hapticell::app {
namespace {

// m in which corners darken; our choice, a hand's length. Half: only small corners; twice: grey between parts.
constexpr double kOcclusionRadius = 0.16;

void setColor(QOpenGLShaderProgram& program, const char* name, const fvec3& color) {
  program.setUniformValue(name, color.x, color.y, color.z);
}

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct PixelArea {
  int x = 0, y = 0, width = 0, height = 0;  // From below, as OpenGL counts.
};

PixelArea bandArea(const Frame& frame) {
  const int low = frame.height * frame.band / frame.bands;
  const int high = frame.height * (frame.band + 1) / frame.bands;
  return {0, low, frame.width, high - low};
}

PixelArea common(const PixelArea& a, const PixelArea& b) {
  const int left = std::max(a.x, b.x), low = std::max(a.y, b.y);
  return {left, low, std::min(a.x + a.width, b.x + b.width) - left, std::min(a.y + a.height, b.y + b.height) - low};
}

/// Where marked items lie, with room for their outlines.
PixelArea markedArea(const Frame& frame) {
  const ViewSize size{static_cast<double>(frame.width), static_cast<double>(frame.height)};
  glm::dvec2 low(1e9);
  glm::dvec2 high(-1e9);
  for (const RenderItem& item : frame.items) {
    if (item.state == kPlain || !item.mesh) continue;
    const geometry::Bounds bounds = geometry::transformed(item.X_WM, item.bounds_M);
    for (int i = 0; i < 8; ++i) {
      const dvec3 corner((i & 1) ? bounds.max.x : bounds.min.x, (i & 2) ? bounds.max.y : bounds.min.y,
                         (i & 4) ? bounds.max.z : bounds.min.z);
      const auto pixel = frame.camera.project(corner, size);
      if (!pixel) return {0, 0, frame.width, frame.height};  // Reaches behind the eye.
      low = glm::min(low, *pixel);
      high = glm::max(high, *pixel);
    }
  }
  if (low.x > high.x) return {};
  // Pixels about what is drawn: lines and their shadows. Half: cut lines; twice: time.
  constexpr double kRoom = 6.0;
  const int left = static_cast<int>(std::clamp(low.x - kRoom, 0.0, size.width));
  const int right = static_cast<int>(std::clamp(high.x + kRoom, 0.0, size.width));
  const int bottom = static_cast<int>(std::clamp(size.height - high.y - kRoom, 0.0, size.height));
  const int top = static_cast<int>(std::clamp(size.height - low.y + kRoom, 0.0, size.height));
  return {left, bottom, right - left, top - bottom};
}

void prepareComposite(Gl& gl, QOpenGLShaderProgram& program, const Frame& frame, RenderTarget& scene, GLuint openness) {
  program.bind();
  bindTexture(gl, program, "color_map", 0, scene.color(0));
  bindTexture(gl, program, "id_map", 1, scene.color(1));
  bindTexture(gl, program, "openness_map", 2, openness);
  const glm::vec4& line = frame.colors.crease;
  program.setUniformValue("silhouette_color", line.x, line.y, line.z);
  setColor(program, "selected_color", frame.colors.selected);
  setColor(program, "hovered_color", frame.colors.hovered);
  std::array<GLfloat, 3 * kSetColors> near{}, contact{};
  for (std::size_t i = 0; i < kSetColors; ++i)
    for (int c = 0; c < 3; ++c) {
      near[3 * i + static_cast<std::size_t>(c)] = frame.colors.set_colors[i].near_miss[c];
      contact[3 * i + static_cast<std::size_t>(c)] = frame.colors.set_colors[i].contact[c];
    }
  program.setUniformValueArray("near_colors", near.data(), static_cast<int>(kSetColors), 3);
  program.setUniformValueArray("contact_colors", contact.data(), static_cast<int>(kSetColors), 3);
  const double ratio = frame.detail >= DetailLevel::kHalfSize ? 0.5 * frame.pixel_ratio : frame.pixel_ratio;
  program.setUniformValue("pixel_ratio", static_cast<float>(ratio));
  program.setUniformValue("share", 1.0f / static_cast<float>(frame.sample + 1));
}

}  // namespace

struct SceneRenderer::Passes {
  Passes(Gl& gl, std::function<void()> on_mesh_ready)
      : meshes(gl, std::move(on_mesh_ready)),
        shadow(gl),
        surface(gl),
        cap(gl),
        edge(gl),
        floor(gl),
        triangle(gl),
        programs{loadProgram("screen", "background"), loadProgram("screen", "occlusion"),
                 loadProgram("screen", "present")},
        composite("screen", "composite", {"OCCLUDED", "SILHOUETTES", "STATES"}),
        scene(gl, {{GL_RGBA8, GL_R32UI}, true, true, false, false}),
        rest(gl, {{GL_RGBA8, GL_R32UI}, true, true, false, false}),
        openness(gl, {{GL_R8}, false, false, false, true}),
        quick(gl, {{GL_RGBA8}, false, false, false, true}),
        mean(gl, {{GL_RGBA16F}, false, false, false, true}) {}
  GpuMeshCache meshes;
  ShadowPass shadow;
  SurfacePass surface;
  CapPass cap;
  EdgePass edge;
  FloorPass floor;
  ScreenTriangle triangle;
  struct Programs {
    std::unique_ptr<QOpenGLShaderProgram> background, occlusion, present;
  } programs;
  ProgramFamily composite;
  RenderTarget scene;  // What is picked in.
  RenderTarget rest;   // The sample that is being drawn in pieces.
  RenderTarget openness;
  RenderTarget quick;       // The first sample of a picture: as good as shown, and cheap.
  RenderTarget mean;        // Of a picture that is refined.
  bool refined = false;     // What was drawn last went into the mean.
  bool mean_whole = false;  // Its first sample covers the whole picture.
  RenderTarget* target = &scene;
  DrawProgress progress;
  FrameView view, picked_view;
  bool complete() const { return programs.background && programs.occlusion && programs.present; }
};

SceneRenderer::SceneRenderer(Gl& gl, std::function<void()> on_mesh_ready)
    : gl_(gl), passes_(std::make_unique<Passes>(gl, std::move(on_mesh_ready))) {}
SceneRenderer::~SceneRenderer() = default;

void SceneRenderer::drawShadows(const Frame& frame) {
  Passes& p = *passes_;
  // Without occlusion the shadows of the last full picture stay: the cell seldom changes, the eye does.
  if (frame.detail != DetailLevel::kFull || frame.band > 0) return;
  DrawShare all;
  p.shadow.draw(frame, p.meshes, all);
}

void SceneRenderer::drawScene(const Frame& frame, DrawShare& share) {
  Passes& p = *passes_;
  p.view = viewOf(frame);
  p.target->bind();
  const PixelArea band = bandArea(frame);
  gl_.glEnable(GL_SCISSOR_TEST);
  // A little more than the band: occlusion and outlines look at their neighbours.
  gl_.glScissor(0, std::max(band.y - kBandRoom, 0), band.width, band.height + 2 * kBandRoom);
  gl_.glDisable(GL_BLEND);
  gl_.glDisable(GL_CULL_FACE);
  gl_.glDepthMask(GL_TRUE);
  share.once(1, [&] {
    const GLfloat far_away = 1.0f;
    gl_.glClearBufferfv(GL_DEPTH, 0, &far_away);
    gl_.glDisable(GL_DEPTH_TEST);
    p.programs.background->bind();
    setColor(*p.programs.background, "top", frame.colors.background_top);
    setColor(*p.programs.background, "bottom", frame.colors.background_bottom);
    p.triangle.draw();
  });
  const ShadowPass* shadow = frame.detail <= DetailLevel::kNoOcclusion ? &p.shadow : nullptr;
  const DrawContext context{frame, p.view, p.meshes, share};
  p.surface.draw(context, shadow);
  p.cap.draw(context);
  if (frame.floor) p.floor.draw(context, shadow);
  if (frame.edges && frame.detail < DetailLevel::kNoEdges) p.edge.draw(context, frame.detail != DetailLevel::kFull);
  gl_.glDisable(GL_SCISSOR_TEST);
  gl_.glDisable(GL_DEPTH_TEST);
}

void SceneRenderer::drawOcclusion(const Frame& frame) {
  Passes& p = *passes_;
  p.openness.resize((frame.width + 1) / 2, (frame.height + 1) / 2);
  p.openness.bind();
  const PixelArea band = bandArea(frame);
  gl_.glEnable(GL_SCISSOR_TEST);
  gl_.glScissor(0, band.y / 2, p.openness.width(), (band.y + band.height + 1) / 2 - band.y / 2);
  p.programs.occlusion->bind();
  bindTexture(gl_, *p.programs.occlusion, "depth_map", 0, p.target->depth());
  setMatrix(gl_, *p.programs.occlusion, "clip_from_view", p.view.clip_from_view);
  setMatrix(gl_, *p.programs.occlusion, "view_from_clip", glm::inverse(p.view.clip_from_view));
  p.programs.occlusion->setUniformValue("radius", static_cast<float>(kOcclusionRadius));
  p.programs.occlusion->setUniformValue("turn", static_cast<float>(frame.sample));
  p.triangle.draw();
  gl_.glDisable(GL_SCISSOR_TEST);
}

void SceneRenderer::compositeBand(const Frame& frame, bool occluded) {
  Passes& p = *passes_;
  (p.refined ? p.mean : p.quick).bind();
  if (frame.sample > 0) gl_.glEnable(GL_BLEND);
  gl_.glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  const unsigned set = (occluded ? 1u : 0u) | (frame.edges && frame.detail < DetailLevel::kNoEdges ? 2u : 0u);
  // The outlines of states look at many pixels, so they are drawn only where marked parts are.
  const PixelArea marked = markedArea(frame);
  const auto pass = [&](const PixelArea& wanted, unsigned switches) {
    const PixelArea area = common(wanted, bandArea(frame));
    if (area.width <= 0 || area.height <= 0) return;
    QOpenGLShaderProgram* program = p.composite.of(switches);
    if (!program) return;
    prepareComposite(gl_, *program, frame, *p.target, occluded ? p.openness.color(0) : p.target->color(0));
    gl_.glScissor(area.x, area.y, area.width, area.height);
    p.triangle.draw();
  };
  gl_.glEnable(GL_SCISSOR_TEST);
  const int top = marked.y + marked.height;
  const int right = marked.x + marked.width;
  pass({0, 0, frame.width, marked.y}, set);
  pass({0, top, frame.width, frame.height - top}, set);
  pass({0, marked.y, marked.x, marked.height}, set);
  pass({right, marked.y, frame.width - right, marked.height}, set);
  pass(marked, set | 4u);
  gl_.glDisable(GL_SCISSOR_TEST);
  gl_.glDisable(GL_BLEND);
}

void SceneRenderer::composite(const Frame& frame, DrawShare& share) {
  const bool occluded = frame.detail == DetailLevel::kFull;
  if (occluded) share.once(1, [&] { drawOcclusion(frame); });
  share.once(1, [&] { compositeBand(frame, occluded); });
}

void SceneRenderer::draw(const Frame& wanted) {
  Passes& p = *passes_;
  if (!p.complete()) return;
  Frame frame = wanted;
  if (frame.detail >= DetailLevel::kHalfSize) {
    frame.width = std::max(1, frame.width / 2);
    frame.height = std::max(1, frame.height / 2);
  }
  p.meshes.counted() = {};
  p.shadow.giveUp();
  p.progress.done = 0;
  p.target = &p.scene;
  p.scene.resize(frame.width, frame.height);
  p.refined = frame.refine;
  if ((p.refined ? p.mean : p.quick).resize(frame.width, frame.height)) frame.sample = 0;
  DrawShare all;
  drawShadows(frame);
  drawScene(frame, all);
  composite(frame, all);

  if (frame.sample == 0) p.meshes.collect();
  p.mean_whole = p.refined && (frame.sample > 0 || frame.band + 1 == frame.bands);
  p.picked_view = p.view;
  last_ = std::move(frame);
}

SceneRenderer::PieceDone SceneRenderer::drawPiece(const Frame& frame, bool shadows, double seconds) {
  Passes& p = *passes_;
  if (!p.complete()) return {true, 0.0};
  DrawShare share(p.progress, seconds, {steadySeconds, [this] { gl_.glFinish(); }});
  if (shadows) {
    p.shadow.draw(frame, p.meshes, share);
  } else {
    p.target = &p.rest;
    p.rest.resize(frame.width, frame.height);
    p.mean.resize(frame.width, frame.height);
    p.refined = true;
    drawScene(frame, share);
    composite(frame, share);
  }
  if (!share.isWhole()) return {false, share.longestLeast()};
  p.progress.done = 0;
  if (shadows) return {true, 0.0};
  if (frame.sample == 0) p.meshes.collect();
  if (frame.band + 1 == frame.bands) {
    p.mean_whole = true;
    keepForPicking(frame);
  }
  return {true, share.longestLeast()};
}

/// Where a picture is still being drawn nothing can be picked: the identities of the last whole sample are copied.
void SceneRenderer::keepForPicking(const Frame& frame) {
  Passes& p = *passes_;
  p.scene.resize(frame.width, frame.height);
  gl_.glBindFramebuffer(GL_READ_FRAMEBUFFER, p.rest.framebuffer());
  gl_.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, p.scene.framebuffer());
  gl_.glReadBuffer(GL_COLOR_ATTACHMENT1);
  const GLenum identities[]{GL_NONE, GL_COLOR_ATTACHMENT1}, all[]{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  gl_.glDrawBuffers(2, identities);
  gl_.glBlitFramebuffer(0, 0, frame.width, frame.height, 0, 0, frame.width, frame.height,
                        GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  gl_.glDrawBuffers(2, all);
  gl_.glReadBuffer(GL_COLOR_ATTACHMENT0);
  p.picked_view = p.view;
  last_ = frame;
}

void SceneRenderer::render(const Frame& frame, GLuint framebuffer) {
  draw(frame);
  present(frame.width, frame.height, framebuffer);
}

std::size_t SceneRenderer::missingParts() const {
  return passes_->meshes.pending();
}
DrawCount SceneRenderer::lastCount() const {
  return passes_->meshes.counted();
}
void SceneRenderer::setFrameMilliseconds(int most) {
  passes_->meshes.setFrameMilliseconds(most);
}
void SceneRenderer::waitForParts() {
  passes_->meshes.wait();
}

void SceneRenderer::present(int width, int height, GLuint framebuffer) {
  Passes& p = *passes_;
  // QPainter goes on from here and expects the state as it is by default.
  gl_.glUseProgram(0);
  for (const GLenum unit : {GL_TEXTURE2, GL_TEXTURE1, GL_TEXTURE0}) {
    gl_.glActiveTexture(unit);
    gl_.glBindTexture(GL_TEXTURE_2D, 0);
  }
  gl_.glBindVertexArray(0);
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl_.glViewport(0, 0, width, height);
  gl_.glDisable(GL_DEPTH_TEST);
  gl_.glDisable(GL_BLEND);
  const RenderTarget& picture = p.mean_whole ? p.mean : p.quick;
  if (!p.complete() || picture.width() == 0) {
    gl_.glClearColor(0.13f, 0.15f, 0.18f, 1.0f);
    gl_.glClear(GL_COLOR_BUFFER_BIT);
    return;
  }
  if (!p.mean_whole) {
    gl_.glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.framebuffer());
    const GLenum filter = picture.width() == width ? GL_NEAREST : GL_LINEAR;
    gl_.glBlitFramebuffer(0, 0, picture.width(), picture.height(), 0, 0, width, height, GL_COLOR_BUFFER_BIT, filter);
    gl_.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    return;
  }
  p.programs.present->bind();
  bindTexture(gl_, *p.programs.present, "picture", 0, picture.color(0));
  p.triangle.draw();
  p.programs.present->release();
  gl_.glBindTexture(GL_TEXTURE_2D, 0);
}

bool SceneRenderer::showsRest() const {
  return passes_->mean_whole;
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
  const glm::dvec4 clip(2.0 * (x + 0.5) / last_.width - 1.0, 2.0 * (row + 0.5) / last_.height - 1.0, 2.0 * depth - 1.0,
                        1.0);
  const glm::dvec4 world = glm::inverse(p.picked_view.clip_from_world) * clip;
  const RenderItem& item = last_.items[id - 1];
  return PickedPoint{item.entity, item.link, dvec3(world) / world.w};
}

}  // namespace hapticell::app
