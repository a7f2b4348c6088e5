// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QTimer>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/viewport/drawing/scene_renderer.h"
#include "app/viewport/widget/rest_picture.h"
#include "app/viewport/widget/touch_meter.h"

namespace hapticell::app {

class ViewportWidget;

/// How the viewport draws the scene: frames while something moves, the picture at rest in pieces, pictures for others.
/// GUI thread.
class ViewPicture : public QObject {
 public:
  /// The view must outlive it.
  explicit ViewPicture(ViewportWidget& view);

  /// In the view's new OpenGL context, which is current.
  void begin();
  /// Before the context ends.
  void end();
  /// Of the clock that all times here are of.
  double seconds() const { return static_cast<double>(clock_.nsecsElapsed()) * 1e-9; }
  /// Draws the scene where it moved, else shows the picture again; in paintGL(), before the overlay.
  void draw();
  /// paintGL() ends, which began at `start` (seconds()): what comes next.
  void painted(double start);
  /// What is shown of the scene changed, or its colours did.
  void markDirty() { dirty_ = true; }
  /// Contacts that were felt before now could not be seen.
  void skipTouches();

  /// See ViewportWidget.
  bool isFinished() const;
  bool hasWhole(std::uint64_t revision) const;
  /// The scene was drawn last at this revision.
  bool shows(std::uint64_t revision) const { return revision == drawn_revision_; }
  /// All samples of the picture, without overlay; null where nothing can be drawn.
  QImage finished();
  std::vector<double> measureFrames(int count);
  /// What lies under a pixel of the screen.
  std::optional<PickedPoint> pick(int x, int y);
  std::size_t missingParts() const { return renderer_ ? renderer_->missingParts() : 0; }
  const FrameMeter& meter() const { return meter_; }
  DetailLevel detail() const { return governor_.level(); }
  TouchMeter::Figures touchFigures() const { return touch_.figures(); }
  bool isSoftware() const { return software_; }
  bool isSimplified() const { return simplified_; }

 private:
  bool hasMoved() const;
  void drawMoving(double now);
  void showNewPart();
  bool touchMatters() const;
  void refineStep();
  bool refine(double now);  ///< One piece of the picture at rest; true at the end of a sample.

  ViewportWidget& view_;
  Gl gl_;
  std::unique_ptr<SceneRenderer> renderer_;
  /// What a frame may take: for the window's 10 Hz; and while contacts can be felt, so that they are seen within 50 ms:
  /// one frame may be on its way when it comes, the next one shows it, and the window puts each together.
  /// s of a frame in motion: 10 Hz with room for the rest of the window; 60 Hz while contacts can be felt
  /// (docs/dev/window.md). Half: coarser; twice: below 10 Hz.
  static constexpr double kFrameSeconds = 0.055, kTouchFrameSeconds = 0.018;
  DetailGovernor governor_{kFrameSeconds, DetailLevel::kHalfSize};  ///< The first picture must not wait either.
  /// s of a picture at rest between two looks for events: not felt. Half: more pieces; twice: keys and mouse lag.
  static constexpr double kPieceSeconds = 0.03;
  RestPicture rest_{SceneRenderer::kSamples, kPieceSeconds};
  FrameMeter meter_;
  TouchMeter touch_;
  bool software_ = false, simplified_ = false;
  QElapsedTimer clock_;
  std::uint64_t drawn_revision_ = 0;
  Camera drawn_camera_;
  QSize drawn_pixels_;
  bool dirty_ = true;  ///< Theme or what is shown of the scene changed, or a part came.
  double last_motion_s_ = 0.0;
  QTimer refine_;
};

}  // namespace hapticell::app
