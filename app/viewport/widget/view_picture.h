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

/// How the viewport draws the scene: frames during motion, the picture at rest in pieces, and pictures for other uses.
/// GUI thread. The view's property kRestSamples, a number from 0, replaces SceneRenderer::kSamples from the next paint on:
/// fewer give rougher edges and shadows for less work, and 0 leaves the frame in motion, at half the resolution; what is in
/// the scene stays the same, and what is picked to two pixels.
class ViewPicture : public QObject {
 public:
  static constexpr const char* kRestSamples = "restSamples";
  /// The view must outlive it.
  explicit ViewPicture(ViewportWidget& view);

  /// Call it in the view's new OpenGL context, made current.
  void begin();
  /// Call it before the context ends.
  void end();
  /// Present time of the clock that all times here refer to.
  double seconds() const { return static_cast<double>(clock_.nsecsElapsed()) * 1e-9; }
  /// Draws the scene if it changed, else shows the picture again; in paintGL(), before the overlay.
  void draw();
  /// Call it at the end of a paintGL() that began at `start` (seconds()): decides what follows.
  void painted(double start);
  /// The shown scene or its colours changed.
  void markDirty() { dirty_ = true; }
  /// Ignores contacts that were felt before now: they could not be seen.
  void skipTouches();

  /// See ViewportWidget.
  bool isFinished() const;
  bool hasWhole(std::uint64_t revision) const;
  /// True if the last drawn scene has this revision.
  bool shows(std::uint64_t revision) const { return revision == drawn_revision_; }
  /// All samples of the picture, without overlay; null if nothing can be drawn.
  QImage finished();
  std::vector<double> measureFrames(int count);
  /// What is under a pixel of the screen.
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
  int restSamples() const;
  bool isCoarse() const { return restSamples() == 0; }
  bool refine(double now);  ///< Draws one piece of the picture at rest; true at the end of a sample.

  ViewportWidget& view_;
  Gl gl_;
  std::unique_ptr<SceneRenderer> renderer_;
  /// s; time for a frame in motion (docs/dev/window.md): 10 Hz with room for the rest of the window; 60 Hz
  /// while contacts can be felt, so that they are seen within 50 ms (one frame may be in progress when a
  /// contact is felt, the next one shows it, and the window composes each of them). Half: coarser; twice: below
  /// 10 Hz.
  static constexpr double kFrameSeconds = 0.055, kTouchFrameSeconds = 0.018;
  DetailGovernor governor_{kFrameSeconds, DetailLevel::kHalfSize};  ///< So that the first picture is quick too.
  /// s of a picture at rest between two checks for events: not noticed. Half: more pieces; twice: keys and mouse lag.
  static constexpr double kPieceSeconds = 0.03;
  RestPicture rest_{SceneRenderer::kSamples, kPieceSeconds};
  FrameMeter meter_;
  TouchMeter touch_;
  bool software_ = false, simplified_ = false;
  QElapsedTimer clock_;
  std::uint64_t drawn_revision_ = 0;
  Camera drawn_camera_;
  QSize drawn_pixels_;
  bool dirty_ = true;  ///< Theme or shown scene changed, or a part became ready.
  double last_motion_s_ = 0.0;
  QTimer refine_;
};

}  // namespace hapticell::app
