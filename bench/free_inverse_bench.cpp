// SPDX-License-Identifier: Apache-2.0
// Inverse solutions that touch nothing, beside a loop of KDL (Levenberg-Marquardt from several starts) and FCL
// (broad-phase manager, exact meshes) on the same poses in the same run. Prints a table of docs/dev/performance.md.
//
// usage: free_inverse_bench [POSES [CELL ROBOT]]      the first robot of the demonstration cell by default
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <kdl/chainiksolverpos_lma.hpp>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "bench/fcl_peer.h"
#include "bench/kdl_chain.h"
#include "bench/thread_clock.h"
#include "manipulation/checks/inverse_batch.h"
#include "manipulation/scene/scene_service.h"
#include "workcell/format/document_io.h"

namespace hapticell::bench {
namespace {

using kinematics::RobotModel;
using Joints = std::vector<double>;
/// Starts of KDL's search, the first in the middle of the limits: more find more solutions, and take longer.
constexpr int kStarts = 8;

Joints randomJoints(const RobotModel& model, std::mt19937& random) {
  Joints q;
  for (const int index : model.moving) {
    const kinematics::Joint& joint = model.joints[static_cast<std::size_t>(index)];
    const double turn = 2.0 * std::numbers::pi;
    q.push_back(std::uniform_real_distribution<double>(std::max(joint.lower, -turn), std::min(joint.upper, turn))(random));
  }
  return q;
}

/// As somebody would write it who has KDL and FCL: the links that move against all else; not against each other.
class Loop {
 public:
  Loop(const manipulation::PreparedScene& scene, const workcell::Entity& robot, int tip)
      : robot_(robot), model_(*robot.robot()), chain_(chainOf(model_, tip)), levenberg_(chain_) {
    std::vector<geometry::TriangleMesh> standing;
    std::vector<Pose> X_WS;
    for (const manipulation::ScenePart& part : scene.parts()) {
      const workcell::Entity* entity = scene.find(part.entity);
      if (part.entity == robot.id || !entity->checked || !part.mesh.collider) continue;
      standing.push_back(part.mesh.collider->mesh());
      X_WS.push_back(manipulation::PreparedScene::partPose(*entity, entity->X_WE, entity->joints(), part.link));
    }
    std::vector<geometry::TriangleMesh> links;
    for (const manipulation::ScenePart& part : scene.partsOf(robot.id)) {
      const Pose X_WL = manipulation::PreparedScene::partPose(robot, robot.X_WE, robot.joints(), part.link);
      // What stands on something is not checked, as in ours.
      if (FclGroup({part.mesh.collider->mesh()}, standing, X_WS).collides({X_WL})) continue;
      links.push_back(part.mesh.collider->mesh());
      links_.push_back(part.link);
    }
    cell_ = std::make_unique<FclGroup>(links, standing, X_WS);
    X_WL_.resize(links.size());
  }

  /// The distinct solutions within limits from all starts.
  std::vector<Joints> solutions(const Pose& X_BL, std::mt19937& random) {
    const auto n = static_cast<unsigned>(model_.moving.size());
    KDL::JntArray start(n), q(n);
    std::vector<Joints> found;
    for (int k = 0; k < kStarts; ++k) {
      const Joints from = randomJoints(model_, random);
      for (unsigned i = 0; i < n; ++i) {
        const kinematics::Joint& joint = jointAt(i);
        start(i) = k == 0 ? 0.5 * (joint.lower + joint.upper) : from[i];
      }
      if (levenberg_.CartToJnt(start, frameOf(X_BL), q) < 0) continue;
      Joints solution(n);
      bool within = true;
      for (unsigned i = 0; i < n; ++i) within = within && bringWithin(jointAt(i), q(i), solution[i]);
      const auto is_same = [&](const Joints& other) {
        return std::equal(other.begin(), other.end(), solution.begin(),
                          [](double a, double b) { return std::abs(a - b) < 1e-3; });
      };
      if (within && std::none_of(found.begin(), found.end(), is_same)) found.push_back(solution);
    }
    return found;
  }

  bool isFree(const Joints& q) {
    kinematics::forwardKinematics(model_, q, X_BL_);
    for (std::size_t i = 0; i < links_.size(); ++i) X_WL_[i] = robot_.X_WE * X_BL_[static_cast<std::size_t>(links_[i])];
    return !cell_->collides(X_WL_);
  }

