// SPDX-License-Identifier: Apache-2.0
// The pointer over the viewport: turning, shifting, zooming, picking, the view cube.
#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/viewport/scene/frame_triads.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr double kCubeHalfEdge = 31.0;
constexpr double kClickPixels = 4.0;
constexpr double kSnapPixels = 12.0;
constexpr double kZoomPerStep = 0.85;
constexpr double kZoomPerPixel = 0.992;

glm::dvec2 vec(const QPointF& p) {
  return {p.x(), p.y()};
}

/// The ray comes so near to the sphere about the item's box.
bool passesNear(const RenderItem& item, const Ray& ray_W, double room) {
  const dvec3 to_center = item.X_WM * item.bounds_M.center() - ray_W.origin_W;
  const dvec3 beside = to_center - glm::dot(to_center, ray_W.direction_W) * ray_W.direction_W;
  return glm::length(beside) <= item.bounds_M.radius() + room;
}

/// "robot · link_3"; a mannequin is one person to those who point at it.
QString nameOf(const workcell::Entity* entity, int link) {
  if (!entity) return {};
  const QString name = QString::fromStdString(entity->name);
  if (!entity->robot || entity->figure || link < 0 || static_cast<std::size_t>(link) >= entity->robot->links.size())
    return name;
  return name + QStringLiteral(" · ") +
         QString::fromStdString(entity->robot->links[static_cast<std::size_t>(link)].name);
}

}  // namespace

ViewCube ViewportWidget::viewCube() const {
  return ViewCube({width() - 78.0, 72.0}, kCubeHalfEdge);
}

PointerEvent ViewportWidget::eventFrom(const QMouseEvent& event) const {
  PointerEvent result;
  result.pixel = vec(event.position());
  result.button = event.button();
  result.buttons = event.buttons();
  result.modifiers = event.modifiers();
  result.camera = camera_;
  result.size = viewSize();
  return result;
}

std::optional<PickedPoint> ViewportWidget::pickAt(const QPointF& position) {
  if (!renderer_) return std::nullopt;
  makeCurrent();
  const double ratio = devicePixelRatioF();
  const auto picked = renderer_->pick(static_cast<int>(position.x() * ratio), static_cast<int>(position.y() * ratio));
  doneCurrent();
  return picked;
}

workcell::EntityId ViewportWidget::entityAt(const QPointF& position) {
  if (const auto frame = frameAt(scene_, camera_, viewSize(), vec(position))) return frame;
  const auto picked = pickAt(position);
  return picked ? picked->entity : 0;
}

dvec3 ViewportWidget::pointUnder(const QPointF& position) {
  if (const auto picked = pickAt(position)) return picked->p_WQ;
  // Over the background: the point of the ray at the depth of the target.
  const Ray ray = camera_.rayThrough(vec(position), viewSize());
  const double depth = glm::dot(camera_.target_W - ray.origin_W, camera_.forward_W());
  return ray.origin_W + depth / glm::dot(ray.direction_W, camera_.forward_W()) * ray.direction_W;
}

bool ViewportWidget::pressViewStrip(const QMouseEvent& event) {
  const int cell = event.button() == Qt::LeftButton ? view_strip_.cellAt(event.position()) : -1;
  if (cell < 0) return false;
  const auto index = static_cast<std::size_t>(cell);
  // popup() returns at once: the scene goes on under the menu.
  if (QMenu* menu = view_strip_.cells()[index].menu)
    menu->popup(mapToGlobal((view_strip_.cellBox(index).bottomLeft() + QPointF(0, 2)).toPoint()));
  return true;
}

void ViewportWidget::mousePressEvent(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  last_place_ = event->position();
  if (isMovingCamera()) return setMotionFor(event->buttons(), event->modifiers(), false);  // Another button joins.
  press_place_ = event->position();
  press_button_ = event->button();
  turn_.active = false;
  drag_ = Drag::kNone;
  if (pressViewStrip(*event)) return;
  const bool over_cube = viewCube().pick(vec(event->position()), camera_).has_value();
  if (!over_cube && pressWhilePicking(*event)) return;
  if (!over_cube && tools_.press(eventFrom(*event))) {
    tool_active_ = true;
    update();
    return;
  }
  pressFree(*event, over_cube);
}

