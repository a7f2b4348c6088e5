// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/widget/viewport_widget.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QOpenGLContext>
#include <QPainter>
#include <QWheelEvent>

#include "app/viewport/drawing/frame_colors.h"
#include "app/viewport/scene/pen_look.h"
#include "app/viewport/widget/scene_picks.h"
#include "app/viewport/widget/view_overlay.h"
#include "app/viewport/widget/view_picture.h"
#include "app/viewport/widget/view_pointer.h"

namespace hapticell::app {
namespace {

constexpr double kCubeHalfEdge = 31.0;

std::array<float, 3> triple(const QColor& color) {
  return {color.redF(), color.greenF(), color.blueF()};
}

}  // namespace

ViewportWidget::ViewportWidget(QWidget* parent)
    : QOpenGLWidget(parent),
      picture_(std::make_unique<ViewPicture>(*this)),
      overlay_(std::make_unique<ViewOverlay>(*this)),
      picks_(std::make_unique<ScenePicks>(*this, *picture_)),
      pointer_(std::make_unique<ViewPointer>(*this, camera_, *picks_)) {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(0);
  setFormat(format);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setObjectName("viewport");
  setAccessibleName(tr("Scene"));
}

ViewportWidget::~ViewportWidget() {
  // The context ends in the base's destructor, when there is no picture any more to clear up.
  if (context() != nullptr) disconnect(context(), nullptr, picture_.get(), nullptr);
  picture_->end();
}

void ViewportWidget::initializeGL() {
  picture_->begin();
}

void ViewportWidget::paintGL() {
  const double start = seconds();
  advanceAnimation();
  picture_->draw();
  overlay_->paint();
  picture_->painted(start);
}

void ViewportWidget::advanceAnimation() {
  if (camera_.advance()) emit cameraChanged();
}

ViewSize ViewportWidget::viewSize() const {
  return {static_cast<double>(width()), static_cast<double>(height())};
}

QSize ViewportWidget::devicePixels() const {
  return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1});
}

Frame ViewportWidget::makeFrame() const {
  Frame frame;
  frame.camera = camera();
  frame.pixel_ratio = devicePixelRatioF();
  frame.width = devicePixels().width();
  frame.height = devicePixels().height();
  const Theme& theme = themeOf(palette());
  frame.colors = frameColors(theme, scene_.colouredSets());
  SceneModel::StylusLook look;
  if (scene_.snapshot())
    look.length = penPixels(viewSize()) * camera().metresPerPixel(scene_.snapshot()->stylus.X_WStylus.p, viewSize());
  look.body = penColor(false, theme.dark);
  look.band = triple(theme.selection);
  frame.items = scene_.items(look);
  frame.bounds_W = scene_.bounds_W();
  frame.edges = edges_;
  frame.section = section_;
  return frame;
}

ViewCube ViewportWidget::viewCube() const {
  return ViewCube({width() - 78.0, 72.0}, kCubeHalfEdge);
}

void ViewportWidget::refresh() {
  update();
  if (scene_.revision() == told_revision_) return;
  told_revision_ = scene_.revision();
  emit sceneChanged();
}

void ViewportWidget::refreshNumbers() {
  if (overlay_->hasNewNumbers()) update();
}

void ViewportWidget::setCamera(const Camera& camera, bool animated) {
  if (animated && motion_)
    camera_.turnTo(camera);
  else
    camera_.set(camera);
  emit cameraChanged();
  update();
}

void ViewportWidget::fit(const geometry::Bounds& bounds_W, bool animated) {
  setCamera(camera_.goal().fitted(bounds_W, viewSize()), animated);
}

void ViewportWidget::fitAll(bool animated) {
  setCamera(camera_.goal().fitted(scene_.corners_W(), viewSize()), animated);
}

void ViewportWidget::setStandardView(StandardView view) {
  setCamera(camera_.goal().turnedTo(view));
}

void ViewportWidget::setPerspective(bool on) {
  camera_.setPerspective(on);
  emit cameraChanged();
  update();
}

void ViewportWidget::setEdges(bool on) {
  edges_ = on;
  picture_->markDirty();
  update();
}

void ViewportWidget::setSection(const std::optional<SectionPlane>& plane) {
  section_ = plane;
  picture_->markDirty();
  update();
}

void ViewportWidget::forgetCell() {
  picks_->cancel();
  overlay_->forgetCell();
  pointer_->forgetHover();
  scene_.forgetCell();
  update();
}

// What is drawn.

bool ViewportWidget::isUnderWay() const {
  return camera_.isTurning() || overlay_->isMoving();
}

bool ViewportWidget::isFinished() const {
  return picture_->isFinished();
}

bool ViewportWidget::hasWhole(std::uint64_t revision) const {
  return picture_->hasWhole(revision);
}

bool ViewportWidget::shows(std::uint64_t revision) const {
  return picture_->shows(revision);
}

std::size_t ViewportWidget::missingParts() const {
  return picture_->missingParts();
}

double ViewportWidget::seconds() const {
  return picture_->seconds();
}

QImage ViewportWidget::smallPicture(int width) {
  return isVisible() ? grabFramebuffer().scaledToWidth(width, Qt::SmoothTransformation) : QImage();
}

