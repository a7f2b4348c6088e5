// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "config/configuration.h"
#include "geometry/system/error.h"
#include "geometry/system/text.h"
#include "manipulation/scene/scene_service.h"
#include "planning/plan.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::app {

/// What is planned: the problem without its scene, which is prepared in the background.
struct PathRequest {
  std::shared_ptr<manipulation::SceneService> scenes;
  manipulation::SceneSource source;
  planning::Problem problem;
  config::Configuration configuration;
};

/// The answer; `motion` is set exactly if there is a path, and then it was measured as written to a file.
struct PathAnswer {
  planning::PlanResult result;
  std::optional<trajectory::Trajectory> motion;
  std::vector<trajectory::Trajectory> axes;  ///< Motions of the external axes that move along.
  double clearance = 0.0;  ///< m: the least distance on the written motion.
  Text clearance_place;    ///< Where that is: "at 1.2 s, frame 30"; may be empty.
  std::vector<Text> tight;  ///< Sentences on what begins or ends in contact or nearer than the clearance.
};

/// Plans one path at a time in the background. GUI thread.
class PathPlanner : public QObject {
  Q_OBJECT
 public:
  explicit PathPlanner(QObject* parent = nullptr);
  /// Cancels; the thread ends by itself within milliseconds of its next check.
  ~PathPlanner() override;

  bool isBusy() const { return run_ != nullptr; }
  /// 0 to 1; 0 while nothing is planned.
  double progress() const;
  /// Does nothing while isBusy(). The request's progress and stop are replaced.
  void start(PathRequest request);
  /// Ends the search; ended() still comes.
  void cancel();

 signals:
  void progressed();  ///< Ten times a second while busy.
  void ended(const hapticell::app::PathAnswer& answer);
  void failed(const hapticell::Error& error);

 private:
  struct Run;
  std::shared_ptr<Run> run_;  ///< Null: idle.
  QTimer poll_;
};

}  // namespace hapticell::app