void ViewportWidget::pressFree(const QMouseEvent& event, bool over_cube) {
  const bool left = event.button() == Qt::LeftButton;
  pivot_W_ = camera_.target_W;
  if (left && over_cube) {
    drag_ = Drag::kCube;
  } else if (left && section_ &&
             onSectionHandle(*section_, scene_.bounds_W(), camera_, viewSize(), vec(event.position()))) {
    drag_ = Drag::kSection;
  } else if (navigation_.motionFor(event.buttons(), event.modifiers())) {
    pivot_W_ = pointUnder(event.position());
    setMotionFor(event.buttons(), event.modifiers(), false);
    if (!pickAt(event.position()) && drag_ == Drag::kOrbit) pivot_W_ = camera_.target_W;
  } else if (left) {
    drag_ = Drag::kClick;
  } else if (event.button() == Qt::RightButton) {
    drag_ = Drag::kMenu;
  }
}

void ViewportWidget::setMotionFor(Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers, bool after_release) {
  const auto motion = navigation_.motionFor(buttons, modifiers, after_release);
  if (!motion) return;
  drag_ = *motion == ViewMotion::kOrbit ? Drag::kOrbit : *motion == ViewMotion::kPan ? Drag::kPan : Drag::kZoom;
}

void ViewportWidget::moveCamera(const glm::dvec2& step) {
  if (drag_ == Drag::kOrbit) camera_.orbit(step, pivot_W_);
  if (drag_ == Drag::kPan) camera_.pan(step, pivot_W_, viewSize());
  if (drag_ == Drag::kZoom) camera_.zoom(std::pow(kZoomPerPixel, -step.y), pivot_W_);
  emit cameraChanged();
  update();
}

void ViewportWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF step = event->position() - last_place_;
  last_place_ = event->position();
  if (!pick_ && (tool_active_ || event->buttons() == Qt::NoButton) && tools_.move(eventFrom(*event))) {
    hover_name_.clear();
    update();
    return;
  }
  const bool far_enough = (event->position() - press_place_).manhattanLength() > kClickPixels;
  switch (drag_) {
    case Drag::kOrbit:
    case Drag::kPan:
    case Drag::kZoom:
      return moveCamera(vec(step));
    case Drag::kCube:
      if (!far_enough) return;
      camera_.orbit(vec(step), camera_.target_W);
      emit cameraChanged();
      return update();
    case Drag::kSection:
      if (!section_) return;
      setSection(draggedSection(*section_, scene_.bounds_W(), camera_, viewSize(), vec(event->position() - step),
                                vec(event->position())));
      emit sectionMoved();
      return;
    case Drag::kClick:
      if (far_enough) drag_ = Drag::kBox;
      return update();
    case Drag::kBox:
      return update();
    case Drag::kPick:
    case Drag::kMenu:
      return;
    case Drag::kNone:
      hover(event->position());
  }
}

void ViewportWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (tool_active_) {
    // Where it was let go counts, whatever was heard of the way there.
    if (event->position() != std::exchange(last_place_, event->position())) tools_.move(eventFrom(*event));
    tool_active_ = event->buttons() != Qt::NoButton;  // The tool keeps the pointer until the last button is up.
    tools_.release(eventFrom(*event));
    update();
    return;
  }
  if (isMovingCamera() && event->buttons() != Qt::NoButton)
    return setMotionFor(event->buttons(), event->modifiers(), true);
  const bool click = (event->position() - press_place_).manhattanLength() <= kClickPixels;
  if (click) return releaseClick(*event, drag_ == Drag::kCube);
  const Drag drag = std::exchange(drag_, Drag::kNone);
  if (drag != Drag::kBox) return;
  const QPointF end = event->position();
  // As CAD programs have it: from the left all that is inside, from the right all that is touched.
  emit boxed(entitiesIn(QRectF(press_place_, end).normalized(), end.x() < press_place_.x()), event->modifiers());
  update();
}

