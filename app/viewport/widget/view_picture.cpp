// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/widget/view_picture.h"

#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

// What is further off its shape is seen by who looks for it: a pixel. Half: said without reason; twice: not said where
// it is seen.
constexpr double kSeenPixels = 1.0;
// s without motion until the picture is refined: a hand pauses for less. Half: begun for nothing; twice: rough edges
// stay.
constexpr double kSettleSeconds = 0.16;

bool sameCamera(const Camera& a, const Camera& b) {
  return a.target_W == b.target_W && a.azimuth == b.azimuth && a.elevation == b.elevation && a.distance == b.distance &&
         a.field_of_view == b.field_of_view && a.perspective == b.perspective;
}

// ms of a frame for new parts, most of a picture at 60 Hz. Half: large cells appear later; twice: jerks while they do.
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

ViewPicture::ViewPicture(ViewportWidget& view) : view_(view) {
  clock_.start();
  refine_.setSingleShot(true);
  connect(&refine_, &QTimer::timeout, this, &ViewPicture::refineStep);
  connect(&view_, &QOpenGLWidget::frameSwapped, this, [this] { touch_.shown(steadyNanoseconds()); });
}

void ViewPicture::end() {
  view_.makeCurrent();
  renderer_.reset();
  view_.doneCurrent();
}

void ViewPicture::skipTouches() {
  touch_.skipBefore(steadyNanoseconds());
}

std::optional<PickedPoint> ViewPicture::pick(int x, int y) {
  if (!renderer_) return std::nullopt;
  view_.makeCurrent();
  const auto picked = renderer_->pick(x, y);
  view_.doneCurrent();
  return picked;
}

void ViewPicture::draw() {
  if (!renderer_) return;
  const double now = seconds();
  if (hasMoved()) return drawMoving(now);
  simplified_ = simplified_ && !renderer_->showsRest();
  renderer_->present(view_.devicePixels().width(), view_.devicePixels().height(), view_.defaultFramebufferObject());
}

bool ViewPicture::hasMoved() const {
  return dirty_ || view_.devicePixels() != drawn_pixels_ || view_.scene().revision() != drawn_revision_ ||
         !sameCamera(view_.camera(), drawn_camera_);
}

bool ViewPicture::isFinished() const {
  if (!renderer_ || hasMoved() || view_.isUnderWay()) return false;
  return isCoarse() || rest_.isFinished();
}

bool ViewPicture::hasWhole(std::uint64_t revision) const {
  return renderer_ && drawn_revision_ >= revision && renderer_->missingParts() == 0;
}

void ViewPicture::showNewPart() {
  dirty_ = true;
  view_.update();
}

/// Something is held with forces on: a contact that is felt is to be seen at once.
bool ViewPicture::touchMatters() const {
  const auto& now = view_.scene().snapshot();
  return now && ((now->stylus.forces_on && now->stylus.held != 0) ||
                 (now->second && now->second->forces_on && now->second->held != 0));
}

void ViewPicture::drawMoving(double now) {
  Frame frame = view_.makeFrame();
  governor_.setBudget(touchMatters() ? kTouchFrameSeconds : kFrameSeconds);
  frame.detail = isCoarse() ? DetailLevel::kHalfSize : governor_.level();
  frame.most_triangles = governor_.mostTriangles();
  renderer_->render(frame, view_.defaultFramebufferObject());
  gl_.glFinish();
  last_motion_s_ = seconds();
  if (!isCoarse()) governor_.frameTook(last_motion_s_ - now, renderer_->lastCount().triangles);
  simplified_ = frame.detail >= DetailLevel::kHalfSize || renderer_->lastCount().pixels_off > kSeenPixels;
  touch_.drawn(view_.scene().snapshot() ? view_.scene().snapshot()->felt_ns : 0);
  drawn_revision_ = view_.scene().revision();
  drawn_camera_ = view_.camera();
  drawn_pixels_ = view_.devicePixels();
  dirty_ = false;
  rest_.begin();
  refine_.start(static_cast<int>(1000 * kSettleSeconds) + 10);
}

void ViewPicture::refineStep() {
  if (!renderer_ || view_.isUnderWay() || hasMoved()) return view_.update();
  const double now = seconds();
  if (now - last_motion_s_ < kSettleSeconds) return refine_.start(static_cast<int>(1000 * kSettleSeconds));
  if (isFinished() || !view_.isVisible()) return;
  view_.makeCurrent();
  const bool sample_ended = refine(now);
  view_.doneCurrent();
  const double took = seconds() - now;
  // Putting the window together costs more than a piece, so it waits for a whole sample.
  if (sample_ended) view_.update();
  refine_.start(static_cast<int>(1000 * std::clamp(took, 0.002, kPieceSeconds)));
}

void ViewPicture::painted(double start) {
  meter_.frame(start, seconds() - start);
  rest_.setMostSamples(std::max(restSamples(), 1));
  if (view_.isUnderWay())
    refine_.start(0);
  else if (!refine_.isActive() && !isFinished())
    refine_.start(2);
}

bool ViewPicture::refine(double now) {
  const RestPicture::Piece piece = rest_.next();
  Frame frame = view_.makeFrame();
  frame.refine = true;
  frame.sample = piece.sample;
  frame.band = piece.band;
  frame.bands = piece.bands;
  const auto done = renderer_->drawPiece(frame, piece.shadows, 0.5 * kPieceSeconds);
  gl_.glFinish();
  return rest_.took({seconds() - now, done.whole, done.longest_least});
}

int ViewPicture::restSamples() const {
  const QVariant wanted = view_.property(kRestSamples);
  return wanted.isValid() ? std::max(wanted.toInt(), 0) : SceneRenderer::kSamples;
}

QImage ViewPicture::finished() {
  last_motion_s_ = -1.0;
  view_.makeCurrent();
  if (renderer_) {
    Frame frame = view_.makeFrame();
    renderer_->render(frame, view_.defaultFramebufferObject());  // Tells which parts there are.
    renderer_->waitForParts();
    QOpenGLFramebufferObject target(frame.width, frame.height);
    frame.refine = true;
    const int samples = std::max(restSamples(), 1);
    for (frame.sample = 0; frame.sample < samples; ++frame.sample)
      renderer_->render(frame, target.handle());
    QImage picture = target.toImage();
    view_.doneCurrent();
    picture.setDevicePixelRatio(view_.devicePixelRatioF());
    return picture;
  }
  view_.doneCurrent();
  return {};
}

std::vector<double> ViewPicture::measureFrames(int count) {
  std::vector<double> medians;
  view_.makeCurrent();
  Frame frame = view_.makeFrame();
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
  view_.doneCurrent();
  dirty_ = true;
  return medians;
}

void ViewPicture::begin() {
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
  connect(view_.context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { end(); });
}

}  // namespace hapticell::app
