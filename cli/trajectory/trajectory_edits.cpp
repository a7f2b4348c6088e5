// SPDX-License-Identifier: Apache-2.0
#include "cli/trajectory/trajectory_edits.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

#include "cli/kit/kept_result.h"
#include "cli/trajectory/motion_file.h"
#include "cli/trajectory/tool_poses.h"
#include "manipulation/checks/motion_replay.h"
#include "trajectory/checks/motion_promises.h"
#include "trajectory/editing/editing.h"
#include "trajectory/editing/simplification.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/format/document_io.h"

namespace hapticell::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using trajectory::Trajectory;

/// The files of an edit; `with`: the motions that follow, `rest`: the one for what comes after a split.
struct EditFiles {
  std::string file, output, rest, workcell, robot;
  std::vector<std::string> with;
};

struct EditOptions {
  EditFiles files;
  std::string name, plane = "y";
  double from = -1e300, to = 1e300, at = 0.0, offset = 0.0, speed = 0.1, reach = 0.5, seconds = 0.0, length = 0.05,
         step = 0.01;
  std::size_t frame = 0, place = 0, first = 0, last = 0;
  std::vector<double> pose, direction{0.0, 0.0, -1.0};
  bool allow_miss = false, is_resampled = false;
};

using Made = Expected<std::vector<Trajectory>>;
using Edit = Made (*)(const Trajectory&, const EditOptions&);

Made one(Expected<Trajectory> made) {
  HAPTICELL_TRY(made);
  return std::vector<Trajectory>{std::move(*made)};
}

Expected<Pose> poseOf(const std::vector<double>& v) {
  const dquat q = v.size() == 7 ? dquat(v[3], v[4], v[5], v[6]) : dquat(0.0, 0.0, 0.0, 0.0);
  if (v.size() != 7 || !(std::abs(glm::length(q) - 1.0) < 1e-3)) {
    return makeError({.place = "--pose",
                      .found = Text("%1 numbers, or not a unit quaternion", v.size()),
                      .expected = "x,y,z,qw,qx,qy,qz"});
  }
  return Pose{{v[0], v[1], v[2]}, glm::normalize(q)};
}

Made trim(const Trajectory& given, const EditOptions& o) {
  return one(trajectory::trimmed(given, o.from, o.to));
}
Made split(const Trajectory& given, const EditOptions& o) {
  auto parts = trajectory::splitAt(given, o.at);
  HAPTICELL_TRY(parts);
  return std::vector<Trajectory>{std::move(parts->first), std::move(parts->second)};
}
Made join(const Trajectory& given, const EditOptions& o) {
  std::vector<Trajectory> parts{given};
  for (const std::string& file : o.files.with) {
    auto part = readMotionFile(file);
    HAPTICELL_TRY(part);
    parts.push_back(std::move(*part));
  }
  return one(trajectory::joined(parts, o.speed));
}
Made reverse(const Trajectory& given, const EditOptions&) {
  return std::vector<Trajectory>{trajectory::reversed(given)};
}
Made mirror(const Trajectory& given, const EditOptions& o) {
  const auto axis = std::string("xyz").find(o.plane);
  if (o.plane.size() != 1 || axis == std::string::npos) {
    return makeError({.place = "--plane", .found = "'" + o.plane + "'", .expected = "x, y or z: the plane's normal"});
  }
  dvec3 normal(0.0);
  normal[static_cast<int>(axis)] = 1.0;
  return std::vector<Trajectory>{trajectory::mirrored(given, o.offset * normal, normal)};
}
Made insert(const Trajectory& given, const EditOptions& o) {
  if (given.empty()) return makeError({.place = "frames", .found = "none", .expected = "a motion"});
  auto pose = o.pose.empty() ? Expected<Pose>(given.poseAt(o.at)) : poseOf(o.pose);
  return pose ? one(trajectory::withFrame(given, o.at, *pose)) : Made(tl::unexpected(pose.error()));
}
Made move(const Trajectory& given, const EditOptions& o) {
  const auto pose = poseOf(o.pose);
  return pose ? one(trajectory::withFrameAt(given, o.frame, *pose, o.reach)) : Made(tl::unexpected(pose.error()));
}
Made remove(const Trajectory& given, const EditOptions& o) {
  return one(trajectory::withoutFrames(given, o.first, o.last));
}
Made dwell(const Trajectory& given, const EditOptions& o) {
  return one(trajectory::withDwell(given, o.frame, o.seconds));
}
Made namePoint(const Trajectory& given, const EditOptions& o) {
  return one(trajectory::withName(given, o.frame, o.name));
}
Made reorderPoints(const Trajectory& given, const EditOptions& o) {
  return one(trajectory::withFrameMoved(given, o.frame, o.place));
}
Expected<trajectory::StraightWay> wayOf(const EditOptions& o) {
  if (o.direction.size() != 3)
    return makeError({.place = "--direction", .found = Text("%1 numbers", o.direction.size()), .expected = "x,y,z"});
  return trajectory::StraightWay{o.length, {o.direction[0], o.direction[1], o.direction[2]}, o.speed};
}
Made approach(const Trajectory& given, const EditOptions& o) {
  const auto way = wayOf(o);
  return way ? one(trajectory::withApproach(given, *way)) : Made(tl::unexpected(way.error()));
}
Made retract(const Trajectory& given, const EditOptions& o) {
  const auto way = wayOf(o);
  return way ? one(trajectory::withRetract(given, *way)) : Made(tl::unexpected(way.error()));
}
Made resample(const Trajectory& given, const EditOptions& o) {
  return one(trajectory::resampled(given, o.step));
}

