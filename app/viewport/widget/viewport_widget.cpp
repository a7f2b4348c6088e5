// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/widget/viewport_widget.h"

#include <QOpenGLContext>
#include <algorithm>
#include <chrono>
#include <cmath>

namespace hapticell::app {
namespace {

constexpr int kNewPartsMilliseconds = 12;

/// As the manipulation loop stamps what is felt.
std::int64_t steadyNanoseconds() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

bool drawsInSoftware(Gl& gl) {
  const auto* name = reinterpret_cast<const char*>(gl.glGetString(GL_RENDERER));
  const QString renderer = QString::fromLatin1(name ? name : "").toLower();
  return renderer.contains(QStringLiteral("llvmpipe")) || renderer.contains(QStringLiteral("softpipe")) ||
         renderer.contains(QStringLiteral("swiftshader"));
}

}  // namespace

ViewportWidget::ViewportWidget(QWidget* parent) : QOpenGLWidget(parent) {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(0);
  setFormat(format);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setObjectName("viewport");
  setAccessibleName(tr("Scene"));
  clock_.start();
  refine_.setSingleShot(true);
  connect(&refine_, &QTimer::timeout, this, &ViewportWidget::refineStep);
  connect(this, &QOpenGLWidget::frameSwapped, this, [this] { touch_.shown(steadyNanoseconds()); });
}

ViewportWidget::~ViewportWidget() {
  // The context ends in the base's destructor, when there is no viewport any more to clear up.
  if (context() != nullptr) disconnect(context(), nullptr, this, nullptr);
  makeCurrent();
  renderer_.reset();
  doneCurrent();
}

void ViewportWidget::initializeGL() {
  if (!gl_.initializeOpenGLFunctions()) return;
  // Queued: the part is ready in another thread.
  renderer_ = std::make_unique<SceneRenderer>(gl_, [this] {
    QMetaObject::invokeMethod(
        this, [this] { showNewPart(); }, Qt::QueuedConnection);
  });
  renderer_->setFrameMilliseconds(kNewPartsMilliseconds);
  software_ = drawsInSoftware(gl_);
  dirty_ = true;
  // Moving the widget to another window makes a new context; everything of the old one goes with it.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
    makeCurrent();
    renderer_.reset();
    doneCurrent();
  });
}

ViewSize ViewportWidget::viewSize() const {
  return {static_cast<double>(width()), static_cast<double>(height())};
}

QSize ViewportWidget::devicePixels() const {
  return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1});
}

void ViewportWidget::resizeEvent(QResizeEvent* event) {
  QOpenGLWidget::resizeEvent(event);
  emit cameraChanged();
}

void ViewportWidget::refresh() {
  update();
  if (scene_.revision() == told_revision_) return;
  told_revision_ = scene_.revision();
  emit sceneChanged();
}

void ViewportWidget::refreshNumbers() {
  if (spokenNumbers() != drawn_numbers_) update();
}

void ViewportWidget::setCamera(const Camera& camera, bool animated) {
  if (animated && motion_) {
    turn_.from = camera_;
    turn_.to = camera;
    turn_.clock.start();
    turn_.active = true;
  } else {
    turn_.active = false;
    camera_ = camera;
  }
  emit cameraChanged();
  update();
}

void ViewportWidget::fit(const geometry::Bounds& bounds_W, bool animated) {
  setCamera((turn_.active ? turn_.to : camera_).fitted(bounds_W, viewSize()), animated);
}

void ViewportWidget::fitAll(bool animated) {
  setCamera((turn_.active ? turn_.to : camera_).fitted(scene_.corners_W(), viewSize()), animated);
}

void ViewportWidget::setStandardView(StandardView view) {
  setCamera((turn_.active ? turn_.to : camera_).turnedTo(view));
}

void ViewportWidget::setPerspective(bool on) {
  camera_.perspective = on;
  turn_.to.perspective = on;
  emit cameraChanged();
  update();
}

void ViewportWidget::setEdges(bool on) {
  edges_ = on;
  dirty_ = true;
  update();
}

void ViewportWidget::setSection(const std::optional<SectionPlane>& plane) {
  section_ = plane;
  dirty_ = true;
  update();
}

void ViewportWidget::setViewStrip(std::vector<ViewStripCell> cells) {
  view_strip_.setCells(std::move(cells));
  update();
}

void ViewportWidget::setPointerTool(PointerTool* tool, ToolChain::Place place) {
  tools_.set(place, tool);
  tool_active_ = false;
  update();
}

void ViewportWidget::setCurves(const std::string& owner, std::vector<SceneCurve> curves) {
  const auto known = curves_.find(owner);
  if (known == curves_.end() ? curves.empty() : known->second == curves) return;
  if (curves.empty())
    curves_.erase(known);
  else
    curves_[owner] = std::move(curves);
  update();
}

void ViewportWidget::showEvent(QShowEvent* event) {
  touch_.skipBefore(steadyNanoseconds());
  QOpenGLWidget::showEvent(event);
}

QImage ViewportWidget::smallPicture(int width) {
  return isVisible() ? grabFramebuffer().scaledToWidth(width, Qt::SmoothTransformation) : QImage();
}

void ViewportWidget::forgetCell() {
  cancelPick();
  curves_.clear();
  labels_.clear();
  setFigureStrip({});
  hover_name_.clear();
  scene_.forgetCell();
  update();
}

void ViewportWidget::changeEvent(QEvent* event) {
  QOpenGLWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  dirty_ = true;
  update();
}

}  // namespace hapticell::app
