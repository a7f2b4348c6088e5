// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "kinematics/model/inverse_model.h"
#include "manipulation/checks/joint_check.h"

namespace hapticell::manipulation {

/// One way to bring the tool to a pose that touches nothing.
struct FreeSolution {
  std::vector<double> joints;  ///< One a variable of the robot, within its limits.
  std::string configuration;   ///< "front, elbow up, wrist flipped"; empty where branches have no names.
};

/// All of them for one pose.
struct FreeAnswer {
  /// kSolved: at least one solution within limits exists, free or not.
  kinematics::InverseStatus status = kinematics::InverseStatus::kUnreachable;
  std::vector<FreeSolution> free;  ///< Nearest to the start first.
  std::size_t checked = 0;         ///< Solutions within limits, each checked against the cell.
  bool isFree() const { return !free.empty(); }
};

/// Checks every solution of the inverse model for the tool at X_BT (in the robot's root link). `check` is of the same
/// robot. `q_start` orders the solutions.
FreeAnswer freeSolutions(const kinematics::InverseModel& inverse, JointCheck& check, const Pose& X_BT,
                         const std::vector<double>& q_start, double clearance = 0.0);

struct InverseBatchOptions {
  double clearance = 0.0;          ///< m that solutions keep from the cell.
  std::vector<double> start = {};  ///< Orders the solutions of each pose; empty: the robot's joints in the scene.
  RestContacts at_rest = RestContacts::kLeaveOut;
  bool until_missing = false;      ///< Poses after the first one without a free solution are left out.
  int threads = 0;                 ///< At most so many; 0: one a core.
  /// Once true, no further pose is solved, and the answers are not complete. Null: never.
  const std::atomic<bool>* stop = nullptr;
};

struct InverseBatch {
  std::vector<FreeAnswer> answers;  ///< In the order of the poses.
  std::size_t checked = 0;          ///< Solutions checked against the cell.
  std::size_t free = 0;             ///< Of these, free of contact.
  double seconds = 0.0;             ///< Wall time.
  double cpu_seconds = 0.0;         ///< Of the process, on all cores, meanwhile.
  int threads = 1;
  std::string inverse_model;  ///< InverseModel::name()
  Text note;                  ///< JointCheck::note()
  Text base_contact;          ///< JointCheck::baseContact(): with one, nothing is free.
};

/// The solutions free of contact for many poses X_BT of the robot's tool centre point in its root link, on all cores.
/// The answers do not depend on the number of threads. Errors: no such entity, not a robot, no inverse model, an invalid
/// start.
Expected<InverseBatch> freeInverse(std::shared_ptr<const PreparedScene> scene, workcell::EntityId robot,
                                   std::span<const Pose> poses, const InverseBatchOptions& options,
                                   const config::Configuration& configuration);

/// The inverse model of a robot of the cell to its tool centre point. Errors: not a robot, no such link, a chain that
/// has no inverse model.
Expected<std::unique_ptr<kinematics::InverseModel>> inverseToTool(const workcell::Entity& robot);

}  // namespace hapticell::manipulation
