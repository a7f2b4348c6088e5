// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "app/viewport/scene/camera.h"
#include "geometry/shapes/pose.h"

namespace hapticell::app {

class Host;

/// Makes the view follow what moves: the tool centre point of the selected robot (the view keeps its direction), or the
/// eyes of the selected mannequin. GUI thread.
class FollowCamera : public QObject {
  Q_OBJECT
 public:
  enum class What { kNothing, kTool, kEyes };
  explicit FollowCamera(Host& host, QObject* parent = nullptr);
  What what() const { return what_; }
  /// Starts to follow; kNothing, or a missing entity, ends it.
  void follow(What what);
  /// True if there is an entity to follow in this way: the selected one, else the first of its kind.
  bool canFollow(What what) const;
  /// Updates the view once; the timer calls it while something is followed.
  void look();

 signals:
  void changed();

 private:
  std::optional<Pose> tool_W() const;
  std::optional<Pose> eyes_W() const;
  Host& host_;
  What what_ = What::kNothing;
  std::optional<Camera> before_;  // To return to.
  std::optional<dvec3> p_WTool_;  // At the last update.
  QTimer timer_;
};

}  // namespace hapticell::app
