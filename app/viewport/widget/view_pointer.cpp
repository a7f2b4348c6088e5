// SPDX-License-Identifier: Apache-2.0
#include "app/viewport/widget/view_pointer.h"

#include <QLineF>
#include <QMenu>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/viewport/scene/frame_triads.h"
#include "app/viewport/widget/scene_picks.h"
#include "app/viewport/widget/turning_camera.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

// Pixels: a hand moves so much in a click. Half: clicks are drags; twice: short drags are clicks.
constexpr double kPointerClickPixels = 4.0;
// Of the distance a step of the wheel: four halve it. Half, twice of the rest: eight steps, or two.
constexpr double kZoomPerStep = 0.85;
// 87 pixels halve the distance. Half, twice of the rest: twice or half as many.
constexpr double kZoomPerPixel = 0.992;

glm::dvec2 vec(const QPointF& p) {
  return {p.x(), p.y()};
}

/// "robot · link_3"; a mannequin is one person to those who point at it.
QString hoverNameOf(const workcell::Entity* entity, int link) {
  if (!entity) return {};
  const QString name = QString::fromStdString(entity->name);
  if (!entity->robot() || entity->figure() || link < 0 ||
      static_cast<std::size_t>(link) >= entity->robot()->links.size())
    return name;
  return name + QStringLiteral(" · ") +
         QString::fromStdString(entity->robot()->links[static_cast<std::size_t>(link)].name);
}

}  // namespace

ViewPointer::ViewPointer(ViewportWidget& view, TurningCamera& camera, ScenePicks& picks)
    : view_(view), camera_(camera), picks_(picks) {}

void ViewPointer::setTool(PointerTool* tool, ToolChain::Place place) {
  tools_.set(place, tool);
  tool_active_ = false;
}

PointerMarks ViewPointer::marks() const {
  PointerMarks marks;
  marks.cube = cube_hover_;
  marks.view_strip_cell = view_strip_hover_;
  if (drag_ == Drag::kBox) {
    marks.box = QRectF(press_place_, last_place_).normalized();
    marks.box_touching = last_place_.x() < press_place_.x();
  }
  if (drag_ == Drag::kNone && !picks_.open()) {
    marks.name = hover_name_;
    marks.name_place = hover_place_;
  }
  return marks;
}

void ViewPointer::pinch(double spread, const QPointF& position) {
  camera_.stop();
  camera_.now.zoom(1.0 / std::max(0.1, 1.0 + spread), picks_.pointUnder(position));
  emit view_.cameraChanged();
  view_.update();
}

PointerEvent ViewPointer::eventFrom(const QMouseEvent& event) const {
  PointerEvent result;
  result.pixel = vec(event.position());
  result.button = event.button();
  result.buttons = event.buttons();
  result.modifiers = event.modifiers();
  result.camera = camera_.now;
  result.size = view_.viewSize();
  return result;
}

bool ViewPointer::pressViewStrip(const QMouseEvent& event) {
  const int cell = event.button() == Qt::LeftButton ? view_.viewStrip().cellAt(event.position()) : -1;
  if (cell < 0) return false;
  const auto index = static_cast<std::size_t>(cell);
  // popup() returns at once: the scene goes on under the menu.
  if (QMenu* menu = view_.viewStrip().cells()[index].menu)
    menu->popup(view_.mapToGlobal((view_.viewStrip().cellBox(index).bottomLeft() + QPointF(0, 2)).toPoint()));
  return true;
}

void ViewPointer::press(QMouseEvent* event) {
  view_.setFocus(Qt::MouseFocusReason);
  last_place_ = event->position();
  if (isMovingCamera()) return setMotionFor(event->buttons(), event->modifiers(), false);  // Another button joins.
  press_place_ = event->position();
  press_button_ = event->button();
  camera_.stop();
  drag_ = Drag::kNone;
  if (pressViewStrip(*event)) return;
  const bool over_cube = view_.viewCube().pick(vec(event->position()), camera_.now).has_value();
  if (!over_cube && pressWhilePicking(*event)) return;
  if (!over_cube && tools_.press(eventFrom(*event))) {
    tool_active_ = true;
    view_.update();
    return;
  }
  pressFree(*event, over_cube);
}