 private:
  const kinematics::Joint& jointAt(unsigned i) const {
    return model_.joints[static_cast<std::size_t>(model_.moving[i])];
  }
  /// By full turns, as an angle out of a search may be any number of them off.
  static bool bringWithin(const kinematics::Joint& joint, double q, double& within) {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    within = q;
    if (joint.type == kinematics::JointType::kRevolute && std::isfinite(joint.lower))
      within -= kTurn * std::floor((q - joint.lower) / kTurn);
    return within >= joint.lower && within <= joint.upper;
  }

  const workcell::Entity& robot_;
  const RobotModel& model_;
  KDL::Chain chain_;
  KDL::ChainIkSolverPos_LMA levenberg_;
  std::vector<int> links_;
  std::unique_ptr<FclGroup> cell_;
  std::vector<Pose> X_WL_, X_BL_;
};

void print(const char* who, std::size_t checked, std::size_t free, std::size_t solved, std::size_t poses, double s) {
  std::printf("| %s | %zu of %zu | %zu | %zu | %.3f | %.0f | %.0f |\n", who, solved, poses, checked, free, s,
              static_cast<double>(free) / s, static_cast<double>(poses) / s);
}

int run(int count, const std::string& cell, const std::string& name) {
  Diagnostics notes;
  const auto document = workcell::loadDocument(cell, notes);
  const auto complain = [](const Error& error) {
    std::fprintf(stderr, "%s\n", error.message().c_str());
    return 2;
  };
  if (!document) return complain(document.error());
  const auto& entities = document->state().entities;
  const auto robot = std::find_if(entities.begin(), entities.end(), [&](const workcell::Entity& one) {
    return name.empty() ? one.kind() == workcell::EntityKind::kRobot : one.name == name;
  });
  if (robot == entities.end() || !robot->robot()) {
    std::fprintf(stderr, "no such robot in the cell\n");
    return 2;
  }
  const RobotModel& model = *robot->robot();
  const auto scene = manipulation::SceneService().prepare(manipulation::sourceOf(*document, {}));
  const int named = model.findLink(robot->jointed().tip_link), tip = named < 0 ? model.defaultTip() : named;
  const Pose X_LT = robot->jointed().X_LT;
  std::mt19937 random(1);
  std::vector<Pose> X_BT, X_BL;
  for (int i = 0; i < count; ++i) {
    kinematics::forwardKinematics(model, randomJoints(model, random), X_BL);
    X_BT.push_back(X_BL[static_cast<std::size_t>(tip)] * X_LT);
  }
  std::printf("| who | poses solved | solutions checked | free | processor time, s | free a second | poses a second |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- |\n");
  manipulation::InverseBatchOptions options;
  options.threads = 1;
  for (int turn = 0; turn < 2; ++turn) {
    const auto batch = manipulation::freeInverse(scene, robot->id, X_BT, options, {});
    if (!batch) return complain(batch.error());
    const auto solved = std::count_if(batch->answers.begin(), batch->answers.end(),
                                      [](const auto& one) { return one.checked > 0; });
    print(turn == 0 ? "HaptiCell, first" : "HaptiCell", batch->checked, batch->free, static_cast<std::size_t>(solved),
          X_BT.size(), batch->cpu_seconds);
  }
  Loop loop(*scene, *robot, tip);
  std::size_t checked = 0, free = 0, solved = 0;
  const double begin = threadMilliseconds();
  for (const Pose& X : X_BT) {
    const std::vector<Joints> solutions = loop.solutions(X * X_LT.inverse(), random);
    checked += solutions.size();
    solved += solutions.empty() ? 0 : 1;
    free += static_cast<std::size_t>(
        std::count_if(solutions.begin(), solutions.end(), [&](const Joints& q) { return loop.isFree(q); }));
  }
  print("KDL and FCL", checked, free, solved, X_BT.size(), 1e-3 * (threadMilliseconds() - begin));
  return 0;
}

}  // namespace
}  // namespace hapticell::bench

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::max(1, std::atoi(argv[1])) : 1000;
  const std::string cell = argc > 2 ? argv[2] : "config/workcells/demo.hcell";
  return hapticell::bench::run(count, cell, argc > 3 ? argv[3] : "");
}
