// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/drawing/picture_renderer.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <algorithm>

#include "app/viewport/drawing/frame_colors.h"
#include "app/viewport/drawing/scene_renderer.h"

namespace hapticell::app {

struct PictureRenderer::Context {
  QOffscreenSurface surface;
  QOpenGLContext context;
  Gl gl;
  std::unique_ptr<SceneRenderer> renderer;

  bool open() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(0);
    context.setFormat(format);
    surface.setFormat(format);
    surface.create();
    if (!surface.isValid() || !context.create() || !context.makeCurrent(&surface)) return false;
    if (!gl.initializeOpenGLFunctions()) return false;
    renderer = std::make_unique<SceneRenderer>(gl, [] {});
    return true;
  }
  ~Context() {
    if (renderer && context.makeCurrent(&surface)) renderer.reset();
    context.doneCurrent();
  }
};

PictureRenderer::PictureRenderer(std::unique_ptr<Context> context) : context_(std::move(context)) {}
PictureRenderer::PictureRenderer(PictureRenderer&&) noexcept = default;
PictureRenderer& PictureRenderer::operator=(PictureRenderer&&) noexcept = default;
PictureRenderer::~PictureRenderer() = default;

Expected<PictureRenderer> PictureRenderer::make() {
  auto context = std::make_unique<Context>();
  if (!context->open()) {
    return makeError({.place = "drawing",
                      .found = "this display has no OpenGL 3.3",
                      .expected = "a display with OpenGL 3.3 core",
                      .fix = "Start it on a desktop or with xvfb-run."});
  }
  context->context.doneCurrent();
  return PictureRenderer(std::move(context));
}

QImage PictureRenderer::draw(const SceneModel& scene, const Camera& camera, const QSize& size, const Theme& theme,
                             const Look& look) {
  constexpr int kLargestSide = 16384;
  QSize drawn = size.expandedTo({1, 1});
  if (std::max(drawn.width(), drawn.height()) > kLargestSide)
    drawn.scale(kLargestSide, kLargestSide, Qt::KeepAspectRatio);
  Frame frame;
  frame.camera = camera;
  frame.width = drawn.width();
  frame.height = drawn.height();
  frame.colors = frameColors(theme);
  frame.items = scene.items({});
  frame.bounds_W = scene.bounds_W();
  frame.edges = look.edges;
  frame.floor = look.floor;
  frame.refine = true;
  if (!context_->context.makeCurrent(&context_->surface)) return {};
  SceneRenderer& renderer = *context_->renderer;
  QImage picture;
  {
    QOpenGLFramebufferObject target(drawn);
    renderer.draw(frame);  // Tells which parts there are.
    renderer.waitForParts();
    for (frame.sample = 0; frame.sample < std::max(1, look.samples); ++frame.sample)
      renderer.render(frame, target.handle());
    picture = target.toImage().convertToFormat(QImage::Format_RGB32);
  }
  context_->context.doneCurrent();
  return picture;
}

}  // namespace hapticell::app
