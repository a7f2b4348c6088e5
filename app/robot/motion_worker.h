// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <functional>
#include <memory>

#include "kinematics/model/solution_list.h"
#include "manipulation/checks/joint_motion.h"
#include "manipulation/scene/scene_service.h"

namespace hapticell::app {

class Host;

/// Checks motions of robots in a separate thread, so that the window never waits for the collision engine.
///
/// Each question uses the document at the time of the call; its meshes are prepared once and kept. Answers come in the
/// GUI thread, in the order of the questions.
class MotionWorker : public QObject {
  Q_OBJECT
 public:
  explicit MotionWorker(Host& host, QObject* parent = nullptr);
  ~MotionWorker() override;

  using MotionAnswer = std::function<void(const Expected<manipulation::JointMotion>&)>;
  /// How far the robot can go straight to these joints.
  void checkMotion(workcell::EntityId robot, const std::vector<double>& joints, MotionAnswer answer);

  /// Checks the motions to all of `targets`, one answer each; a new call drops the remaining ones of the call before.
  using WayAnswer = std::function<void(std::size_t index, const Expected<manipulation::JointMotion>&)>;
  void checkWays(workcell::EntityId robot, std::vector<std::vector<double>> targets, WayAnswer answer);
  /// Drops the motions that are still to be checked.
  void dropWays() { ++*ways_; }

  using ListAnswer = std::function<void(std::vector<kinematics::ListedSolution>)>;
  /// Lists all solutions for the tool pose that the robot has at `joints`; a new call drops the one before.
  void listSolutions(const workcell::Entity& robot, std::vector<double> joints, ListAnswer answer);

  /// Prepares the scene in advance.
  void warmUp();

 private:
  struct Scene;
  /// The present document, for a question.
  std::shared_ptr<const manipulation::SceneSource> snapshot();
  void run(std::function<void()> work);

  Host& host_;
  std::shared_ptr<Scene> scene_;
  std::shared_ptr<const manipulation::SceneSource> last_snapshot_;
  std::shared_ptr<std::atomic<std::uint64_t>> ways_, lists_;
  QThreadPool pool_;
};

}  // namespace hapticell::app
