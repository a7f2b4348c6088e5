// SPDX-License-Identifier: Apache-2.0
// Inverse solutions that touch nothing, beside a loop of KDL (Levenberg-Marquardt from several starts) and FCL
// (broad-phase manager, exact meshes) on the same poses in the same run. Prints a table of docs/dev/performance.md.
//
// Both take turns every 64 poses, on one thread. Ours lists all solutions and checks each against the cell and the
// robot's own links; the loop checks against the cell only, which is less. All of KDL's starts count, also those that
// fail. What KDL finds is then looked for among ours, and what FCL says of it is held against ours (not timed).
//
// usage: free_inverse_bench [POSES [CELL ROBOT]]      the first robot of the demonstration cell by default; of 5000
// poses and more only ours
#include <algorithm>
#include <array>
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
constexpr double kTurn = 2.0 * std::numbers::pi;
/// Of KDL's search: it weighs a rad as 1e-2 m, so 1e-7 m and 1e-5 rad. With its own, a hundred times as much, it gives
/// some solutions several times.
constexpr double kKdlAccuracy = 1e-7;
/// rad: near the wrist's singularity two solutions of that accuracy are this far apart. Half: some count twice.
constexpr double kSame = 0.02;
/// Poses after which the others have their turn.
constexpr std::size_t kBlock = 64;

Joints randomJoints(const RobotModel& model, std::mt19937& random) {
  Joints q;
  for (const int index : model.moving) {
    const kinematics::Joint& joint = model.joints[static_cast<std::size_t>(index)];
    q.push_back(
        std::uniform_real_distribution<double>(std::max(joint.lower, -kTurn), std::min(joint.upper, kTurn))(random));
  }
  return q;
}

/// The same position of the robot, whatever full turns its joints have made (rad; of a prismatic joint m).
bool isSame(const Joints& a, const Joints& b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](double x, double y) { return std::abs(std::remainder(x - y, kTurn)) < kSame; });
}

/// As somebody would write it who has KDL and FCL: the links that move against what the cell's pairs name; not against
/// each other.
class Loop {
 public:
  Loop(const manipulation::PreparedScene& scene, const workcell::Entity& robot, int tip)
      : robot_(robot), model_(*robot.robot()), chain_(chainOf(model_, tip)), levenberg_(chain_, kKdlAccuracy) {
    const auto pairs = scene.pairsOf(robot.id, robot.contact.on_contact);
    std::vector<geometry::TriangleMesh> standing;
    std::vector<Pose> X_WS;
    for (const manipulation::ScenePart& part : scene.parts()) {
      const workcell::Entity* entity = scene.find(part.entity);
      const auto is_pair = [&](const auto& pair) { return pair.other == part.entity; };
      if (!part.mesh.collider || std::none_of(pairs.begin(), pairs.end(), is_pair)) continue;
      standing.push_back(part.mesh.collider->mesh());
      X_WS.push_back(manipulation::PreparedScene::partPose(*entity, entity->X_WE, entity->joints(), part.link));
    }
    std::vector<geometry::TriangleMesh> links;
    for (const manipulation::ScenePart& part : scene.partsOf(robot.id)) {
      if (!part.mesh.collider || kinematics::variablesOfChain(model_, part.link).empty()) continue;
      const Pose X_WL = manipulation::PreparedScene::partPose(robot, robot.X_WE, robot.joints(), part.link);
      // What stands on something is not checked, as in ours.
      if (FclGroup({part.mesh.collider->mesh()}, standing, X_WS).collides({X_WL})) continue;
      links.push_back(part.mesh.collider->mesh());
      links_.push_back(part.link);
    }
    cell_ = std::make_unique<FclGroup>(links, standing, X_WS);
    X_WL_.resize(links.size());
  }

