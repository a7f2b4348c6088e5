// SPDX-License-Identifier: Apache-2.0
#include "bridge/ros2/checked_motion.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string_view>

#include "bridge/ros2/cell_sources.h"
#include "manipulation/checks/motion_replay.h"
#include "manipulation/checks/path_check.h"
#include "manipulation/scene/scene_service.h"
#include "workcell/format/document_io.h"

namespace hapticell::bridge {

namespace {

using manipulation::PathFinding;
using trajectory::Trajectory;
using JointTrajectory = trajectory_msgs_msg_dds__JointTrajectory_;
using JointPoint = trajectory_msgs_msg_dds__JointTrajectoryPoint_;

double secondsOf(const builtin_interfaces_msg_dds__Duration_& time) {
  return time.sec + 1e-9 * time.nanosec;
}

/// One joint between two points: p(s), s from 0 to 1, with the given speeds at both ends.
struct Cubic {
  double p0, p1, v0, v1, h;

  Cubic(const JointPoint& from, const JointPoint& to, std::uint32_t joint)
      : p0(from.positions._buffer[joint]),
        p1(to.positions._buffer[joint]),
        v0(from.velocities._buffer[joint]),
        v1(to.velocities._buffer[joint]),
        h(secondsOf(to.time_from_start) - secondsOf(from.time_from_start)) {}

