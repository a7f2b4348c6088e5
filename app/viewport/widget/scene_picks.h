// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointF>
#include <QRectF>
#include <optional>
#include <vector>

#include "app/viewport/drawing/scene_renderer.h"
#include "app/viewport/tools/feature_picker.h"
#include "app/viewport/tools/pick_request.h"

namespace hapticell::app {

class ViewPicture;
class ViewportWidget;

/// What is at a point or in a box of the viewport, and the pick of a face, an edge or a corner that a dialog asked for.
/// Points in pixels at 100 %; GUI thread.
class ScenePicks {
 public:
  /// Both must outlive it.
  ScenePicks(ViewportWidget& view, ViewPicture& picture) : view_(view), picture_(picture) {}

  std::optional<PickedPoint> pickAt(const QPointF& position);
  /// The entity at a point; frames are preferred to parts; 0: none.
  workcell::EntityId entityAt(const QPointF& position);
  /// The point of the scene under the pointer; over the background, the point at the depth of the camera's target.
  dvec3 pointUnder(const QPointF& position);
  /// See ViewportWidget.
  std::optional<PickedFeature> featureAt(const QPointF& position, const FeatureFilter& filter);
  std::optional<PickedFeature> featureNear(const QPointF& position, const std::vector<workcell::EntityId>& without,
                                           const FeatureFilter& filter);
  std::vector<workcell::EntityId> entitiesIn(const QRectF& box, bool touching);

  /// Starts a pick; an open pick is first answered with an empty result.
  void start(PickRequest request);
  void cancel();
  /// Answers the open pick; does nothing without one.
  void answer(const std::optional<PickedFeature>& feature);
  const std::optional<PickRequest>& open() const { return open_; }
  /// Shows what a click would pick now.
  void hover(const std::optional<PickedFeature>& feature);
  const std::optional<PickedFeature>& hovered() const { return hovered_; }

 private:
  ViewportWidget& view_;
  ViewPicture& picture_;
  FeaturePicker picker_;
  std::optional<PickRequest> open_;
  std::optional<PickedFeature> hovered_;
};

}  // namespace hapticell::app
