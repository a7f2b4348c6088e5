// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/reading/program_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace hapticell::trajectory {

namespace {
// m between an arc and its chords: 0.1 mm, about how well robots repeat. Half: 1.4 times the frames; twice: 0.2 mm off.
constexpr double kArcError = 1e-4;
// s between frames, as kLeastTime of editing.cpp. Half, twice: times of moves shorter than it only.
constexpr double kLeastStep = 1e-3;
// m/s and rad/s assumed for a joint move at full speed, as programs do not tell a robot's; our choice. Half: joint
// moves take twice the time; twice: half.
constexpr double kJointLinear = 1.0;
constexpr double kJointAngular = std::numbers::pi;
// Guards memory: hours at 100 Hz. Half, twice: other programs are refused with a message.
constexpr std::size_t kMostTargets = 2'000'000;
// Messages on lines that are listed, what a page shows; the rest is counted. Half, twice: a shorter or longer list.
constexpr std::size_t kMostLineNotes = 20;
// Frames of an arc: a full circle of 80 m radius keeps kArcError. Half: of 20 m; twice: of 320 m.
constexpr std::size_t kMostArcFrames = 2000;

/// A circle through three points.
struct Circle {
  dvec3 center, x, y;  // two axes as long as the radius; the first point is at angle 0
  double via = 0.0, end = 0.0;
  double radius() const { return glm::length(x); }
  dvec3 at(double angle) const { return center + std::cos(angle) * x + std::sin(angle) * y; }
};

std::optional<Circle> circleThrough(const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 u = b - a, v = c - a;
  const dvec3 n = glm::cross(u, v);
  const double nn = glm::dot(n, n);
  if (!(nn > 1e-18 * std::max(1e-12, glm::dot(u, u) * glm::dot(v, v)))) return std::nullopt;
  Circle circle;
  circle.center = a + (glm::dot(u, u) * glm::cross(v, n) - glm::dot(v, v) * glm::cross(u, n)) / (2.0 * nn);
  circle.x = a - circle.center;
  circle.y = glm::cross(n / std::sqrt(nn), circle.x);
  const auto angleOf = [&](const dvec3& p) {
    const double angle = std::atan2(glm::dot(p - circle.center, circle.y), glm::dot(p - circle.center, circle.x));
    return angle <= 0.0 ? angle + 2.0 * std::numbers::pi : angle;
  };
  circle.via = angleOf(b);
  circle.end = angleOf(c);
  return circle;
}

Text lineName(std::size_t line) {
  return Text("line %1", line);
}

}  // namespace

void ProgramPath::setLinearSpeed(double meters_per_second) {
  if (meters_per_second > 0.0 && std::isfinite(meters_per_second)) linear_ = meters_per_second;
}
void ProgramPath::setAngularSpeed(double radians_per_second) {
  if (radians_per_second > 0.0 && std::isfinite(radians_per_second)) angular_ = radians_per_second;
}
void ProgramPath::setJointShare(double share) {
  if (share > 0.0 && std::isfinite(share)) share_ = std::min(share, 1.0);
}

void ProgramPath::setFrame(const std::optional<Pose>& X_BF, const Text& name) {
  X_BF_ = X_BF;
  frame_name_ = X_BF ? Text() : name;
}

/// False where the targets would be in frames whose places to each other nobody knows.
bool ProgramPath::checkFrame(std::size_t line) {
  if (hasFailed()) return false;
  const auto named = [](const Text& name) { return [&name](const auto& frame) { return frame.first == name; }; };
  if (std::none_of(frames_.begin(), frames_.end(), named(frame_name_))) frames_.emplace_back(frame_name_, line);
  if (frames_.size() < 2) return true;
  std::sort(frames_.begin(), frames_.end(),
            [](const auto& a, const auto& b) { return english(a.first) < english(b.first); });
  Text list;
  for (const auto& [name, first] : frames_) {
    const Text one("%1 (%2)", name.empty() ? Text("the robot's base") : name, lineName(first));
    list = list.empty() ? one : Text("%1, %2", list, one);
  }
  fail(line, Text("targets in several frames: %1", list), Text("a single frame, or frames that the file defines"),
       Text("Write the values of the frames into the program, or split the program by frame."));
  return false;
}

