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

/// What the pointer's position and drag show over the scene.
struct PointerMarks {
  std::optional<ViewCubeSpot> cube;
  int view_strip_cell = -1;   ///< -1: none.
  std::optional<QRectF> box;  ///< Selection box of the mouse: selects what is inside,
  bool box_touching = false;  ///< or what it touches.
  QString name;               ///< What the pointer is over; empty: nothing, or during a drag.
  QPointF name_place;
};

/// The pointer over the viewport: it turns, pans and zooms the camera, picks, and drags the view cube and the section
/// plane; tools are served before all of these. GUI thread.
class ViewPointer {
 public:
  /// All must outlive it.
  ViewPointer(ViewportWidget& view, TurningCamera& camera, ScenePicks& picks);

  void press(QMouseEvent* event);
  void move(QMouseEvent* event);
  void release(QMouseEvent* event);
  void doubleClick(QMouseEvent* event);
  void turnWheel(QWheelEvent* event);
  /// Two fingers on a touchpad spread by this fraction of their distance.
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