  double slope() const { return (p1 - p0) / h; }
  double at(double s) const {
    const double a = s * s * (3.0 - 2.0 * s), b = s * (1.0 - s) * (1.0 - s), c = s * s * (s - 1.0);
    return p0 + a * (p1 - p0) + h * (b * v0 + c * v1);
  }
  double speed(double s) const {
    return v0 + s * (6.0 * slope() - 4.0 * v0 - 2.0 * v1) + s * s * (3.0 * (v0 + v1) - 6.0 * slope());
  }
  double greatestSpeed() const {
    double greatest = std::max(std::abs(v0), std::abs(v1));
    const double linear = 6.0 * slope() - 4.0 * v0 - 2.0 * v1, square = 3.0 * (v0 + v1) - 6.0 * slope();
    const double s = square == 0.0 ? -1.0 : -linear / (2.0 * square);
    if (s > 0.0 && s < 1.0) greatest = std::max(greatest, std::abs(speed(s)));
    return greatest;
  }
  /// Between the curve and the chords of n equal parts lies at most this by n²: an eighth of the greatest second
  /// derivative, which is at one of the ends.
  double bulge() const {
    const double a = std::abs(v0 - slope()), b = std::abs(v1 - slope());
    return h / 8.0 * (4.0 * std::max(a, b) + 2.0 * std::min(a, b));
  }
};

/// Joints of the motion under the names that the robot's own model has.
Trajectory namedByModel(const workcell::Entity& robot, const Trajectory& motion, const std::vector<std::size_t>& columns,
                        double slowed) {
  Trajectory named;
  named.entity = robot.name;
  named.moved = motion.moved;
  const kinematics::RobotModel& model = *robot.robot();
  for (const std::size_t variable : columns)
    named.joint_names.push_back(model.joints[static_cast<std::size_t>(model.moving[variable])].name);
  for (std::size_t i = 0; i < motion.size(); ++i)
    named.addFrame({slowed * (motion[i].t - motion[0].t), motion[i].X_WT}, motion.joints(i));
  return named;
}

struct SampledPath {
  Trajectory path;
  std::vector<std::size_t> points;  ///< The frames at the points of the message.
};

/// A controller's path with at least so many equal parts from point to point.
SampledPath sampledPath(const JointTrajectory& message, int least_parts) {
  // Half: four times the checks' distance saved is nothing against the clearances that are checked, at 1.4 times the
  // time; twice: a thin part's edge is missed by 0.2 mm at an arm's length of 1 m.
  constexpr double kBulge = 1e-4;
  // A polynomial of the third degree is as good as straight in a thousandth of it; half and twice change nothing.
  constexpr double kMostParts = 1000.0;
  SampledPath sampled;
  Trajectory& path = sampled.path;
  path.has_poses = false;
  const std::uint32_t joints = message.joint_names._length;
  for (std::uint32_t j = 0; j < joints; ++j) path.joint_names.emplace_back(message.joint_names._buffer[j]);
  std::vector<double> q(joints);
  for (std::uint32_t i = 0; i < message.points._length; ++i) {
    const JointPoint& point = message.points._buffer[i];
    q.assign(point.positions._buffer, point.positions._buffer + joints);
    sampled.points.push_back(path.size());
    path.addFrame({secondsOf(point.time_from_start), {}}, q);
    if (i + 1 == message.points._length) break;
    std::vector<Cubic> cubics;
    double bulge = 0.0;
    for (std::uint32_t j = 0; j < joints; ++j) {
      cubics.emplace_back(point, message.points._buffer[i + 1], j);
      bulge = std::max(bulge, cubics.back().bulge());
    }
    const auto wanted = static_cast<int>(std::clamp(std::ceil(std::sqrt(bulge / kBulge)), 1.0, kMostParts));
    const int parts = std::max(wanted, least_parts);
    for (int part = 1; part < parts; ++part) {
      const double s = static_cast<double>(part) / parts;
      for (std::uint32_t j = 0; j < joints; ++j) q[j] = cubics[j].at(s);
      path.addFrame({secondsOf(point.time_from_start) + s * cubics.front().h, {}}, q);
    }
  }
  return sampled;
}

/// m/s: never less than the greatest speed of the moved frame on the path whose samples have these poses. Mean speeds
/// from sample to sample are below those in between; how much is bounded by how they bend, which a polynomial of the third
/// degree does evenly from point to point.
double boundOfSpeed(const Trajectory& posed, const std::vector<std::size_t>& points) {
  // By Taylor, an eighth of the second difference for what lies between two places, three eighths for what lies half a
  // part beyond the outermost. Half: links that turn may be faster by a millionth; twice: slower by as much.
  constexpr double kBend = 0.5;
  double greatest = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    std::vector<dvec3> mean;
    for (std::size_t k = points[i]; k < points[i + 1]; ++k)
      mean.push_back((posed[k + 1].X_WT.p - posed[k].X_WT.p) / (posed[k + 1].t - posed[k].t));
    double fastest = 0.0, bend = 0.0;
    for (const dvec3& speed : mean) fastest = std::max(fastest, glm::length(speed));
    for (std::size_t k = 1; k + 1 < mean.size(); ++k)
      bend = std::max(bend, glm::length(mean[k - 1] - 2.0 * mean[k] + mean[k + 1]));
    const auto at_end = [](const dvec3& last, const dvec3& before) { return glm::length(1.5 * last - 0.5 * before); };
    if (mean.size() > 1)
      fastest = std::max({fastest, at_end(mean[0], mean[1]), at_end(mean.back(), mean[mean.size() - 2])});
    greatest = std::max(greatest, fastest + kBend * bend);
  }
  return greatest;
}

/// Of the message as it is; `executed` says what moves.
Expected<double> toolSpeedBound(const workcell::Entity& robot, const JointTrajectory& message, const Trajectory& executed) {
  // Half: the bound is a few times as far above; twice: twice the time, a fraction of the check's.
  constexpr int kLeastParts = 8;
  SampledPath fine = sampledPath(message, kLeastParts);
  fine.path.entity = executed.entity;
  fine.path.moved = executed.moved;
  const auto posed = manipulation::posesFromJoints(robot, fine.path);
  HAPTICELL_TRY(posed);
  return boundOfSpeed(*posed, fine.points);
}

/// Speeds of the message against the limits of the model.
struct SpeedUse {
  double share = 0.0;
  std::string fastest;
  std::vector<Text> unlimited;
};

SpeedUse speedUse(const workcell::Entity& robot, const std::vector<std::size_t>& columns, const std::vector<double>& speeds) {
  SpeedUse use;
  const kinematics::RobotModel& model = *robot.robot();
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const kinematics::Joint& joint = model.joints[static_cast<std::size_t>(model.moving[columns[j]])];
    if (joint.velocity <= 0.0) {
      use.unlimited.emplace_back("the model has no speed limit of joint '%1'; only that of the tool holds", joint.name);
    } else if (speeds[j] / joint.velocity >= use.share) {
      use.share = speeds[j] / joint.velocity;
      use.fastest = joint.name;
    }
  }
  return use;
}

