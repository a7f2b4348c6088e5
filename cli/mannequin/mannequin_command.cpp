// SPDX-License-Identifier: Apache-2.0
#include "cli/mannequin/mannequin_command.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "cli/kit/motion_options.h"
#include "cli/kit/timing.h"
#include "manipulation/checks/hand_targets.h"
#include "mannequin/body/figure.h"
#include "mannequin/body/joint_limits.h"
#include "mannequin/motion/motion_writer.h"
#include "mannequin/motion/retarget.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/posture/posture_file.h"
#include "mannequin/posture/posture_solver.h"
#include "mannequin/posture/support_polygon.h"
#include "mannequin/shape/body_skin.h"

namespace hapticell::cli {

namespace {

using nlohmann::ordered_json;
using namespace mannequin;
using manipulation::HandTargets;
using manipulation::readHandTargets;

struct MannequinOptions {
  std::string sex = "male";
  std::optional<double> percentile, stature, mass;
  std::string posture = "standing";
  bool measure = false;
  std::string targets;
  std::string hands = "both";
  std::vector<std::string> lock;
  bool fail_on_limit = false;
  std::string motion, up, markers;
  std::string output;
};

struct Outcome {
  ordered_json document;
  bool found = false;  ///< What --fail-on-limit looks for.
};

ordered_json figureJson(const Pose& X) {
  return {{"position", {X.p.x, X.p.y, X.p.z}}, {"orientation", {X.q.w, X.q.x, X.q.y, X.q.z}}};
}

ordered_json figureJson(const Posture& posture) {
  return ordered_json::parse(postureText(posture));
}

Expected<Figure> figureFor(const MannequinOptions& options) {
  BodyRequest request;
  if (options.sex != "male" && options.sex != "female") {
    return makeError({.place = "--sex", .found = "'" + options.sex + "'", .expected = "male or female"});
  }
  request.sex = options.sex == "male" ? Sex::kMale : Sex::kFemale;
  if (options.percentile.has_value() == options.stature.has_value()) {
    return makeError({.found = options.stature ? Text("both --percentile and --stature") : Text("no body size"),
                      .expected = "one of --percentile and --stature"});
  }
  if (options.stature) request.stature = *options.stature;
  if (options.percentile) {
    const Expected<double> stature = statureOfPercentile(request.sex, *options.percentile);
    HAPTICELL_TRY(stature);
    request.stature = *stature;
  }
  request.mass = options.mass;
  return makeFigure(request);
}

/// A posture by file or by its name in the library, placed on the floor unless the file says where it is.
Expected<Posture> postureFor(const Figure& figure, const std::string& what) {
  if (const std::optional<Posture> known = libraryPosture(figure, what)) return *known;
  bool has_root = false;
  const Expected<Posture> posture = readPosture(what, &has_root);
  HAPTICELL_TRY(posture);
  return has_root ? *posture : onFloor(figure, *posture);
}

ordered_json jointsOf(const Posture& posture) {
  ordered_json joints = ordered_json::array();
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const DofInfo& info = dofInfo(static_cast<Dof>(i));
    joints.push_back({{"name", info.name},
                      {"joint", info.joint},
                      {"lower", info.lower},
                      {"upper", info.upper},
                      {"comfort_lower", info.comfort_lower},
                      {"comfort_upper", info.comfort_upper},
                      {"coupled", isCoupled(static_cast<Dof>(i))},
                      {"position", posture.angles[i]}});
  }
  return joints;
}

ordered_json segmentsOf(const Figure& figure, const FigurePose& pose) {
  ordered_json segments = ordered_json::array();
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const Segment segment = static_cast<Segment>(i);
    ordered_json entry = figureJson(pose[segment].pose());
    entry["name"] = segmentInfo(segment).name;
    entry["joint"] = segmentInfo(segment).joint;
    entry["mass"] = figure.mass[i];
    segments.push_back(std::move(entry));
  }
  return segments;
}

ordered_json dimensionsOf(const Figure& figure) {
  ordered_json dimensions;
  for (std::size_t i = 0; i < kDimensionCount; ++i) {
    const Dimension dimension = static_cast<Dimension>(i);
    dimensions[std::string(nameOf(dimension))] = {
        {"value", figure.body.values[i]}, {"standard_error", regressionOf(figure.sex, dimension).standard_error}};
  }
  return dimensions;
}

std::array<SegmentPlace, 2> feetOf(const FigurePose& pose) {
  return {pose[Segment::kLeftFoot], pose[Segment::kRightFoot]};
}