double ProgramPath::durationTo(const Pose& X_B, bool is_joint_move) const {
  if (targets_.empty()) return 0.0;
  const PoseDistance way = distanceBetween(targets_.back().X, X_B);
  const double linear = is_joint_move ? kJointLinear * share_ : linear_;
  const double angular = is_joint_move ? kJointAngular * share_ : angular_;
  return std::max({kLeastStep, way.position / linear, way.angle / angular});
}

void ProgramPath::add(std::size_t line, const Pose& X_B, const std::optional<Joints>& joints, bool is_joint_move) {
  if (hasFailed()) return;
  if (!X_B.isValid()) return fail(line, Text("a target that is not finite"), Text("finite numbers"), "");
  if (!missed_.empty()) {
    if (!targets_.empty()) {
      return fail(missed_.front().first, missed_.front().second,
                  Text("a target that the file defines, because moves follow"),
                  options_.forward_kinematics ? Text("Write its value into the program.")
                                              : Text("If the target is given by joints, set the robot (--robot). "
                                                     "Otherwise, write its value into the program."));
    }
    noteMissed();
  }
  if (targets_.size() >= kMostTargets) return fail(line, Text("more than 2 000 000 targets"), Text("fewer"), "");
  targets_.push_back({X_B, joints, durationTo(X_B, is_joint_move), 0.0});
  here_ = X_B;
  joints_ = joints;
}

void ProgramPath::moveTo(std::size_t line, const Pose& X_FT, bool is_joint_move) {
  if (!checkFrame(line)) return;
  add(line, X_BF_ ? *X_BF_ * X_FT : X_FT, {}, is_joint_move);
}

void ProgramPath::moveArc(std::size_t line, const Pose& via_FT, const Pose& end_FT, std::optional<double> angle) {
  if (!checkFrame(line)) return;
  if (!here_) return fail(line, Text("an arc from an unknown position"), Text("a target before the arc"), "");
  const Pose X_BF = X_BF_.value_or(Pose::identity());
  const Pose begin = *here_, via = X_BF * via_FT, end = X_BF * end_FT;
  const auto circle = circleThrough(begin.p, via.p, end.p);
  if (!circle || (!angle && circle->via > circle->end)) {
    return fail(line, Text("an arc with three points on a line or in the wrong order"),
                Text("three points of a circle in order"), "");
  }
  const double whole = angle ? std::abs(*angle) : circle->end;
  if (!(whole > 0.0) || !(whole < 100.0))
    return fail(line, Text("an arc with an angle of zero or of too many turns"),
                Text("an angle above 0, at most 100 rad"), "");
  const double direction = angle && *angle < 0.0 ? -1.0 : 1.0;
  const double step = 2.0 * std::acos(std::clamp(1.0 - kArcError / circle->radius(), 0.0, 1.0));
  const auto piece = [&](double from, double to, bool is_last) {
    const auto count = static_cast<std::size_t>(
        std::clamp(std::ceil((to - from) / std::max(step, 1e-6)), 1.0, static_cast<double>(kMostArcFrames)));
    for (std::size_t i = 1; i <= count; ++i) {
      const double a = from + (to - from) * static_cast<double>(i) / static_cast<double>(count);
      Pose X = interpolate(begin, end, std::min(1.0, a / whole));
      X.p = is_last && i == count && !angle ? end.p : circle->at(direction * a);
      add(line, X, {}, false);
    }
  };
  const bool has_via = circle->via < whole && direction > 0.0;
  if (has_via) piece(0.0, circle->via, false);
  piece(has_via ? circle->via : 0.0, whole, true);
  note(Text("Arcs become frames within 0.1 mm of the arc; the orientation changes evenly from start to end."));
}

void ProgramPath::moveJoints(std::size_t line, const Joints& joints, const std::optional<Pose>& pose) {
  if (hasFailed()) return;
  if (pose) {
    moveTo(line, *pose, true);
    if (!targets_.empty() && !hasFailed()) targets_.back().joints = joints_ = joints;
    return;
  }
  if (options_.forward_kinematics) {
    const std::optional<Pose> X_B = options_.forward_kinematics(joints);
    if (!X_B) return fail(line, Text("a number of joints that differs from the robot's"), Text("six joint values"), "");
    const Text frame = std::exchange(frame_name_, Text());
    if (checkFrame(line)) add(line, *X_B, joints, true);
    frame_name_ = frame;
    return;
  }
  missTarget(line, Text("a target given by joints"));
  joints_ = joints;
}

