// SPDX-License-Identifier: Apache-2.0
#include "app/robot/robot_picture.h"

#include <QOpenGLFramebufferObject>

namespace hapticell::app {
namespace {

constexpr int kSamples = 4;  // Enough for a small picture.

}  // namespace

RobotPicture::RobotPicture() = default;

RobotPicture::~RobotPicture() {
  if (!renderer_ || !context_.makeCurrent(&surface_)) return;
  renderer_.reset();
  context_.doneCurrent();
}

bool RobotPicture::begin() {
  if (tried_) return renderer_ && context_.makeCurrent(&surface_);
  tried_ = true;
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  context_.setFormat(format);
  surface_.setFormat(format);
  surface_.create();
  if (!context_.create() || !context_.makeCurrent(&surface_) || !gl_.initializeOpenGLFunctions()) return false;
  renderer_ = std::make_unique<SceneRenderer>(gl_, std::function<void()>());
  return true;
}

QImage RobotPicture::draw(std::vector<workcell::Entity> entities, const std::vector<GhostPose>& ghosts,
                          const QSize& size, const Theme& theme) {
  if (size.isEmpty() || !begin()) return {};
  SceneModel scene;
  scene.setEntities(std::move(entities));
  scene.setGhosts(ghosts);
  Frame frame;
  frame.width = size.width();
  frame.height = size.height();
  frame.colors = frameColors(theme);
  frame.items = scene.items({});
  geometry::Bounds bounds;
  for (const RenderItem& item : frame.items) bounds.add(geometry::transformed(item.X_WM, item.bounds_M));
  frame.bounds_W = bounds;
  const ViewSize view{static_cast<double>(size.width()), static_cast<double>(size.height())};
  Camera camera;
  camera.azimuth = 0.7;
  camera.elevation = 0.3;
  frame.camera = camera.fitted(bounds, view);
  frame.refine = true;
  QOpenGLFramebufferObject target(size);
  renderer_->draw(frame);  // Tells which parts there are.
  renderer_->waitForParts();
  for (frame.sample = 0; frame.sample < kSamples; ++frame.sample) renderer_->render(frame, target.handle());
  QImage picture = target.toImage().convertToFormat(QImage::Format_RGB32);
  context_.doneCurrent();
  return picture;
}

}  // namespace hapticell::app
