// SPDX-License-Identifier: Apache-2.0
#include "app/robot/motion_worker.h"

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "kinematics/closed_form/inverse_factory.h"

namespace hapticell::app {

/// Where the worker's thread gets the cell from; what it asked for last is kept for the next question.
struct MotionWorker::Scene {
  std::shared_ptr<manipulation::SceneService> scenes;
  std::shared_ptr<const manipulation::PreparedScene> prepared;
  config::Configuration configuration;

  std::shared_ptr<const manipulation::PreparedScene> of(const manipulation::SceneSource& seen) {
    return prepared = scenes->prepare(seen);
  }
};

MotionWorker::MotionWorker(Host& host, QObject* parent)
    : QObject(parent),
      host_(host),
      scene_(std::make_shared<Scene>()),
      ways_(std::make_shared<std::atomic<std::uint64_t>>(0)),
      lists_(std::make_shared<std::atomic<std::uint64_t>>(0)) {
  pool_.setMaxThreadCount(1);
  scene_->configuration = host.configuration();
  scene_->scenes = host.scenes();
}

MotionWorker::~MotionWorker() {
  ++*ways_;
  ++*lists_;
  pool_.clear();
  pool_.waitForDone();
}

std::shared_ptr<const manipulation::SceneSource> MotionWorker::snapshot() {
  const workcell::Document& document = host_.documentModel().document();
  if (!last_snapshot_ || last_snapshot_->revision != document.revision())
    last_snapshot_ = std::make_shared<const manipulation::SceneSource>(
        manipulation::sourceOf(document, manipulation::pairDefaults(host_.configuration())));
  return last_snapshot_;
}

void MotionWorker::run(std::function<void()> work) {
  pool_.start(std::move(work));
}

void MotionWorker::checkMotion(workcell::EntityId robot, const std::vector<double>& joints, MotionAnswer answer) {
  run([this, scene = scene_, seen = snapshot(), robot, joints, answer = std::move(answer)] {
    auto motion = manipulation::checkJointMotion(scene->of(*seen), robot, joints, scene->configuration);
    QMetaObject::invokeMethod(
        this, [answer, motion = std::move(motion)] { answer(motion); }, Qt::QueuedConnection);
  });
}

void MotionWorker::checkWays(workcell::EntityId robot, std::vector<std::vector<double>> targets, WayAnswer answer) {
  const std::uint64_t number = ++*ways_;
  for (std::size_t i = 0; i < targets.size(); ++i)
    run([this, scene = scene_, seen = snapshot(), robot, joints = std::move(targets[i]), i, number, current = ways_,
         answer] {
      if (*current != number) return;
      auto motion = manipulation::checkJointMotion(scene->of(*seen), robot, joints, scene->configuration);
      QMetaObject::invokeMethod(
          this,
          [answer, i, number, current, motion = std::move(motion)] {
            if (*current == number) answer(i, motion);
          },
          Qt::QueuedConnection);
    });
}

void MotionWorker::listSolutions(const workcell::Entity& robot, std::vector<double> joints, ListAnswer answer) {
  const std::uint64_t number = ++*lists_;
  run([this, robot, joints = std::move(joints), number, current = lists_, answer = std::move(answer)] {
    if (*current != number) return;
    std::vector<kinematics::ListedSolution> list;
    const int tip = robot.robot()->findLink(robot.jointed().tip_link);
    if (auto inverse = kinematics::createInverse(*robot.robot(), tip, robot.jointed().X_LT)) {
      std::vector<Pose> X_BL;
      kinematics::forwardKinematics(*robot.robot(), joints, X_BL);
      list = kinematics::listSolutions(*robot.robot(), **inverse,
                                       X_BL[static_cast<std::size_t>(tip)] * robot.jointed().X_LT, joints);
    }
    QMetaObject::invokeMethod(
        this,
        [answer, number, current, list = std::move(list)]() mutable {
          if (*current == number) answer(std::move(list));
        },
        Qt::QueuedConnection);
  });
}

void MotionWorker::warmUp() {
  run([scene = scene_, seen = snapshot()] { scene->of(*seen); });
}

}  // namespace hapticell::app
