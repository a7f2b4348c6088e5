// SPDX-License-Identifier: Apache-2.0
#include "app/controls/ghost_placer.h"

#include <QMouseEvent>

#include "app/controls/place_fields.h"
#include "app/host/host.h"
#include "app/viewport/widget/floor_point.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

const std::string kGhostOwner = "placed";
// Cosine to the vertical, 45 degrees: a thing would slide from steeper faces. Half: parts are put on walls of 69
// degrees; over 1: always on the floor.
constexpr double kLooksUp = 0.7;

/// Below what was hit: that point itself on a face that looks up, else the floor beside the wall.
dvec3 standingPoint(const PickedFeature& feature) {
  const dvec3& p = feature.p_WHit;
  return feature.nhat_W.z > kLooksUp ? p : dvec3(p.x, p.y, 0.0);
}

}  // namespace

GhostPlacer::GhostPlacer(Host& host, PlaceFields& place, std::function<void()> add, QObject* parent)
    : QObject(parent), host_(host), place_(place), add_(std::move(add)) {}

GhostPlacer::~GhostPlacer() = default;

void GhostPlacer::begin(const workcell::Entity& entity) {
  SceneModel alone;
  alone.setEntities({entity});
  items_ = alone.items({});
  for (RenderItem& item : items_) item.ghost = Ghost::kOwn;
  showAt(p_W_);
  if (on_) return;
  host_.viewport().startPick({{.faces = true, .edges = false, .vertices = false},
                              tr("Click to place it; Esc: cancel"),
                              [this](const std::optional<PickedFeature>& feature) {
                                const bool on = on_;
                                forget();
                                if (feature && on) take(standingPoint(*feature));
                              }});
  on_ = true;
  host_.viewport().installEventFilter(this);
}

void GhostPlacer::end() {
  if (on_) host_.viewport().cancelPick();
}

void GhostPlacer::forget() {
  on_ = false;
  host_.viewport().removeEventFilter(this);
  showAt(std::nullopt);
}

void GhostPlacer::take(const dvec3& p_W) {
  place_.set(p_W);
  add_();
}

std::optional<dvec3> GhostPlacer::pointAt(const QPointF& position) const {
  ViewportWidget& viewport = host_.viewport();
  if (isOverViewControls(viewport, position)) return std::nullopt;
  if (const auto feature = viewport.featureAt(position, {.faces = true, .edges = false, .vertices = false}))
    return standingPoint(*feature);
  return floorPoint(viewport, position);
}

void GhostPlacer::showAt(const std::optional<dvec3>& p_W) {
  p_W_ = p_W;
  std::vector<RenderItem> shown;
  if (p_W) {
    Pose X_WP = place_.X_W();
    X_WP.p = *p_W;
    shown = items_;
    for (RenderItem& item : shown) item.X_WM = X_WP * item.X_WM;
  }
  host_.viewport().scene().setExtras(kGhostOwner, std::move(shown));
  host_.viewport().refresh();
}

bool GhostPlacer::eventFilter(QObject* watched, QEvent* event) {
  const auto* mouse = dynamic_cast<const QMouseEvent*>(event);
  if (event->type() == QEvent::Leave) showAt(std::nullopt);
  if (mouse && event->type() == QEvent::MouseMove && mouse->buttons() == Qt::NoButton)
    showAt(pointAt(mouse->position()));
  if (mouse && event->type() == QEvent::MouseButtonPress) pressed_ = mouse->position();
  if (mouse && endsClick(*mouse, pressed_)) {
    // A face that is clicked answers the pick itself; what is left is the floor.
    if (const auto p_W = pointAt(mouse->position()))
      QMetaObject::invokeMethod(
          this,
          [this, p = *p_W] {
            if (!on_) return;
            end();
            take(p);
          },
          Qt::QueuedConnection);
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace hapticell::app
