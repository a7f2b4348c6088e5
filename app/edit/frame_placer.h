// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "geometry/shapes/pose.h"

namespace hapticell::app {

class Host;

/// "Insert, Frame": draws axes that follow the pointer over the scene, onto corners, edges, faces, other frames, or the
/// floor (z = 0). A click inserts a frame there as one undo step and selects it. Escape, the right button, or another
/// pick ends it. Runs as an open pick of the viewport. GUI thread.
class FramePlacer : public QObject {
 public:
  explicit FramePlacer(Host& host, QObject* parent = nullptr);
  ~FramePlacer() override;
  void begin();
  bool isOn() const { return on_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::optional<Pose> poseAt(const QPointF& position) const;
  void showAt(const std::optional<Pose>& X_WF);
  void forget();
  void insert(const Pose& X_WF);
  Host& host_;
  std::optional<Pose> X_WF_;  ///< Where the axes are shown.
  QPointF pressed_;
  bool on_ = false;
};

}  // namespace hapticell::app