Text findingWords(const PathFinding& finding) {
  const auto at = Text::plain(std::to_string(std::llround(1e3 * finding.t_in)));
  switch (finding.kind) {
    case PathFinding::Kind::kCollision:
      return Text("'%1' meets '%2' %3 ms after the start", finding.first, finding.second, at);
    case PathFinding::Kind::kJointLimit:
      return Text("joint '%1' is beyond its limit %2 ms after the start", finding.first, at);
    default: return Text("joint '%1' is faster than its limit %2 ms after the start", finding.first, at);
  }
}

Expected<void> checkInCell(const workcell::Document& document, const std::string& file, const Trajectory& executed,
                           CheckedMotion& motion) {
  const auto scene = manipulation::SceneService().prepare(manipulation::sourceOf(document, {}));
  manipulation::PathCheckOptions options;
  if (!executed.moved.empty()) {
    auto moved_by = manipulation::parseMovedBy(executed.moved);
    HAPTICELL_TRY(moved_by);
    options.hold.moved_by = std::move(*moved_by);
  }
  const auto checked = manipulation::checkPath(scene, motion.robot, executed, options, {});
  HAPTICELL_TRY(checked);
  for (const PathFinding& finding : checked->findings) {
    const bool is_refused = finding.kind == PathFinding::Kind::kCollision || finding.kind == PathFinding::Kind::kJointLimit ||
                            finding.kind == PathFinding::Kind::kJointSpeed;
    if (is_refused)
      return makeError({.file = file,
                        .found = findingWords(finding),
                        .expected = "a motion without contact, within the limits of the joints",
                        .fix = "Change the motion. 'trajectory check' lists all findings."});
  }
  motion.least_clearance = checked->least_clearance;
  for (const PathFinding& pair : checked->touching_at_start)
    motion.touching_at_start.push_back(pair.first + " / " + pair.second);
  for (const std::string& note : checked->notes) motion.notes.push_back(Text::plain(note));
  return {};
}

/// FNV-1a, 64 bits, over all that a controller gets.
std::string confirmationOf(const JointTrajectory& message, const std::string& action) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&hash](std::uint64_t value) {
    for (int byte = 0; byte < 8; ++byte) hash = (hash ^ ((value >> (8 * byte)) & 0xFF)) * 1099511628211ULL;
  };
  const auto add_text = [&](std::string_view text) {
    add(text.size());
    for (const char c : text) add(static_cast<unsigned char>(c));
  };
  add_text(action);
  for (std::uint32_t j = 0; j < message.joint_names._length; ++j) add_text(message.joint_names._buffer[j]);
  for (std::uint32_t i = 0; i < message.points._length; ++i) {
    const JointPoint& point = message.points._buffer[i];
    add(static_cast<std::uint64_t>(point.time_from_start.sec));
    add(point.time_from_start.nanosec);
    for (std::uint32_t j = 0; j < message.joint_names._length; ++j) {
      add(std::bit_cast<std::uint64_t>(point.positions._buffer[j]));
      add(std::bit_cast<std::uint64_t>(point.velocities._buffer[j]));
    }
  }
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

/// The robot's motion with joints and a base that rests.
Expected<Trajectory> jointMotion(const workcell::Document& document, const workcell::Entity& robot, const std::string& file,
                                 std::vector<Text>& notes) {
  const auto replay = replayOfFile(document, robot, file, notes);
  HAPTICELL_TRY(replay);
  const Trajectory motion = replay->withJoints();
  if (!motion.hasJoints() || motion.size() < 2)
    return makeError({.file = file,
                      .found = "no joints, or fewer than two frames",
                      .expected = "a motion of the robot's joints"});
  const bool moves_base = std::any_of(motion.frames().begin(), motion.frames().end(), [&](const auto& frame) {
    const auto off = trajectory::distanceBetween(replay->at(frame.t).X_WE, robot.X_WE);
    return off.position > 1e-6 || off.angle > 1e-6;
  });
  if (moves_base)
    return makeError(
        {.file = file, .found = "the motion moves the robot's base", .expected = "a motion of its joints alone"});
  return motion;
}

}  // namespace

std::vector<double> greatestSpeeds(const JointTrajectory& message) {
  std::vector<double> greatest(message.joint_names._length, 0.0);
  for (std::uint32_t i = 0; i + 1 < message.points._length; ++i)
    for (std::uint32_t j = 0; j < message.joint_names._length; ++j)
      greatest[j] = std::max(greatest[j], Cubic(message.points._buffer[i], message.points._buffer[i + 1], j).greatestSpeed());
  return greatest;
}

