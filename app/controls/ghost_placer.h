// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointF>
#include <functional>
#include <optional>
#include <vector>

#include "app/viewport/tools/picked_feature.h"
#include "app/viewport/scene/render_item.h"

namespace hapticell::app {

class Host;
class PlaceFields;

/// Shows a new entity as a ghost in the scene before it is added: on the face under the pointer if that looks up, else
/// on the floor (z = 0), turned as the fields say. A click copies the point to the fields and adds the entity; Escape,
/// the right button, or another pick ends it. Runs as an open pick of the viewport. GUI thread.
class GhostPlacer : public QObject {
 public:
  /// `add` adds the entity at the pose that `place` gives; it is called once per click.
  GhostPlacer(Host& host, PlaceFields& place, std::function<void()> add, QObject* parent);
  ~GhostPlacer() override;
  /// Starts with this entity, or replaces the shown one. Its X_WE is relative to the point and turn of the fields.
  void begin(const workcell::Entity& entity);
  /// Ends without adding anything. Does nothing if no ghost is shown.
  void end();
  bool isOn() const { return on_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::optional<dvec3> pointAt(const QPointF& position) const;
  void showAt(const std::optional<dvec3>& p_W);
  void forget();
  void take(const dvec3& p_W);
  Host& host_;
  PlaceFields& place_;
  std::function<void()> add_;
  std::vector<RenderItem> items_;  ///< Relative to the point and turn of the fields.
  std::optional<dvec3> p_W_;       ///< Where the ghost is shown.
  QPointF pressed_;
  bool on_ = false;
};

}  // namespace hapticell::app
