// SPDX-License-Identifier: Apache-2.0
// The pointer over the viewport: turning, shifting, zooming, picking, the view cube.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "app/viewport/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr double kCubeHalfEdge = 31.0;
constexpr double kClickPixels = 4.0;
constexpr double kZoomPerStep = 0.85;

glm::dvec2 vec(const QPointF& p) {
  return {p.x(), p.y()};
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
  const auto ask = [&] {
    return renderer_->pick(static_cast<int>(position.x() * ratio), static_cast<int>(position.y() * ratio));
  };
  auto picked = ask();
  if (!picked && sample_ == 0 && band_ > 0) {
    // A still picture has been begun, and this place is not drawn yet.
    Frame frame = makeFrame();
    frame.detail = governor_.level();
    renderer_->draw(frame);
    band_ = 0;
    picked = ask();
  }
  doneCurrent();
  return picked;
}

workcell::EntityId ViewportWidget::entityAt(const QPointF& position) {
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
  press_place_ = last_place_ = event->position();
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
  if (event->button() == Qt::MiddleButton) {
    drag_ = event->modifiers().testFlag(Qt::ShiftModifier) ? Drag::kPan : Drag::kOrbit;
    pivot_W_ = pointUnder(event->position());
    if (!pickAt(event->position())) pivot_W_ = drag_ == Drag::kOrbit ? camera_.target_W : pivot_W_;
  } else if (event->button() == Qt::LeftButton) {
    drag_ = over_cube ? Drag::kCube : Drag::kClick;
    pivot_W_ = camera_.target_W;
    if (section_ && onSectionHandle(*section_, scene_.bounds_W(), camera_, viewSize(), vec(event->position())))
      drag_ = Drag::kSection;
  } else if (event->button() == Qt::RightButton) {
    emit contextMenuWanted(entityAt(event->position()), event->globalPosition().toPoint());
  }
}

void ViewportWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF step = event->position() - last_place_;
  last_place_ = event->position();
  if (!pick_ && (tool_active_ || event->buttons() == Qt::NoButton) && tools_.move(eventFrom(*event))) {
    update();
    return;
  }
  const bool far_enough = (event->position() - press_place_).manhattanLength() > kClickPixels;
  switch (drag_) {
    case Drag::kOrbit:
      camera_.orbit(vec(step), pivot_W_);
      break;
    case Drag::kPan:
      camera_.pan(vec(step), pivot_W_, viewSize());
      break;
    case Drag::kCube:
      if (far_enough) camera_.orbit(vec(step), camera_.target_W);
      break;
    case Drag::kSection:
      if (!section_) return;
      setSection(draggedSection(*section_, scene_.bounds_W(), camera_, viewSize(), vec(event->position() - step),
                                vec(event->position())));
      emit sectionMoved();
      return;
    case Drag::kClick:
    case Drag::kPick:
      return;
    case Drag::kNone:
      hover(event->position());
      return;
  }
  emit cameraChanged();
  update();
}

void ViewportWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (tool_active_) {
    tool_active_ = event->buttons() != Qt::NoButton;  // The tool keeps the pointer until the last button is up.
    tools_.release(eventFrom(*event));
    update();
    return;
  }
  const bool click = (event->position() - press_place_).manhattanLength() <= kClickPixels;
  const Drag drag = drag_;
  drag_ = Drag::kNone;
  if (!click) return;
  if (drag == Drag::kCube) {
    if (const auto spot = viewCube().pick(vec(event->position()), camera_); spot && glm::length(*spot) > 0.0)
      setCamera(camera_.turnedTo(-*spot));
  } else if (drag == Drag::kPick) {
    if (const auto feature = pick_ ? featureAt(event->position(), pick_->filter) : std::nullopt) answerPick(feature);
  } else if (drag == Drag::kClick) {
    emit picked(entityAt(event->position()), event->modifiers());
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
    camera_.zoom(std::pow(kZoomPerStep, steps), pointUnder(event->position()));
    emit cameraChanged();
  }
  event->accept();
  update();
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
  const workcell::EntityId entity = spot || cell >= 0 ? 0 : entityAt(position);
  scene_.setHovered(entity);
  if (scene_.revision() != drawn_revision_) {
    emit hovered(entity);
    update();
  }
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
  if (!pick_ || event.button() == Qt::MiddleButton) return false;
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
  scene_.setHovered(0);
  emit hovered(0);
  update();
  QOpenGLWidget::leaveEvent(event);
}

}  // namespace hapticell::app
