// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/viewport_widget.h"

#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <algorithm>
#include <cmath>

#include "app/viewport/frame_colors.h"

namespace hapticell::app {
namespace {

constexpr double kTurnSeconds = 0.25;
constexpr double kSettleSeconds = 0.16;  // After so long without motion the picture is refined.
constexpr double kBandSeconds = 0.03;    // What a piece of a still picture may take.
constexpr double kRestSeconds = 6.0;     // What refining one picture may take in all,
constexpr int kLeastSamples = 4;         // but so many samples it has.
constexpr int kNewPartsMilliseconds = 20;
constexpr double kStylusPixels = 150.0;

std::array<float, 3> triple(const QColor& color) {
  return {color.redF(), color.greenF(), color.blueF()};
}

bool sameCamera(const Camera& a, const Camera& b) {
  return a.target_W == b.target_W && a.azimuth == b.azimuth && a.elevation == b.elevation && a.distance == b.distance &&
         a.field_of_view == b.field_of_view && a.perspective == b.perspective;
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
}

ViewportWidget::~ViewportWidget() {
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

void ViewportWidget::refresh() {
  update();
}

void ViewportWidget::refreshNumbers() {
  if (spokenNumbers() != drawn_numbers_) update();
}

std::vector<StripCell> ViewportWidget::spokenNumbers() const {
  const auto& snapshot = scene_.snapshot();
  std::vector<StripCell> said;
  if (snapshot && snapshot->connected) said = stripCells(*snapshot, strip_);
  for (const OverlayLabel& label : overlayLabels(scene_)) said.push_back({label.mark, label.number, label.names});
  return said;
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

std::vector<SceneCurve> ViewportWidget::allCurves() const {
  std::vector<SceneCurve> all;
  for (const auto& [owner, curves] : curves_) all.insert(all.end(), curves.begin(), curves.end());
  if (section_) {
    const auto section = sectionCurves(*section_, scene_.bounds_W(), camera_, viewSize());
    all.insert(all.end(), section.begin(), section.end());
  }
  if (!pick_hover_) return all;
  using Role = SceneCurve::Role;
  using Style = SceneCurve::Style;
  for (const auto& line : pick_hover_->outline_W) all.push_back({line, Role::kSelection, Style::kSolid, 2.5});
  if (pick_hover_->kind != FeatureKind::kFace)
    all.push_back({{pick_hover_->p_WQ}, Role::kSelection, Style::kSolid, 2.5});
  return all;
}

void ViewportWidget::advanceAnimation() {
  if (!turn_.active) return;
  const double s = static_cast<double>(turn_.clock.elapsed()) / 1000.0 / kTurnSeconds;
  camera_ = s >= 1.0 ? turn_.to : interpolate(turn_.from, turn_.to, eased(s));
  turn_.active = s < 1.0;
  emit cameraChanged();
}

Frame ViewportWidget::makeFrame() const {
  Frame frame;
  frame.camera = camera_;
  frame.pixel_ratio = devicePixelRatioF();
  frame.width = std::max(1, static_cast<int>(std::lround(width() * frame.pixel_ratio)));
  frame.height = std::max(1, static_cast<int>(std::lround(height() * frame.pixel_ratio)));
  const Theme& theme = themeOf(palette());
  frame.colors = frameColors(theme, scene_.colouredSets());
  SceneModel::StylusLook look;
  if (scene_.snapshot())
    look.length = kStylusPixels * camera_.metresPerPixel(scene_.snapshot()->X_WStylus.p, viewSize());
  look.body = theme.dark ? std::array<float, 3>{0.96f, 0.96f, 0.96f} : std::array<float, 3>{0.16f, 0.18f, 0.21f};
  look.band = triple(theme.selection);
  frame.items = scene_.items(look);
  frame.bounds_W = scene_.bounds_W();
  frame.edges = edges_;
  frame.section = section_;
  return frame;
}

void ViewportWidget::drawFrame() {
  const double now = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
  if (hasMoved()) return drawMoving(now);
  renderer_->present(static_cast<int>(std::lround(width() * devicePixelRatioF())),
                     static_cast<int>(std::lround(height() * devicePixelRatioF())), defaultFramebufferObject());
}

bool ViewportWidget::hasMoved() const {
  return dirty_ || scene_.revision() != drawn_revision_ || !sameCamera(camera_, drawn_camera_);
}

bool ViewportWidget::isFinished() const {
  if (!renderer_ || hasMoved() || turn_.active || label_layout_.moving()) return false;
  return sample_ >= SceneRenderer::kSamples || (sample_ >= kLeastSamples && rest_work_s_ > kRestSeconds);
}

void ViewportWidget::showNewPart() {
  dirty_ = true;
  update();
}

void ViewportWidget::drawMoving(double now) {
  Frame frame = makeFrame();
  frame.detail = governor_.level();
  renderer_->render(frame, defaultFramebufferObject());
  gl_.glFinish();
  last_motion_s_ = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
  governor_.frameTook(last_motion_s_ - now);
  drawn_revision_ = scene_.revision();
  drawn_camera_ = camera_;
  dirty_ = false;
  // Occlusion looks beyond the band that is drawn: a first round, which does not count, puts something there.
  sample_ = bands_ > 1 ? -1 : 0;
  band_ = 0;
  rest_work_s_ = 0.0;
  refine_.start(static_cast<int>(1000 * kSettleSeconds) + 10);
}

void ViewportWidget::refineStep() {
  if (!renderer_ || turn_.active || label_layout_.moving() || hasMoved()) return update();
  const double now = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
  if (now - last_motion_s_ < kSettleSeconds) return refine_.start(static_cast<int>(1000 * kSettleSeconds));
  if (isFinished() || !isVisible()) return;
  // Beside the window's own frames: putting the window together costs more than a band, so it waits for a whole sample.
  makeCurrent();
  const double took = refine(now);
  doneCurrent();
  if (band_ == 0) update();
  refine_.start(static_cast<int>(1000 * std::clamp(took, 0.002, kBandSeconds)));
}

double ViewportWidget::refine(double now) {
  Frame frame = makeFrame();
  frame.refine = true;
  frame.sample = std::max(sample_, 0);
  frame.band = band_;
  frame.bands = bands_;
  renderer_->draw(frame);
  gl_.glFinish();
  const double took = static_cast<double>(clock_.nsecsElapsed()) * 1e-9 - now;
  rest_work_s_ += took;
  slowest_band_s_ = band_ == 0 ? took : std::max(slowest_band_s_, took);
  if (++band_ >= bands_) {
    band_ = 0;
    ++sample_;
    if (slowest_band_s_ > kBandSeconds) bands_ = std::min(2 * bands_, 32);
    if (slowest_band_s_ < 0.3 * kBandSeconds) bands_ = std::max(bands_ / 2, 1);
  }
  return took;
}

std::vector<PlacedLabel> ViewportWidget::placeLabels(const std::vector<OverlayLabel>& labels) {
  std::vector<LabelWish> wishes;
  for (const OverlayLabel& label : labels) {
    const auto anchor = camera_.project(label.p_WQ, viewSize());
    const QSizeF size = labelSize(label);
    if (anchor) wishes.push_back({label.key, *anchor, {size.width(), size.height()}});
  }
  std::vector<PixelBox> keep_free;
  const QRectF strip =
      stripBox(scene_.snapshot() ? stripCells(*scene_.snapshot(), strip_) : std::vector<StripCell>{}, viewSize());
  if (!strip.isEmpty()) keep_free.push_back({{strip.left(), strip.top()}, {strip.right(), strip.bottom()}});
  constexpr double kHintHeight = 44.0, kHintHalfWidth = 320.0;  // It stands above the strip.
  if (!tools_.hint().isEmpty() && !strip.isEmpty())
    keep_free.push_back({{strip.center().x() - kHintHalfWidth, strip.top() - kHintHeight},
                         {strip.center().x() + kHintHalfWidth, strip.top()}});
  keep_free.push_back({{viewSize().width - 140, 0}, {viewSize().width, 130}});
  const QRectF views = view_strip_.box();
  if (!views.isEmpty()) keep_free.push_back({{0, 0}, {views.right() + 8, views.bottom() + 8}});
  if (scene_.snapshot() && forceArrowOpacity(scene_.snapshot()->force_n) > 0.0)
    if (const auto start = camera_.project(forceArrowStart_W(*scene_.snapshot()), viewSize()))
      keep_free.push_back({*start - glm::dvec2(24, 200), *start + glm::dvec2(80, 12)});
  const double now = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
  const double seconds = now - last_overlay_s_;
  last_overlay_s_ = now;
  return label_layout_.place(wishes, keep_free, viewSize(), seconds, motion_);
}

Overlay ViewportWidget::makeOverlay() {
  drawn_numbers_ = spokenNumbers();
  Overlay overlay;
  overlay.theme = &themeOf(palette());
  overlay.camera = camera_;
  overlay.size = viewSize();
  overlay.scene = &scene_;
  overlay.labels = overlayLabels(scene_);
  overlay.places = placeLabels(overlay.labels);
  if (scene_.snapshot() && scene_.snapshot()->connected) overlay.strip = stripCells(*scene_.snapshot(), strip_);
  overlay.hint = tools_.hint();
  if (pick_) {
    overlay.hint = pick_->prompt;
    if (pick_hover_) overlay.hint += QStringLiteral(" · ") + QString::fromStdString(featureText(*pick_hover_));
  }
  overlay.curves = allCurves();
  overlay.cube = viewCube();
  overlay.cube_hover = cube_hover_;
  if (scene_.empty()) overlay.empty = empty_;
  if (drag_ == Drag::kBox) {
    overlay.box = QRectF(press_place_, last_place_).normalized();
    overlay.box_touching = last_place_.x() < press_place_.x();
  }
  overlay.view_strip = &view_strip_;
  overlay.view_strip_hover = view_strip_hover_;
  overlay.missing_parts = renderer_ ? renderer_->missingParts() : 0;
  return overlay;
}

void ViewportWidget::paintOverlayImage() {
  const Overlay overlay = makeOverlay();
  QPainter onto(this);
  // Painted by the raster engine (the one on OpenGL smooths lines only with multisampling), and only where there is
  // something: each piece is uploaded.
  QRegion pieces;  // Its boxes do not overlap: what is half transparent is painted once.
  for (const QRectF& piece : overlayPieces(overlay)) pieces += piece.toAlignedRect().intersected(rect());
  for (const QRect& box : pieces) {
    QImage image(box.size() * devicePixelRatioF(), QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(devicePixelRatioF());
    image.fill(Qt::transparent);
    {
      QPainter painter(&image);
      painter.translate(-box.topLeft());
      paintOverlay(painter, overlay);
    }
    onto.drawImage(box.topLeft(), image);
  }
}

void ViewportWidget::paintGL() {
  const double start = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
  advanceAnimation();
  if (renderer_) drawFrame();
  paintOverlayImage();
  meter_.frame(start, static_cast<double>(clock_.nsecsElapsed()) * 1e-9 - start);
  if (turn_.active || label_layout_.moving())
    refine_.start(0);
  else if (!refine_.isActive() && !isFinished())
    refine_.start(2);
}

QImage ViewportWidget::finishedPicture() {
  turn_.active = false;
  last_motion_s_ = -1.0;
  makeCurrent();
  if (renderer_) {
    Frame frame = makeFrame();
    renderer_->render(frame, defaultFramebufferObject());  // Tells which parts there are.
    renderer_->waitForParts();
    QOpenGLFramebufferObject target(frame.width, frame.height);
    frame.refine = true;
    for (frame.sample = 0; frame.sample < SceneRenderer::kSamples; ++frame.sample)
      renderer_->render(frame, target.handle());
    QImage picture = target.toImage();
    doneCurrent();
    picture.setDevicePixelRatio(devicePixelRatioF());
    QPainter painter(&picture);
    label_layout_.place({}, {}, viewSize(), 1.0, false);
    paintOverlay(painter, makeOverlay());
    return picture;
  }
  doneCurrent();
  return {};
}

std::vector<double> ViewportWidget::measureFrames(int count) {
  std::vector<double> medians;
  makeCurrent();
  Frame frame = makeFrame();
  QOpenGLFramebufferObject target(frame.width, frame.height);
  if (renderer_) {
    renderer_->draw(frame);
    renderer_->waitForParts();
  }
  for (int level = 0; renderer_ && level <= static_cast<int>(DetailLevel::kCoarse); ++level) {
    frame.detail = static_cast<DetailLevel>(level);
    std::vector<double> times;
    for (int i = 0; i <= count; ++i) {
      frame.camera.azimuth += 0.01;
      const qint64 start = clock_.nsecsElapsed();
      renderer_->render(frame, target.handle());
      gl_.glFinish();
      if (i > 0) times.push_back(static_cast<double>(clock_.nsecsElapsed() - start) * 1e-9);
    }
    std::nth_element(times.begin(), times.begin() + count / 2, times.end());
    medians.push_back(times[static_cast<std::size_t>(count / 2)]);
  }
  doneCurrent();
  dirty_ = true;
  return medians;
}

void ViewportWidget::changeEvent(QEvent* event) {
  QOpenGLWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  dirty_ = true;
  update();
}

}  // namespace hapticell::app