void ViewportWidget::releaseClick(const QMouseEvent& event, bool over_cube) {
  const Drag drag = std::exchange(drag_, Drag::kNone);
  const QPointF place = event.position();
  if (over_cube) {
    if (const auto spot = viewCube().pick(vec(place), camera_); spot && glm::length(*spot) > 0.0)
      setCamera(camera_.turnedTo(-*spot));
  } else if (drag == Drag::kPick) {
    if (const auto feature = pick_ ? featureAt(place, pick_->filter) : std::nullopt) answerPick(feature);
  } else if (event.button() == Qt::RightButton && press_button_ == Qt::RightButton && drag != Drag::kNone) {
    emit contextMenuWanted(entityAt(place), event.globalPosition().toPoint());
  } else if (event.button() == Qt::LeftButton && press_button_ == Qt::LeftButton && drag != Drag::kNone &&
             drag != Drag::kSection) {
    emit picked(entityAt(place), event.modifiers());
  }
}

void ViewportWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || pick_) return mousePressEvent(event);
  if (const workcell::EntityId entity = entityAt(event->position())) fit(scene_.boundsOf_W(entity));
}

void ViewportWidget::wheelEvent(QWheelEvent* event) {
  const double steps = event->angleDelta().y() / 120.0;
  PointerEvent pointer;
  pointer.pixel = vec(event->position());
  pointer.buttons = event->buttons();
  pointer.modifiers = event->modifiers();
  pointer.wheel_steps = steps;
  pointer.camera = camera_;
  pointer.size = viewSize();
  if (pick_ || !tools_.wheel(pointer)) {
    turn_.active = false;
    if (!wheelOfTouchpad(*event))
      camera_.zoom(std::pow(kZoomPerStep, navigation_.wheel_reversed ? -steps : steps),
                   navigation_.zoom_to_pointer ? pointUnder(event->position()) : camera_.target_W);
    emit cameraChanged();
  }
  event->accept();
  update();
}

/// Two fingers on a touchpad; false where they zoom like a wheel.
bool ViewportWidget::wheelOfTouchpad(const QWheelEvent& event) {
  if (!navigation_.wheel_turns || event.modifiers().testFlag(Qt::ControlModifier)) return false;
  const QPointF delta = event.pixelDelta().isNull() ? QPointF(event.angleDelta()) / 3.0 : QPointF(event.pixelDelta());
  if (event.modifiers().testFlag(Qt::ShiftModifier))
    camera_.pan(vec(delta), camera_.target_W, viewSize());
  else
    camera_.orbit(vec(delta), camera_.target_W);
  return true;
}

bool ViewportWidget::event(QEvent* event) {
  if (event->type() == QEvent::NativeGesture) {
    const auto* gesture = static_cast<QNativeGestureEvent*>(event);
    if (gesture->gestureType() == Qt::ZoomNativeGesture) {
      turn_.active = false;
      camera_.zoom(1.0 / std::max(0.1, 1.0 + gesture->value()), pointUnder(gesture->position()));
      emit cameraChanged();
      update();
      return true;
    }
  }
  return QOpenGLWidget::event(event);
}