void ViewPointer::pressFree(const QMouseEvent& event, bool over_cube) {
  const bool left = event.button() == Qt::LeftButton;
  pivot_W_ = camera_.now.target_W;
  if (left && over_cube) {
    drag_ = Drag::kCube;
  } else if (left && view_.section() &&
             onSectionHandle(*view_.section(), view_.scene().bounds_W(), camera_.now, view_.viewSize(),
                             vec(event.position()))) {
    drag_ = Drag::kSection;
  } else if (navigation_.motionFor(event.buttons(), event.modifiers())) {
    pivot_W_ = picks_.pointUnder(event.position());
    setMotionFor(event.buttons(), event.modifiers(), false);
    if (!picks_.pickAt(event.position()) && drag_ == Drag::kOrbit) pivot_W_ = camera_.now.target_W;
  } else if (left) {
    drag_ = Drag::kClick;
  } else if (event.button() == Qt::RightButton) {
    drag_ = Drag::kMenu;
  }
}

void ViewPointer::setMotionFor(Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers, bool after_release) {
  const auto motion = navigation_.motionFor(buttons, modifiers, after_release);
  if (!motion) return;
  if (*motion == ViewMotion::kOrbit)
    drag_ = Drag::kOrbit;
  else
    drag_ = *motion == ViewMotion::kPan ? Drag::kPan : Drag::kZoom;
}

void ViewPointer::moveCamera(const glm::dvec2& step) {
  if (drag_ == Drag::kOrbit) camera_.now.orbit(step, pivot_W_);
  if (drag_ == Drag::kPan) camera_.now.pan(step, pivot_W_, view_.viewSize());
  if (drag_ == Drag::kZoom) camera_.now.zoom(std::pow(kZoomPerPixel, -step.y), pivot_W_);
  emit view_.cameraChanged();
  view_.update();
}

void ViewPointer::move(QMouseEvent* event) {
  const QPointF step = event->position() - last_place_;
  last_place_ = event->position();
  if (!picks_.open() && (tool_active_ || event->buttons() == Qt::NoButton) && tools_.move(eventFrom(*event))) {
    hover_name_.clear();
    view_.update();
    return;
  }
  const bool far_enough = (event->position() - press_place_).manhattanLength() > kPointerClickPixels;
  switch (drag_) {
    case Drag::kOrbit:
    case Drag::kPan:
    case Drag::kZoom:
      return moveCamera(vec(step));
    case Drag::kCube:
      if (!far_enough) return;
      camera_.now.orbit(vec(step), camera_.now.target_W);
      emit view_.cameraChanged();
      return view_.update();
    case Drag::kSection:
      if (!view_.section()) return;
      view_.setSection(draggedSection(*view_.section(), view_.scene().bounds_W(), camera_.now, view_.viewSize(),
                                      vec(event->position() - step), vec(event->position())));
      emit view_.sectionMoved();
      return;
    case Drag::kClick:
      if (far_enough) drag_ = Drag::kBox;
      return view_.update();
    case Drag::kBox:
      return view_.update();
    case Drag::kPick:
    case Drag::kMenu:
      return;
    case Drag::kNone:
      hover(event->position());
  }
}

void ViewPointer::release(QMouseEvent* event) {
  if (tool_active_) {
    // Where it was let go counts, whatever was heard of the way there.
    if (event->position() != std::exchange(last_place_, event->position())) tools_.move(eventFrom(*event));
    tool_active_ = event->buttons() != Qt::NoButton;  // The tool keeps the pointer until the last button is up.
    tools_.release(eventFrom(*event));
    view_.update();
    return;
  }
  if (isMovingCamera() && event->buttons() != Qt::NoButton)
    return setMotionFor(event->buttons(), event->modifiers(), true);
  const bool click = (event->position() - press_place_).manhattanLength() <= kPointerClickPixels;
  if (click) return releaseClick(*event, drag_ == Drag::kCube);
  const Drag drag = std::exchange(drag_, Drag::kNone);
  if (drag != Drag::kBox) return;
  const QPointF end = event->position();
  // As CAD programs have it: from the left all that is inside, from the right all that is touched.
  emit view_.boxed(picks_.entitiesIn(QRectF(press_place_, end).normalized(), end.x() < press_place_.x()),
                   event->modifiers());
  view_.update();
}

