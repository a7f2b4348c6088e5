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

/// A new entity before it is added, as a ghost in the scene: it stands on the face under the pointer where that looks
/// up, else on the floor (z = 0), turned as the fields say. A click gives the place to the fields and adds it; Escape,
/// the right button, or another pick ends it. An open pick of the viewport all the while. GUI thread.
class GhostPlacer : public QObject {
 public:
  /// `add` adds the thing where `place` says; it is called once a click.
  GhostPlacer(Host& host, PlaceFields& place, std::function<void()> add, QObject* parent);
  ~GhostPlacer() override;
  /// Begins with it, or shows it in place of what is shown. Its X_WE counts from the point and turn of the fields.
  void begin(const workcell::Entity& entity);
  /// Nothing is added; nothing where it is not on.
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
  std::vector<RenderItem> items_;  ///< From the point and turn of the fields.
  std::optional<dvec3> p_W_;       ///< Where it is shown.
  QPointF pressed_;
  bool on_ = false;
};

}  // namespace hapticell::app