Trajectory executedPath(const JointTrajectory& message) {
  return sampledPath(message, 1).path;
}

Expected<CheckedMotion> checkedMotion(const MotionToSend& wanted) {
  Diagnostics notes;
  const auto document = workcell::loadDocument(wanted.workcell, notes);
  HAPTICELL_TRY(document);
  const auto robot = robotToPublish(*document, wanted.entity, wanted.workcell);
  HAPTICELL_TRY(robot);
  const auto motion = jointMotion(*document, **robot, wanted.motion, notes.warnings);
  HAPTICELL_TRY(motion);
  const auto columns = manipulation::jointColumns(**robot, *motion);
  HAPTICELL_TRY(columns);

  CheckedMotion checked;
  checked.robot = (*robot)->name;
  // Once as it is, to learn how fast it is, and once slowed; rounding of times may ask for a little more.
  Trajectory executed;
  for (int attempt = 0; attempt < 3; ++attempt) {
    const Trajectory named = namedByModel(**robot, *motion, *columns, checked.slowed);
    checked.message = std::make_unique<JointTrajectoryMessage>(named);
    Trajectory path = executedPath(*checked.message->message());
    path.entity = checked.robot;
    path.moved = motion->moved;
    auto posed = manipulation::posesFromJoints(**robot, path);
    HAPTICELL_TRY(posed);
    executed = std::move(*posed);
    executed.has_poses = true;
    const SpeedUse use = speedUse(**robot, *columns, greatestSpeeds(*checked.message->message()));
    checked.joint_share = use.share;
    checked.fastest = use.fastest;
    if (attempt == 0) notes.warnings.insert(notes.warnings.end(), use.unlimited.begin(), use.unlimited.end());
    const auto tool_speed = toolSpeedBound(**robot, *checked.message->message(), executed);
    HAPTICELL_TRY(tool_speed);
    checked.tool_speed = *tool_speed;
    const double excess = std::max(checked.tool_speed / wanted.tool_speed, checked.joint_share / wanted.joint_share);
    if (excess <= 1.0) break;
    checked.slowed *= excess * (1.0 + 1e-6);
  }
  if (checked.tool_speed > wanted.tool_speed || checked.joint_share > wanted.joint_share)
    return makeError({.file = wanted.motion,
                      .found = "the motion could not be slowed to the limits",
                      .expected = "a slower motion"});
  HAPTICELL_TRY(checkInCell(*document, wanted.motion, executed, checked));

  const JointTrajectory& message = *checked.message->message();
  checked.duration = executed.duration();
  const JointPoint& first = message.points._buffer[0];
  checked.start.assign(first.positions._buffer, first.positions._buffer + first.positions._length);
  const kinematics::RobotModel& model = *(*robot)->robot();
  for (const std::size_t variable : *columns)
    checked.is_sliding.push_back(model.joints[static_cast<std::size_t>(model.moving[variable])].type ==
                                 kinematics::JointType::kPrismatic);
  checked.notes.insert(checked.notes.begin(), notes.warnings.begin(), notes.warnings.end());
  checked.confirmation = confirmationOf(message, wanted.action);
  return checked;
}

nlohmann::ordered_json previewOf(const CheckedMotion& motion, const std::string& action) {
  nlohmann::ordered_json json{{"robot", motion.robot},
                              {"action", action},
                              {"points", motion.message->message()->points._length},
                              {"duration", motion.duration},
                              {"slowed", motion.slowed},
                              {"tool_speed", motion.tool_speed},
                              {"joint_share", motion.joint_share},
                              {"fastest_joint", motion.fastest}};
  json["least_clearance"] =
      std::isfinite(motion.least_clearance) ? nlohmann::ordered_json(motion.least_clearance) : nlohmann::ordered_json(nullptr);
  json["touching_at_start"] = motion.touching_at_start;
  json["assumptions"] = nlohmann::ordered_json::array();
  for (const Text& note : motion.notes) json["assumptions"].push_back(english(note));
  json["confirmation"] = motion.confirmation;
  return json;
}

}  // namespace hapticell::bridge