QImage ViewportWidget::finishedPicture() {
  camera_.stop();
  QImage picture = picture_->finished();
  if (picture.isNull()) return picture;
  QPainter painter(&picture);
  overlay_->paintStill(painter);
  return picture;
}

std::vector<double> ViewportWidget::measureFrames(int count) {
  return picture_->measureFrames(count);
}

const FrameMeter& ViewportWidget::meter() const {
  return picture_->meter();
}

DetailLevel ViewportWidget::detail() const {
  return picture_->detail();
}

TouchMeter::Figures ViewportWidget::touchFigures() const {
  return picture_->touchFigures();
}

bool ViewportWidget::isSoftware() const {
  return picture_->isSoftware();
}

bool ViewportWidget::isSimplified() const {
  return picture_->isSimplified();
}

// What is painted over it.

void ViewportWidget::setCurves(const std::string& owner, std::vector<SceneCurve> curves) {
  overlay_->setCurves(owner, std::move(curves));
}

std::vector<SceneCurve> ViewportWidget::allCurves() const {
  return overlay_->allCurves();
}

void ViewportWidget::setLabels(const std::string& owner, std::vector<OverlayLabel> labels) {
  overlay_->setLabels(owner, std::move(labels));
}

std::vector<OverlayLabel> ViewportWidget::allLabels() const {
  return overlay_->allLabels();
}

const std::vector<PlacedLabel>& ViewportWidget::drawnLabels() const {
  return overlay_->drawnLabels();
}

void ViewportWidget::setStrip(const StripContext& context) {
  overlay_->setStrip(context);
}

void ViewportWidget::setFigureStrip(std::vector<StripCell> cells) {
  overlay_->setFigureStrip(std::move(cells));
}

const std::vector<StripCell>& ViewportWidget::figureStrip() const {
  return overlay_->figureStrip();
}

void ViewportWidget::setViewStrip(std::vector<ViewStripCell> cells) {
  overlay_->setViewStrip(std::move(cells));
  update();
}

const ViewStrip& ViewportWidget::viewStrip() const {
  return overlay_->viewStrip();
}

void ViewportWidget::setEmptyState(const std::optional<EmptyState>& state) {
  overlay_->setEmptyState(state);
}

// The pointer.

void ViewportWidget::setNavigation(const Navigation& navigation) {
  pointer_->setNavigation(navigation);
}

const Navigation& ViewportWidget::navigation() const {
  return pointer_->navigation();
}

void ViewportWidget::setPointerTool(PointerTool* tool, ToolChain::Place place) {
  pointer_->setTool(tool, place);
  update();
}

const QString& ViewportWidget::hoverName() const {
  return pointer_->hoverName();
}

void ViewportWidget::startPick(PickRequest request) {
  picks_->start(std::move(request));
}

void ViewportWidget::cancelPick() {
  picks_->cancel();
}

bool ViewportWidget::isPicking() const {
  return picks_->open().has_value();
}

std::optional<PickedFeature> ViewportWidget::featureAt(const QPointF& position, const FeatureFilter& filter) {
  return picks_->featureAt(position, filter);
}

std::optional<PickedFeature> ViewportWidget::featureNear(const QPointF& position,
                                                         const std::vector<workcell::EntityId>& without,
                                                         const FeatureFilter& filter) {
  return picks_->featureNear(position, without, filter);
}

std::vector<workcell::EntityId> ViewportWidget::entitiesIn(const QRectF& box, bool touching) {
  return picks_->entitiesIn(box, touching);
}

void ViewportWidget::mousePressEvent(QMouseEvent* event) {
  pointer_->press(event);
}

void ViewportWidget::mouseMoveEvent(QMouseEvent* event) {
  pointer_->move(event);
}

void ViewportWidget::mouseReleaseEvent(QMouseEvent* event) {
  pointer_->release(event);
}

void ViewportWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  pointer_->doubleClick(event);
}

void ViewportWidget::wheelEvent(QWheelEvent* event) {
  pointer_->turnWheel(event);
}

void ViewportWidget::leaveEvent(QEvent* event) {
  pointer_->leave();
  QOpenGLWidget::leaveEvent(event);
}

void ViewportWidget::keyPressEvent(QKeyEvent* event) {
  if (isPicking() && event->key() == Qt::Key_Escape) return cancelPick();
  QOpenGLWidget::keyPressEvent(event);
}

bool ViewportWidget::event(QEvent* event) {
  if (event->type() == QEvent::NativeGesture) {
    const auto* gesture = static_cast<QNativeGestureEvent*>(event);
    if (gesture->gestureType() == Qt::ZoomNativeGesture) {
      pointer_->pinch(gesture->value(), gesture->position());
      return true;
    }
  }
  return QOpenGLWidget::event(event);
}

void ViewportWidget::resizeEvent(QResizeEvent* event) {
  QOpenGLWidget::resizeEvent(event);
  emit cameraChanged();
}

void ViewportWidget::showEvent(QShowEvent* event) {
  picture_->skipTouches();
  QOpenGLWidget::showEvent(event);
}

void ViewportWidget::changeEvent(QEvent* event) {
  QOpenGLWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  picture_->markDirty();
  update();
}

}  // namespace hapticell::app