void describe(const Figure& figure, const Posture& posture, bool measure, ordered_json& document) {
  const FigurePose pose = forwardKinematics(figure, posture);
  const dvec3 com = centerOfMass(figure, pose);
  document["dof"] = kDofCount;
  document["sex"] = figure.sex == Sex::kMale ? "male" : "female";
  document["percentile"] = percentileOfStature(figure.sex, figure.body[Dimension::kStature]);
  document["mass"] = figure.totalMass();
  document["joints"] = jointsOf(posture);
  ordered_json measures;
  for (const auto& [name, value] : measuresOf(figure)) measures[name] = value;
  document["measures"] = std::move(measures);
  document["center_of_mass"] = cli::toJson(com);
  document["balance_margin"] = supportPolygon(figure, feetOf(pose)).margin(glm::dvec2(com));
  document["hands"] = {{"left", figureJson(handPose(pose, Side::kLeft))},
                       {"right", figureJson(handPose(pose, Side::kRight))}};
  document["root"] = figureJson(posture.X_WR);
  auto& exceeded = document["limits_exceeded"] = ordered_json::array();
  for (const LimitViolation& violation : limitViolations(posture)) exceeded.push_back(english(textOf(violation)));
  if (!measure) return;
  document["dimensions"] = dimensionsOf(figure);
  document["segments"] = segmentsOf(figure, pose);
}

Expected<PostureTask> lockedTask(const MannequinOptions& options) {
  PostureTask task;
  task.may_step = true;
  for (const std::string& lock : options.lock) {
    if (lock == "trunk") {
      task.trunk_locked = true;
    } else if (lock == "pelvis") {
      task.pelvis_locked = true;
    } else if (lock != "feet") {
      return makeError({.place = "--lock", .found = "'" + lock + "'", .expected = "trunk, feet or pelvis"});
    }
    // Who holds trunk or pelvis in place does not walk away either.
    task.may_step = false;
  }
  return task;
}

ordered_json figureJson(const PostureResult& result, const HandTargets& targets) {
  ordered_json hands;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!targets.hands[i]) continue;
    hands[i == 0 ? "left" : "right"] = {{"position_error", result.hand_position_error[i]},
                                        {"orientation_error", result.hand_orientation_error[i]}};
  }
  return {{"step", targets.step},
          {"status", result.status == PostureStatus::kSolved ? "solved" : "unreachable"},
          {"hands", std::move(hands)},
          {"center_of_mass", cli::toJson(result.p_WCom)},
          {"balance_margin", result.balance_margin},
          {"foot_displacement", result.foot_displacement},
          {"posture", figureJson(result.posture)}};
}

/// What can be wrong whether there are targets or not, before anything is computed.
Expected<void> checkWords(const MannequinOptions& options) {
  if (options.hands != "left" && options.hands != "right" && options.hands != "both") {
    return makeError({.place = "--hands", .found = "'" + options.hands + "'", .expected = "left, right or both"});
  }
  HAPTICELL_TRY(lockedTask(options));
  if (options.output.empty()) return {};
  std::error_code ignored;
  const std::filesystem::path file(options.output);
  const bool pipe = std::filesystem::exists(file, ignored) && std::filesystem::is_other(file, ignored);
  const std::string ending = file.extension().string();
  const bool known = ending == ".json" || ending == ".obj" || ending == ".x3d" || ending == ".bvh";
  if (known || pipe) return {};
  return makeError({.file = options.output,
                    .place = "--output",
                    .found = ending.empty() ? Text("no extension") : Text("the extension '%1'", ending),
                    .expected = ".json (the posture), .obj (the body), .x3d (H-Anim) or .bvh (the motion)"});
}

Expected<void> solveTargets(const MannequinOptions& options, const Figure& figure, const Posture& start,
                            Outcome& outcome) {
  Expected<std::vector<HandTargets>> targets = readHandTargets(options.targets);
  HAPTICELL_TRY(targets);
  Expected<PostureTask> task = lockedTask(options);
  HAPTICELL_TRY(task);
  const PostureSolver solver(figure);
  ordered_json results = ordered_json::array();
  Timing timing;
  timing.reserve(targets->size());
  for (HandTargets& wanted : *targets) {
    if (options.hands == "left") wanted.hands[1].reset();
    if (options.hands == "right") wanted.hands[0].reset();
    task->hands = wanted.hands;
    const auto begin = Timing::Clock::now();
    const PostureResult result = solver.solve(*task, start);
    timing.add(begin);
    outcome.found = outcome.found || result.status != PostureStatus::kSolved;
    results.push_back(figureJson(result, wanted));
  }
  outcome.document["results"] = std::move(results);
  outcome.document["timing"] = timing.toJson();
  return {};
}

/// The body in a posture as OBJ text.
std::string bodyText(const Figure& figure, const Posture& posture) {
  const Skin skin = skinOf(figure, posture);
  std::string text = "# HaptiCell mannequin, metres, Z up\n";
  char line[96];
  for (const dvec3& v : skin.mesh.vertices) {
    std::snprintf(line, sizeof line, "v %.5f %.5f %.5f\n", v.x, v.y, v.z);
    text += line;
  }
  for (const geometry::Triangle& t : skin.mesh.triangles) {
    std::snprintf(line, sizeof line, "f %u %u %u\n", t[0] + 1, t[1] + 1, t[2] + 1);
    text += line;
  }
  return text;
}