/// The joints of a robot's motion whose poses were changed, found again in the cell; without the robot there are no
/// joints.
Expected<void> findJoints(const Trajectory& given, const EditOptions& options, Trajectory& made, ordered_json& result) {
  if (!given.hasJoints() || made.hasJoints()) return {};
  if (options.files.workcell.empty()) {
    result["notes"].push_back(
        "The joints belong to the old poses and are dropped. Use --workcell to compute them again.");
    return {};
  }
  Diagnostics notes;
  const auto document = workcell::loadDocument(options.files.workcell, notes);
  HAPTICELL_TRY(document);
  const workcell::Entity* entity = document->findByName(given.entity);
  std::vector<double> start;
  if (entity != nullptr) {
    const auto columns = manipulation::jointColumns(*entity, given);
    HAPTICELL_TRY(columns);
    start = entity->joints();
    for (std::size_t j = 0; j < columns->size(); ++j) start[(*columns)[j]] = given.joints(0)[j];
  }
  const auto replay = manipulation::MotionReplay::create(document->state().entities, given.entity,
                                                         std::make_shared<const Trajectory>(made), start);
  HAPTICELL_TRY(replay);
  made = replay->withJoints();
  result["off_pose"] = {{"position", replay->offPose().position}, {"angle", replay->offPose().angle}};
  return {};
}

/// Frames between given ones have poses that are not quite those of their joints: with the robot they are.
Expected<void> poseByJoints(const Trajectory& given, const EditOptions& options, Trajectory& made,
                            ordered_json& result) {
  const auto apart =
      std::count_if(made.frames().begin(), made.frames().end(), [](const auto& frame) { return frame.is_pose_apart; });
  if (apart == 0 || !made.hasJoints() || !made.has_poses) return {};
  if (!options.files.robot.empty()) {
    const auto tool = ToolPoses::create(options.files.robot, given);
    HAPTICELL_TRY(tool);
    if (tool->match()) {
      made = tool->posesOf(made);
      return {};
    }
  }
  result["notes"].push_back("Poses and joints do not agree in " + std::to_string(apart) +
                            " frames (marked pose_apart). To make them agree, use resample --robot.");
  return {};
}

/// A resampled motion lies on the given one: read back and measured before it is kept.
Expected<void> save(const Trajectory& given, const Trajectory& made, const EditOptions& options,
                    const std::string& path, ordered_json& result) {
  if (!options.is_resampled || !options.files.robot.empty()) return saveTrajectory(made, path);
  const std::string extension = fs::path(path).extension().string();
  if (!path.empty() && extension != ".csv" && extension != ".htraj" && extension != ".json")
    return saveTrajectory(made, path);
  const std::string text = extension == ".csv" ? toCsvText(made) : toJsonText(made);
  return writeKept(
      path, text, path.empty() ? ".htraj" : extension, options.allow_miss,
      [&](const fs::path& written) { return trajectory_checks::resamplePromises(given, written); }, result);
}

Expected<ordered_json> run(const EditOptions& options, Edit edit) {
  const auto given = readMotionFile(options.files.file);
  HAPTICELL_TRY(given);
  auto made = edit(*given, options);
  HAPTICELL_TRY(made);
  ordered_json result{{"frames_before", given->size()}, {"duration_before", given->duration()}};
  for (std::size_t i = 0; i < made->size(); ++i) {
    Trajectory& motion = (*made)[i];
    if (!given->has_poses && !motion.hasJoints()) {
      return makeError({.file = options.files.file,
                        .place = "poses",
                        .found = "joint values without poses",
                        .expected = "poses, because this edit changes them",
                        .fix = "First export it with poses: trajectory export --to csv --robot."});
    }
    HAPTICELL_TRY(findJoints(*given, options, motion, result));
    const std::string& path = i == 0 ? options.files.output : options.files.rest;
    HAPTICELL_TRY(poseByJoints(*given, options, motion, result));
    HAPTICELL_TRY(save(*given, motion, options, path, result));
    result["motions"].push_back({{"file", path},
                                 {"frames", motion.size()},
                                 {"duration", motion.duration()},
                                 {"joints", motion.joint_names.size()}});
  }
  return result;
}

}  // namespace