void ViewportWidget::hover(const QPointF& position) {
  const auto spot = viewCube().pick(vec(position), camera_);
  if (spot != cube_hover_) {
    cube_hover_ = spot;
    update();
  }
  const int cell = view_strip_.cellAt(position);
  if (cell != view_strip_hover_) {
    view_strip_hover_ = cell;
    update();
  }
  if (pick_) {
    pick_hover_ = spot || cell >= 0 ? std::nullopt : featureAt(position, pick_->filter);
    update();
  }
  const bool beside = spot || cell >= 0;
  const workcell::EntityId frame = beside || pick_ ? 0 : frameAt(scene_, camera_, viewSize(), vec(position));
  const auto seen = beside || frame != 0 ? std::nullopt : pickAt(position);
  const workcell::EntityId entity = seen ? seen->entity : frame;
  const QString name = entity ? nameOf(scene_.find(entity), seen ? seen->link : -1) : QString();
  constexpr double kFar = 60.0;  // Pixels: a name that is left behind comes after.
  if (name != hover_name_ || (!name.isEmpty() && QLineF(position, hover_place_).length() > kFar)) {
    hover_name_ = name;
    hover_place_ = position;
    update();
  }
  scene_.setHovered(entity);
  if (scene_.revision() != drawn_revision_) {
    emit hovered(entity);
    update();
  }
}

std::optional<PickedFeature> ViewportWidget::featureBeside(const QPointF& position,
                                                           const std::vector<workcell::EntityId>& without,
                                                           const FeatureFilter& filter) {
  const Frame frame = makeFrame();
  const Ray ray_W = camera_.rayThrough(vec(position), viewSize());
  std::optional<PickedFeature> nearest;
  double nearest_along = std::numeric_limits<double>::infinity();
  for (const RenderItem& item : frame.items) {
    if (item.entity == 0 || item.ghost != Ghost::kNone || item.over_scene) continue;
    if (std::find(without.begin(), without.end(), item.entity) != without.end()) continue;
    if (!passesNear(item, ray_W, kSnapPixels * camera_.metresPerPixel(item.X_WM * item.bounds_M.center(), viewSize())))
      continue;
    const auto found =
        picker_.pick({&frame.items, item.entity, item.link, camera_, viewSize(), vec(position), filter, section_});
    const double along = found ? glm::dot(found->p_WHit - ray_W.origin_W, ray_W.direction_W) : nearest_along;
    if (along < nearest_along) nearest_along = along, nearest = found;
  }
  return nearest;
}

std::optional<PickedFeature> ViewportWidget::featureAt(const QPointF& position, const FeatureFilter& filter) {
  const auto seen = pickAt(position);
  if (!seen || seen->entity == 0) return std::nullopt;
  const Frame frame = makeFrame();
  return picker_.pick({&frame.items, seen->entity, seen->link, camera_, viewSize(), vec(position), filter, section_});
}

void ViewportWidget::startPick(PickRequest request) {
  cancelPick();
  pick_ = std::move(request);
  setCursor(Qt::CrossCursor);
  setFocus(Qt::OtherFocusReason);
  update();
}

void ViewportWidget::cancelPick() {
  answerPick(std::nullopt);
}

void ViewportWidget::answerPick(const std::optional<PickedFeature>& feature) {
  if (!pick_) return;
  const PickRequest request = std::move(*pick_);
  pick_.reset();
  pick_hover_.reset();
  unsetCursor();
  update();
  if (request.done) request.done(feature);
}

bool ViewportWidget::pressWhilePicking(const QMouseEvent& event) {
  const bool plain = event.button() != Qt::MiddleButton && event.modifiers() == Qt::NoModifier;
  if (!pick_ || (!plain && navigation_.uses(event.button(), event.modifiers()))) return false;
  if (event.button() == Qt::LeftButton) drag_ = Drag::kPick;
  if (event.button() == Qt::RightButton) cancelPick();
  return true;
}

void ViewportWidget::keyPressEvent(QKeyEvent* event) {
  if (pick_ && event->key() == Qt::Key_Escape) return cancelPick();
  QOpenGLWidget::keyPressEvent(event);
}

void ViewportWidget::leaveEvent(QEvent* event) {
  cube_hover_.reset();
  pick_hover_.reset();
  view_strip_hover_ = -1;
  hover_name_.clear();
  scene_.setHovered(0);
  emit hovered(0);
  update();
  QOpenGLWidget::leaveEvent(event);
}

}  // namespace hapticell::app