void ViewPointer::releaseClick(const QMouseEvent& event, bool over_cube) {
  const Drag drag = std::exchange(drag_, Drag::kNone);
  const QPointF place = event.position();
  if (over_cube) {
    if (const auto spot = view_.viewCube().pick(vec(place), camera_.now); spot && glm::length(*spot) > 0.0)
      view_.setCamera(camera_.now.turnedTo(-*spot));
  } else if (drag == Drag::kPick) {
    if (const auto feature = picks_.open() ? picks_.featureAt(place, picks_.open()->filter) : std::nullopt)
      picks_.answer(feature);
  } else if (event.button() == Qt::RightButton && press_button_ == Qt::RightButton && drag != Drag::kNone) {
    emit view_.contextMenuWanted(picks_.entityAt(place), event.globalPosition().toPoint());
  } else if (event.button() == Qt::LeftButton && press_button_ == Qt::LeftButton && drag != Drag::kNone &&
             drag != Drag::kSection) {
    emit view_.picked(picks_.entityAt(place), event.modifiers());
  }
}

void ViewPointer::doubleClick(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || picks_.open()) return press(event);
  if (const workcell::EntityId entity = picks_.entityAt(event->position())) view_.fit(view_.scene().boundsOf_W(entity));
}

void ViewPointer::turnWheel(QWheelEvent* event) {
  const double steps = event->angleDelta().y() / 120.0;
  PointerEvent pointer;
  pointer.pixel = vec(event->position());
  pointer.buttons = event->buttons();
  pointer.modifiers = event->modifiers();
  pointer.wheel_steps = steps;
  pointer.camera = camera_.now;
  pointer.size = view_.viewSize();
  if (picks_.open() || !tools_.wheel(pointer)) {
    camera_.stop();
    if (!wheelOfTouchpad(*event))
      camera_.now.zoom(std::pow(kZoomPerStep, navigation_.wheel_reversed ? -steps : steps),
                       navigation_.zoom_to_pointer ? picks_.pointUnder(event->position()) : camera_.now.target_W);
    emit view_.cameraChanged();
  }
  event->accept();
  view_.update();
}

/// Two fingers on a touchpad; false where they zoom like a wheel.
bool ViewPointer::wheelOfTouchpad(const QWheelEvent& event) {
  if (!navigation_.wheel_turns || event.modifiers().testFlag(Qt::ControlModifier)) return false;
  const QPointF delta = event.pixelDelta().isNull() ? QPointF(event.angleDelta()) / 3.0 : QPointF(event.pixelDelta());
  if (event.modifiers().testFlag(Qt::ShiftModifier))
    camera_.now.pan(vec(delta), camera_.now.target_W, view_.viewSize());
  else
    camera_.now.orbit(vec(delta), camera_.now.target_W);
  return true;
}

void ViewPointer::hover(const QPointF& position) {
  const auto spot = view_.viewCube().pick(vec(position), camera_.now);
  if (spot != cube_hover_) {
    cube_hover_ = spot;
    view_.update();
  }
  const int cell = view_.viewStrip().cellAt(position);
  if (cell != view_strip_hover_) {
    view_strip_hover_ = cell;
    view_.update();
  }
  if (picks_.open()) {
    picks_.hover(spot || cell >= 0 ? std::nullopt : picks_.featureAt(position, picks_.open()->filter));
  }
  const bool beside = spot || cell >= 0;
  const workcell::EntityId frame =
      beside || picks_.open() ? 0 : frameAt(view_.scene(), camera_.now, view_.viewSize(), vec(position));
  const auto seen = beside || frame != 0 ? std::nullopt : picks_.pickAt(position);
  const workcell::EntityId entity = seen ? seen->entity : frame;
  const int link = seen ? seen->link : -1;
  const QString name = entity ? hoverNameOf(view_.scene().find(entity), link) : QString();
  constexpr double kFar = 60.0;  // Pixels: a name that is left behind comes after.
  if (name != hover_name_ || (!name.isEmpty() && QLineF(position, hover_place_).length() > kFar)) {
    hover_name_ = name;
    hover_place_ = position;
    view_.update();
  }
  view_.scene().setHovered(entity);
  if (!view_.shows(view_.scene().revision())) {
    emit view_.hovered(entity);
    view_.update();
  }
}

bool ViewPointer::pressWhilePicking(const QMouseEvent& event) {
  const bool plain = event.button() != Qt::MiddleButton && event.modifiers() == Qt::NoModifier;
  if (!picks_.open() || (!plain && navigation_.uses(event.button(), event.modifiers()))) return false;
  if (event.button() == Qt::LeftButton) drag_ = Drag::kPick;
  if (event.button() == Qt::RightButton) picks_.cancel();
  return true;
}

void ViewPointer::leave() {
  cube_hover_.reset();
  picks_.hover(std::nullopt);
  view_strip_hover_ = -1;
  hover_name_.clear();
  view_.scene().setHovered(0);
  emit view_.hovered(0);
  view_.update();
}

}  // namespace hapticell::app
