// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointF>
#include <QRectF>
#include <QString>
#include <optional>

#include "app/viewport/overlay/view_cube.h"
#include "app/viewport/tools/navigation.h"
#include "app/viewport/tools/tool_chain.h"

class QMouseEvent;
class QWheelEvent;

namespace hapticell::app {

class ScenePicks;
class TurningCamera;
class ViewportWidget;

/// What the pointer's place and drag show over the scene.
struct PointerMarks {
  std::optional<ViewCubeSpot> cube;
  int view_strip_cell = -1;   ///< Or -1.
  std::optional<QRectF> box;  ///< Drawn by the mouse to choose what lies in it,
  bool box_touching = false;  ///< or what it touches.
  QString name;               ///< What the pointer is over; empty: nothing, or a drag.
  QPointF name_place;
};

/// The pointer over the viewport: it turns, shifts and zooms the camera, picks, drags the view cube and the section,
/// and serves the tools before all of these. GUI thread.
class ViewPointer {
 public:
  /// All must outlive it.
  ViewPointer(ViewportWidget& view, TurningCamera& camera, ScenePicks& picks);

  void press(QMouseEvent* event);
  void move(QMouseEvent* event);
  void release(QMouseEvent* event);
  void doubleClick(QMouseEvent* event);
  void turnWheel(QWheelEvent* event);
  /// A touchpad's two fingers spread by this part of their distance.
  void pinch(double spread, const QPointF& position);
  void leave();

  void setTool(PointerTool* tool, ToolChain::Place place);
  QString hint() const { return tools_.hint(); }
  void setNavigation(const Navigation& navigation) { navigation_ = navigation; }
  const Navigation& navigation() const { return navigation_; }
  const QString& hoverName() const { return hover_name_; }
  void forgetHover() { hover_name_.clear(); }
  PointerMarks marks() const;

 private:
  PointerEvent eventFrom(const QMouseEvent& event) const;
  void hover(const QPointF& position);
  bool pressWhilePicking(const QMouseEvent& event);
  void pressFree(const QMouseEvent& event, bool over_cube);
  void setMotionFor(Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers, bool after_release);
  void moveCamera(const glm::dvec2& step);
  void releaseClick(const QMouseEvent& event, bool over_cube);
  bool wheelOfTouchpad(const QWheelEvent& event);
  bool isMovingCamera() const { return drag_ == Drag::kOrbit || drag_ == Drag::kPan || drag_ == Drag::kZoom; }
  bool pressViewStrip(const QMouseEvent& event);

  ViewportWidget& view_;
  TurningCamera& camera_;
  ScenePicks& picks_;
  ToolChain tools_;
  bool tool_active_ = false;
  std::optional<ViewCubeSpot> cube_hover_;
  int view_strip_hover_ = -1;
  QString hover_name_;
  QPointF hover_place_;
  QPointF press_place_, last_place_;
  dvec3 pivot_W_{0.0};
  enum class Drag { kNone, kOrbit, kPan, kZoom, kClick, kBox, kMenu, kCube, kPick, kSection } drag_ = Drag::kNone;
  Qt::MouseButton press_button_ = Qt::NoButton;
  Navigation navigation_ = navigationPreset({});
};

}  // namespace hapticell::app