void ProgramPath::missTarget(std::size_t line, const Text& why) {
  if (hasFailed()) return;
  missed_.emplace_back(line, why);
  here_.reset();
  joints_.reset();
}

void ProgramPath::noteMissed() {
  for (const auto& [line, why] : missed_)
    noteLine(line, targets_.empty() ? Text("left out, because it is before the first known target: %1.", why)
                                    : Text("left out, because it is after the last known target: %1.", why));
  missed_.clear();
}

void ProgramPath::wait(double seconds) {
  if (!targets_.empty() && seconds > 0.0 && std::isfinite(seconds) && missed_.empty()) targets_.back().dwell += seconds;
}

std::optional<Pose> ProgramPath::current() const {
  if (!here_) return std::nullopt;
  return X_BF_ ? X_BF_->inverse() * *here_ : *here_;
}

void ProgramPath::note(const Text& sentence) {
  if (std::find(notes_.begin(), notes_.end(), sentence) == notes_.end()) notes_.push_back(sentence);
}

void ProgramPath::noteLine(std::size_t line, const Text& sentence) {
  const Text text("Line %1: %2", line, sentence);
  if (std::find(notes_.begin(), notes_.end(), text) != notes_.end()) return;
  if (++line_notes_ <= kMostLineNotes) notes_.push_back(text);
}

void ProgramPath::skip(std::size_t line) {
  if (std::find(skipped_.begin(), skipped_.end(), line) == skipped_.end() && skipped_.size() < 10000)
    skipped_.push_back(line);
}

void ProgramPath::fail(std::size_t line, const Text& found, const Text& expected, const Text& fix) {
  if (!error_) error_ = Error{.place = lineName(line), .found = found, .expected = expected, .fix = fix};
}

void ProgramPath::noteLines() {
  if (line_notes_ > kMostLineNotes)
    notes_.push_back(Text("%1 more lines have similar messages.", line_notes_ - kMostLineNotes));
  if (skipped_.empty()) return;
  std::sort(skipped_.begin(), skipped_.end());
  std::string list;
  for (std::size_t i = 0; i < std::min<std::size_t>(skipped_.size(), 12); ++i)
    list += (i == 0 ? "" : ", ") + std::to_string(skipped_[i]);
  notes_.push_back(
      skipped_.size() > 12
          ? Text("Lines without motion are not kept (outputs, waiting for inputs, settings): %1 and %2 more.", list,
                 skipped_.size() - 12)
          : Text("Lines without motion are not kept (outputs, waiting for inputs, settings): %1.", list));
}

Expected<ReadProgram> ProgramPath::finish(const std::string& name) {
  if (error_) return makeError(*error_);
  if (targets_.empty()) {
    if (missed_.empty())
      return makeError({.found = "the program has no moves", .expected = "a program with moves to targets"});
    return makeError({.place = lineName(missed_.front().first),
                      .found = missed_.front().second,
                      .expected = "a target that the file defines",
                      .fix = "If targets are given by joints, set the robot (--robot)."});
  }
  noteMissed();
  noteLines();
  ReadProgram read;
  Trajectory& motion = read.trajectory;
  motion.name = name;
  motion.moved = "tcp";
  const auto has = [](const Target& target) { return target.joints.has_value(); };
  const bool has_joints = std::all_of(targets_.begin(), targets_.end(), has);
  if (has_joints) {
    motion.joint_names = options_.joint_names;
    if (motion.joint_names.size() != 6) motion.joint_names = {"j1", "j2", "j3", "j4", "j5", "j6"};
  } else if (std::any_of(targets_.begin(), targets_.end(), has)) {
    notes_.push_back(Text("Joint values are not kept, because not all targets have them. Poses are kept."));
  }
  motion.reserve(targets_.size());
  double t = 0.0;
  for (const Target& target : targets_) {
    t += target.duration;
    const std::span<const double> joints =
        has_joints ? std::span<const double>(*target.joints) : std::span<const double>();
    motion.addFrame({t, target.X, false, target.dwell}, joints);
    t += target.dwell;
  }
  if (const auto unknown = frames_.begin(); unknown != frames_.end() && !unknown->first.empty())
    notes_.push_back(Text("Poses are relative to %1, which the file does not define.", unknown->first));
  notes_.push_back(
      Text("A program has no times. Linear moves use their programmed speed; joint moves use their share of 1 m/s and "
           "180 deg/s."));
  read.notes = std::move(notes_);
  return read;
}

}  // namespace hapticell::trajectory