/// What is written to `file`, by its ending.
std::string textFor(const std::string& file, const Figure& figure, const Posture& posture,
                    const RetargetedMotion& motion) {
  if (file.ends_with(".obj")) return bodyText(figure, posture);
  if (file.ends_with(".x3d")) return hanimText(figure, posture, "mannequin");
  if (file.ends_with(".bvh")) return bvhText(figure, motion.postures, motion.frame_time);
  return postureText(posture);
}

Expected<RetargetedMotion> motionFor(const MannequinOptions& options, const Figure& figure, Outcome& outcome) {
  const Expected<MotionReading> reading = motionReading(options.up, options.markers);
  HAPTICELL_TRY(reading);
  const Expected<RecordedMotion> recorded = readRecordedMotion(options.motion, *reading);
  HAPTICELL_TRY(recorded);
  Expected<RetargetedMotion> motion = retarget(figure, *recorded);
  if (!motion) {
    Error error = motion.error();
    error.file = options.motion;
    return makeError(std::move(error));
  }
  outcome.document["motion"] = {{"frames", motion->postures.size()},
                                {"frame_time", motion->frame_time},
                                {"metres_per_unit", recorded->metres_per_unit},
                                {"frames_beyond_limit", motion->frames_beyond_limit}};
  addReading(*recorded, outcome.document["motion"]);
  addReading(*recorded, outcome.document);
  outcome.found = outcome.found || !motion->frames_beyond_limit.empty();
  return motion;
}

Expected<Outcome> solve(const MannequinOptions& options) {
  HAPTICELL_TRY(checkWords(options));
  const Expected<Figure> figure = figureFor(options);
  HAPTICELL_TRY(figure);
  const Expected<Posture> posture = postureFor(*figure, options.posture);
  HAPTICELL_TRY(posture);
  Outcome outcome;
  describe(*figure, *posture, options.measure, outcome.document);
  outcome.found = !outcome.document["limits_exceeded"].empty();
  if (!options.targets.empty()) {
    const auto solved = solveTargets(options, *figure, *posture, outcome);
    HAPTICELL_TRY(solved);
  }
  RetargetedMotion motion{{*posture}, 1.0, {}};
  if (!options.motion.empty()) {
    Expected<RetargetedMotion> read = motionFor(options, *figure, outcome);
    HAPTICELL_TRY(read);
    motion = std::move(*read);
  }
  if (!options.output.empty()) {
    const auto written = writeFileAtomically(options.output, textFor(options.output, *figure, *posture, motion));
    HAPTICELL_TRY(written);
  }
  return outcome;
}

ExitStatus run(const MannequinOptions& options, const ResultWriter& writer) {
  const auto outcome = solve(options);
  const auto written =
      outcome ? writer.write(outcome->document) : Expected<void>(tl::unexpected<Error>(outcome.error()));
  if (!written) {
    report(written.error());
    return ExitStatus::kBadInput;
  }
  return options.fail_on_limit && outcome->found ? ExitStatus::kCheckFound : ExitStatus::kDone;
}

}  // namespace

void addMannequinCommand(Subcommand app, Action& chosen) {
  Subcommand command = app.add("mannequin", "Compute a mannequin of a given size: measures, postures and reach");
  const auto options = std::make_shared<MannequinOptions>();
  command.option("--sex", options->sex, "male or female").required();
  command.option("--percentile", options->percentile, "Percentile of stature for that sex, 0.1 to 99.9");
  command.option("--stature", options->stature, "Metres, 1.2 to 2.3");
  command.option("--mass", options->mass, "Kilograms (default: the most likely mass)");
  command.option("--posture", options->posture, "Posture file, or a library posture: standing, seated, ...")
      .takes(ValueKind::kJson);
  command.flag("--measure", options->measure, "Also list all body dimensions and segment poses");
  command.option("--targets", options->targets, "CSV hand,x,y,z,qw,qx,qy,qz[,step]: targets of the hands")
      .takes(ValueKind::kTable);
  command.option("--hands", options->hands, "Hands of the targets to use: left, right or both");
  command.option("--lock", options->lock, "Body parts to lock: trunk, feet, pelvis").separatedByCommas();
  command
      .option("--motion", options->motion,
              "Recorded motion for the mannequin: .bvh, .c3d (markers), or .amc with its .asf in the same folder")
      .takes(ValueKind::kFile);
  addMotionReading(command, options->up, options->markers);
  command.flag("--fail-on-limit", options->fail_on_limit, "Exit 1 if a limit is exceeded or a target is not met");
  command
      .option("-o,--output", options->output,
              "Write the posture to this file: .json, .obj (body mesh), .x3d (H-Anim) or .bvh (motion)")
      .takes(ValueKind::kFile);
  command.onChosen([options, &chosen] { chosen = [options](ResultWriter& writer) { return run(*options, writer); }; });
}

}  // namespace hapticell::cli