  /// The distinct solutions within limits from so many starts; the first is the middle of the limits.
  std::vector<Joints> solutions(const Pose& X_BL, int starts, std::mt19937& random) {
    const auto n = static_cast<unsigned>(model_.moving.size());
    KDL::JntArray start(n), q(n);
    std::vector<Joints> found;
    for (int k = 0; k < starts; ++k) {
      const Joints from = k == 0 ? Joints(n, 0.0) : randomJoints(model_, random);
      for (unsigned i = 0; i < n; ++i) {
        const double middle = 0.5 * (jointAt(i).lower + jointAt(i).upper);
        start(i) = k == 0 && std::isfinite(middle) ? middle : from[i];
      }
      if (levenberg_.CartToJnt(start, frameOf(X_BL), q) < 0) continue;
      Joints solution(n);
      bool within = true;
      for (unsigned i = 0; i < n; ++i) within = within && bringWithin(jointAt(i), q(i), solution[i]);
      const auto is_same = [&](const Joints& other) { return isSame(other, solution); };
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

/// What one of the two did.
struct Figures {
  std::size_t solved = 0, checked = 0, free = 0;
  std::vector<double> us = {};  ///< A pose.

  void print(const std::string& who) {
    double sum = 0.0;
    for (const double one : us) sum += one;
    std::sort(us.begin(), us.end());
    const auto at = [&](double share) {
      return us[static_cast<std::size_t>(share * static_cast<double>(us.size() - 1))];
    };
    std::printf("| %s | %zu of %zu | %zu | %zu | %.0f | %.0f / %.0f |\n", who.c_str(), solved, us.size(), checked, free,
                1e6 * static_cast<double>(free) / sum, at(0.5), at(0.99));
  }
};

double microseconds() {
  return 1e3 * threadMilliseconds();
}

/// Both on the same poses.
class Comparison {
 public:
  Comparison(const kinematics::InverseModel& inverse, const manipulation::JointCheck& check, Loop& loop,
             const Pose& X_LT)
      : inverse_(inverse),
        check_(check),
        own_(check.fresh()),
        judge_(check.fresh()),
        loop_(loop),
        X_TL_(X_LT.inverse()) {}

  void run(const std::vector<Pose>& X_BT) {
    for (std::size_t begin = 0; begin < X_BT.size(); begin += kBlock) {
      const std::size_t end = std::min(X_BT.size(), begin + kBlock);
      for (std::size_t i = begin; i < end; ++i) runOurs(own_, X_BT[i]);
      for (std::size_t which = 0; which < kStarts.size(); ++which) {
        for (std::size_t i = begin; i < end; ++i) runLoop(X_BT[i], which);
      }
    }
  }

  void print() {
    std::printf("| who | poses solved | solutions checked | free | free a second | us a pose, median / p99 |\n");
    std::printf("| --- | --- | --- | --- | --- | --- |\n");
    ours_.print("HaptiCell");
    for (std::size_t i = 0; i < kStarts.size(); ++i)
      loops_[i].print("KDL from " + std::to_string(kStarts[i]) + (kStarts[i] == 1 ? " start" : " starts") + ", FCL");
    std::printf("Of KDL's solutions %zu are not among ours; of %zu FCL says otherwise.\n", missing_, otherwise_);
  }

 private:
  /// More find more solutions, and take longer.
  static constexpr std::array<int, 3> kStarts{1, 8, 32};

  void runOurs(manipulation::JointCheck& own, const Pose& X_BT) {
    const double start = microseconds();
    const manipulation::FreeAnswer answer = manipulation::freeSolutions(inverse_, own, X_BT, check_.entity().joints());
    ours_.us.push_back(microseconds() - start);
    ours_.checked += answer.checked;
    ours_.free += answer.free.size();
    ours_.solved += answer.checked > 0 ? 1 : 0;
  }

  void runLoop(const Pose& X_BT, std::size_t which) {
    Figures& figures = loops_[which];
    const double start = microseconds();
    const std::vector<Joints> solutions = loop_.solutions(X_BT * X_TL_, kStarts[which], random_);
    std::vector<bool> free;
    for (const Joints& q : solutions) free.push_back(loop_.isFree(q));
    figures.us.push_back(microseconds() - start);
    figures.checked += solutions.size();
    figures.free += static_cast<std::size_t>(std::count(free.begin(), free.end(), true));
    figures.solved += solutions.empty() ? 0 : 1;
    judge(X_BT, solutions, free);
  }

  void judge(const Pose& X_BT, const std::vector<Joints>& solutions, const std::vector<bool>& free) {
    const auto all = inverse_.solveAll(X_BT, check_.entity().joints());
    for (std::size_t i = 0; i < solutions.size(); ++i) {
      const bool is_there =
          std::any_of(all.begin(), all.end(), [&](const auto& one) { return isSame(one.q, solutions[i]); });
      const bool is_free = judge_.clearance(solutions[i], 1e-3) > 0.0;
      missing_ += is_there ? 0 : 1;
      otherwise_ += is_free == free[i] ? 0 : 1;
    }
  }

  const kinematics::InverseModel& inverse_;
  const manipulation::JointCheck& check_;
  manipulation::JointCheck own_, judge_;
  Loop& loop_;
  Pose X_TL_;
  std::mt19937 random_{2};
  Figures ours_;
  std::array<Figures, kStarts.size()> loops_;
  std::size_t missing_ = 0, otherwise_ = 0;
};

int complain(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 2;
}

int run(int count, const std::string& cell, const std::string& name) {
  Diagnostics notes;
  const auto document = workcell::loadDocument(cell, notes);
  if (!document) return complain(document.error());
  const auto& entities = document->state().entities;
  const auto found = std::find_if(entities.begin(), entities.end(), [&](const auto& one) {
    return name.empty() ? one->kind() == workcell::EntityKind::kRobot : one->name == name;
  });
  const workcell::Entity* robot = found == entities.end() ? nullptr : found->get();
  if (robot == nullptr || !robot->robot()) {
    std::fprintf(stderr, "no such robot in the cell\n");
    return 2;
  }
  const RobotModel& model = *robot->robot();
  const auto scene = manipulation::SceneService().prepare(manipulation::sourceOf(*document, {}));
  const auto check =
      manipulation::JointCheck::create(scene, robot->id, {}, manipulation::RestContacts::kLeaveOut);
  if (!check) return complain(check.error());
  const auto inverse = manipulation::inverseToTool(*robot);
  if (!inverse) return complain(inverse.error());
  const int named = model.findLink(robot->jointed().tip_link), tip = named < 0 ? model.defaultTip() : named;
  std::mt19937 random(1);
  std::vector<Pose> X_BT, X_BL;
  for (int i = 0; i < count; ++i) {
    kinematics::forwardKinematics(model, randomJoints(model, random), X_BL);
    X_BT.push_back(X_BL[static_cast<std::size_t>(tip)] * robot->jointed().X_LT);
  }
  Loop loop(*scene, *robot, tip);
  Comparison comparison(**inverse, *check, loop, robot->jointed().X_LT);
  if (count < 5000) {  // The loops take seconds for a thousand.
    comparison.run(X_BT);
    comparison.print();
  }
  manipulation::InverseBatchOptions options;
  options.threads = 1;
  const auto batch = manipulation::freeInverse(scene, robot->id, X_BT, options, {});
  if (!batch) return complain(batch.error());
  std::printf("Nothing between: freeInverse() on one thread, %.0f free a second.\n",
              static_cast<double>(batch->free) / batch->cpu_seconds);
  return 0;
}

}  // namespace
}  // namespace hapticell::bench

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::max(1, std::atoi(argv[1])) : 2000;
  const std::string cell = argc > 2 ? argv[2] : "config/workcells/demo.hcell";
  return hapticell::bench::run(count, cell, argc > 3 ? argv[3] : "");
}