Expected<void> saveTrajectory(const Trajectory& trajectory, const std::string& path) {
  if (path.empty()) return {};
  const std::string extension = fs::path(path).extension().string();
  if (extension == ".csv") return writeFileAtomically(path, toCsvText(trajectory));
  if (extension == ".htraj" || extension == ".json") return writeFileAtomically(path, toJsonText(trajectory));
  return makeError({.file = path,
                    .place = "--output",
                    .found = Text("the extension '%1'", extension),
                    .expected = ".htraj, .json or .csv",
                    .fix = "Use trajectory export for other formats."});
}

ExitStatus finishTrajectory(const ResultWriter& writer, const Expected<ordered_json>& result) {
  const auto failed = [](const Error& error) {
    report(error);
    return ExitStatus::kBadInput;
  };
  if (!result) return failed(result.error());
  if (const auto written = writer.write(*result); !written) return failed(written.error());
  return result->value("found", false) ? ExitStatus::kCheckFound : ExitStatus::kDone;
}

void addTrajectoryEdits(Subcommand command, Action& chosen) {
  const auto options = std::make_shared<EditOptions>();
  const auto add = [&](const char* name, const char* description, Edit edit) {
    Subcommand sub = command.add(name, description);
    sub.option("file", options->files.file, "Trajectory: .htraj, .csv, .json, .yaml (ROS)")
        .takes(ValueKind::kMotion)
        .required();
    sub.option("-o,--output", options->files.output, "Copy to write: .htraj, .json or .csv").takes(ValueKind::kMotion);
    sub.option("--workcell", options->files.workcell, "Cell in which a robot's joints are computed again")
        .takes(ValueKind::kWorkcell);
    sub.onChosen([options, &chosen, edit] {
      options->is_resampled = edit == static_cast<Edit>(resample);
      chosen = [options, edit](ResultWriter& writer) { return finishTrajectory(writer, run(*options, edit)); };
    });
    return sub;
  };
  Subcommand sub = add("trim", "Keep a range", trim);
  sub.option("--from", options->from, "s");
  sub.option("--to", options->to, "s");
  sub = add("split", "Split at a time", split);
  sub.option("--at", options->at, "s").required();
  sub.option("--rest", options->files.rest, "File for the part after it").takes(ValueKind::kMotion);
  sub = add("join", "Join motions end to end", join);
  sub.option("--with", options->files.with, "Motions that follow").takes(ValueKind::kMotion).required();
  sub.option("--speed", options->speed, "Speed from the end of one to the next, m/s (0.1)");
  add("reverse", "Reverse in time", reverse);
  sub = add("mirror", "Mirror at a plane", mirror);
  sub.option("--plane", options->plane, "Normal of the plane: x, y (default) or z");
  sub.option("--offset", options->offset, "Offset of the plane along its normal, m");
  sub = add("insert", "Insert a frame", insert);
  sub.option("--at", options->at, "s").required();
  sub.option("--pose", options->pose, "x,y,z,qw,qx,qy,qz (default: the pose at that time)").separatedByCommas();
  sub = add("move", "Move a frame and blend its neighbours", move);
  sub.option("--frame", options->frame, "Number of the frame, from 0").required();
  sub.option("--pose", options->pose, "x,y,z,qw,qx,qy,qz").separatedByCommas().required();
  sub.option("--reach", options->reach, "Time within which frames follow, s (0.5)");
  sub = add("delete", "Delete frames", remove);
  sub.option("--first", options->first, "From 0").required();
  sub.option("--last", options->last, "From 0").required();
  sub = add("dwell", "Dwell at a frame", dwell);
  sub.option("--frame", options->frame, "Number of the frame, from 0").required();
  sub.option("--seconds", options->seconds, "Dwell time, s; 0 passes through").required();
  sub = add("name", "Name a point", namePoint);
  sub.option("--frame", options->frame, "Number of the frame, from 0").required();
  sub.option("--name", options->name, "Name, unique in the motion (default: none)");
  sub = add("reorder", "Move a point to another place in the order", reorderPoints);
  sub.option("--frame", options->frame, "Number of the frame, from 0").required();
  sub.option("--to", options->place, "New number, from 0").required();
  for (const auto& [way, edit] :
       {std::pair<const char*, Edit>("approach", approach), std::pair<const char*, Edit>("retract", retract)}) {
    sub = add(way, "Add a straight move before or after it", edit);
    sub.option("--length", options->length, "m (0.05)");
    sub.option("--direction", options->direction, "x,y,z in the moved frame (0,0,-1)").separatedByCommas();
    sub.option("--speed", options->speed, "m/s (0.1)");
  }
  sub = add("resample", "Resample in even steps, times as recorded", resample);
  sub.option("--step", options->step, "s (0.01)");
  sub.option("--robot", options->files.robot, "Robot of the joints, to compute the poses").takes(ValueKind::kRobot);
  addAllowMiss(sub, options->allow_miss);
}

}  // namespace hapticell::cli
