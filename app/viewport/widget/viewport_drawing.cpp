// SPDX-License-Identifier: Apache-2.0
// How the viewport draws: frames while something moves, the picture at rest in pieces, pictures for others.
#include <QOpenGLFramebufferObject>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/viewport/drawing/frame_colors.h"
#include "app/viewport/scene/pen_look.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr double kTurnSeconds = 0.25;
constexpr double kSeenPixels = 1.0;      // What is further off its shape is seen by who looks for it.
constexpr double kSettleSeconds = 0.16;  // After so long without motion the picture is refined.

std::array<float, 3> triple(const QColor& color) {
  return {color.redF(), color.greenF(), color.blueF()};
}

bool sameCamera(const Camera& a, const Camera& b) {
  return a.target_W == b.target_W && a.azimuth == b.azimuth && a.elevation == b.elevation && a.distance == b.distance &&
         a.field_of_view == b.field_of_view && a.perspective == b.perspective;
}

}  // namespace

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
  frame.width = devicePixels().width();
  frame.height = devicePixels().height();
  const Theme& theme = themeOf(palette());
  frame.colors = frameColors(theme, scene_.colouredSets());
  SceneModel::StylusLook look;
  if (scene_.snapshot())
    look.length = penPixels(viewSize()) * camera_.metresPerPixel(scene_.snapshot()->X_WStylus.p, viewSize());
  look.body = penColor(false, theme.dark);
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
  simplified_ = simplified_ && !renderer_->showsRest();
  renderer_->present(devicePixels().width(), devicePixels().height(), defaultFramebufferObject());
}

bool ViewportWidget::hasMoved() const {
  return dirty_ || devicePixels() != drawn_pixels_ || scene_.revision() != drawn_revision_ ||
         !sameCamera(camera_, drawn_camera_);
}

bool ViewportWidget::isFinished() const {
  if (!renderer_ || hasMoved() || turn_.active || label_layout_.moving()) return false;
  return rest_.isFinished();
}

bool ViewportWidget::hasWhole(std::uint64_t revision) const {
  return renderer_ && drawn_revision_ >= revision && renderer_->missingParts() == 0;
}

void ViewportWidget::showNewPart() {
  dirty_ = true;
  update();
}

/// Something is held with forces on: a contact that is felt is to be seen at once.
bool ViewportWidget::touchMatters() const {
  const auto& now = scene_.snapshot();
  return now &&
         ((now->forces_on && now->held != 0) || (now->second && now->second->forces_on && now->second->held != 0));
}

void ViewportWidget::drawMoving(double now) {
  Frame frame = makeFrame();
  governor_.setBudget(touchMatters() ? kTouchFrameSeconds : kFrameSeconds);
  frame.detail = governor_.level();
  frame.most_triangles = governor_.mostTriangles();
  renderer_->render(frame, defaultFramebufferObject());
  gl_.glFinish();
  last_motion_s_ = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
  governor_.frameTook(last_motion_s_ - now, renderer_->lastCount().triangles);
  simplified_ = frame.detail >= DetailLevel::kHalfSize || renderer_->lastCount().pixels_off > kSeenPixels;
  touch_.drawn(scene_.snapshot() ? scene_.snapshot()->felt_ns : 0);
  drawn_revision_ = scene_.revision();
  drawn_camera_ = camera_;
  drawn_pixels_ = devicePixels();
  dirty_ = false;
  rest_.begin();
  refine_.start(static_cast<int>(1000 * kSettleSeconds) + 10);
}

void ViewportWidget::refineStep() {
  if (!renderer_ || turn_.active || label_layout_.moving() || hasMoved()) return update();
  const double now = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
  if (now - last_motion_s_ < kSettleSeconds) return refine_.start(static_cast<int>(1000 * kSettleSeconds));
  if (isFinished() || !isVisible()) return;
  makeCurrent();
  const bool sample_ended = refine(now);
  doneCurrent();
  const double took = static_cast<double>(clock_.nsecsElapsed()) * 1e-9 - now;
  // Putting the window together costs more than a piece, so it waits for a whole sample.
  if (sample_ended) update();
  refine_.start(static_cast<int>(1000 * std::clamp(took, 0.002, kPieceSeconds)));
}

bool ViewportWidget::refine(double now) {
  const RestPicture::Piece piece = rest_.next();
  Frame frame = makeFrame();
  frame.refine = true;
  frame.sample = piece.sample;
  frame.band = piece.band;
  frame.bands = piece.bands;
  const auto done = renderer_->drawPiece(frame, piece.shadows, 0.5 * kPieceSeconds);
  gl_.glFinish();
  return rest_.took({static_cast<double>(clock_.nsecsElapsed()) * 1e-9 - now, done.whole, done.longest_least});
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

}  // namespace hapticell::app
