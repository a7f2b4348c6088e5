// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/kit/command_listener.h"
#include "cli/files/file_commands.h"
#include "cli/kit/timing.h"
#include "collision/queries/contact_regions.h"
#include "collision/queries/pose_batch.h"
#include "collision/queries/scene.h"
#include "trajectory/files/pose_csv.h"
#include "workcell/meshes/length_unit.h"
#include "workcell/scenes/whole_mesh.h"

namespace hapticell::cli {

namespace {

using collision::MeshCollider;
using nlohmann::ordered_json;

struct DistanceOptions {
  std::string moving;
  std::vector<std::string> environment;
  std::string poses;
  std::optional<double> safety_zone;
  std::string unit;  ///< Empty: as the file says, metres where it says none.
  bool fail_on_contact = false;
  bool until_contact = false;
  int jobs = 0;
};

/// The colliders in one scene, the moved part first, and how long their trees took.
struct Prepared {
  collision::Scene scene;
  collision::PartIndex moving = 0;
  std::vector<collision::PartIndex> environment;
  double build_ms = 0.0;
};

Expected<std::shared_ptr<const MeshCollider>> readCollider(const std::string& file, std::optional<double> scale,
                                                           double& build_ms) {
  // Not welded: merging corners would shift them by a millionth of the part's size, and the answer with them.
  workcell::ImportOptions options;
  options.metres_per_unit = scale;
  options.weld = false;
  Diagnostics diagnostics;
  const auto mesh = workcell::readWholeMesh(file, options, diagnostics);
  for (const Text& sentence : diagnostics.warnings) warn(sentence);
  HAPTICELL_TRY(mesh);
  const auto begin = Timing::Clock::now();
  auto collider = MeshCollider::build(*mesh);
  build_ms += std::chrono::duration<double, std::milli>(Timing::Clock::now() - begin).count();
  return collider;
}

Expected<std::unique_ptr<Prepared>> prepare(const DistanceOptions& options) {
  const auto unit = workcell::parseLengthUnit(options.unit.empty() ? "m" : options.unit);
  HAPTICELL_TRY(unit);
  if (options.safety_zone && !(*options.safety_zone >= 0.0 && std::isfinite(*options.safety_zone))) {
    return makeError(
        {.place = "--safety-zone", .found = std::to_string(*options.safety_zone), .expected = "metres, 0 or more"});
  }
  auto prepared = std::make_unique<Prepared>();
  const std::optional<double> scale = options.unit.empty() ? std::nullopt : std::optional(workcell::metresPer(*unit));
  const auto moving = readCollider(options.moving, scale, prepared->build_ms);
  HAPTICELL_TRY(moving);
  prepared->moving = prepared->scene.addPart({0, 0}, *moving);
  for (std::size_t i = 0; i < options.environment.size(); ++i) {
    const auto part = readCollider(options.environment[i], scale, prepared->build_ms);
    HAPTICELL_TRY(part);
    prepared->environment.push_back(prepared->scene.addPart({i + 1, 0}, *part));
    prepared->scene.addPair(prepared->moving, prepared->environment.back(), static_cast<std::uint32_t>(i));
  }
  return prepared;
}

std::size_t countContacts(const Prepared& prepared, const Pose& X_WM, double zone) {
  std::size_t contacts = 0;
  const MeshCollider& moving = prepared.scene.collider(prepared.moving);
  for (const collision::PartIndex part : prepared.environment) {
    contacts += collision::countContactRegions(moving, prepared.scene.collider(part), X_WM.inverse(), zone);
  }
  return contacts;
}

ordered_json beyondZone(double zone) {
  return {{"distance", nullptr}, {"distance_at_least", zone},  {"colliding", false},
          {"contained", false},  {"point_on_moving", nullptr}, {"point_on_environment", nullptr},
          {"normal", nullptr},   {"environment", nullptr},     {"contacts", 0}};
}

ordered_json resultOf(const collision::Scene& scene, const collision::PairDistance& nearest) {
  const collision::DistanceResult& result = nearest.result;
  return {{"distance", result.distance},
          {"colliding", result.colliding},
          {"contained", result.contained},
          {"point_on_moving", toJson(result.p_WA)},
          {"point_on_environment", toJson(result.p_WB)},
          {"normal", toJson(result.nhat_BA_W)},
          {"environment", scene.tag(nearest.pair)}};
}

ExitStatus runDistance(const DistanceOptions& options, const ResultWriter& writer) {
  const auto failed = [](const Error& error) {
    report(error);
    return ExitStatus::kBadInput;
  };
  const auto poses = trajectory::readPoseCsv(options.poses);
  if (!poses) return failed(poses.error());
  const auto prepared = prepare(options);
  if (!prepared) return failed(prepared.error());

  const double zone = options.safety_zone.value_or(0.0);
  const double limit =
      options.safety_zone ? std::max(zone, collision::kTouchingDistance) : std::numeric_limits<double>::infinity();
  const collision::Scene& scene = (*prepared)->scene;
  const collision::PoseBatch batch = collision::nearestAtPoses(
      scene, (*prepared)->moving, *poses, {limit, options.until_contact, options.jobs, stopFlag()});
  stopWhereAsked();
  ordered_json results = ordered_json::array();
  Timing timing;
  bool any_contact = false;
  for (std::size_t i = 0; i < batch.nearest.size(); ++i) {
    const auto& nearest = batch.nearest[i];
    const Pose& X_WM = (*poses)[i];
    timing.addMicroseconds(batch.query_us[i]);
    if (!nearest) {
      results.push_back(beyondZone(limit));
      continue;
    }
    results.push_back(resultOf(scene, *nearest));
    const std::size_t regions = nearest->result.distance <= zone ? countContacts(**prepared, X_WM, zone) : 0;
    // A part wholly inside another is one contact though no surface is near.
    results.back()["contacts"] = nearest->result.colliding ? std::max<std::size_t>(regions, 1) : regions;
    any_contact |= nearest->result.colliding;
  }
  ordered_json times = timing.toJson();
  times["build_ms"] = (*prepared)->build_ms;
  times["per_second"] = batch.seconds > 0.0 ? static_cast<double>(batch.nearest.size()) / batch.seconds : 0.0;
  const auto written = writer.write({{"results", std::move(results)}, {"timing", std::move(times)}});
  if (!written) return failed(written.error());
  return any_contact && options.fail_on_contact ? ExitStatus::kCheckFound : ExitStatus::kDone;
}

}  // namespace

void addDistanceCommand(Subcommand app, Action& chosen) {
  Subcommand command =
      app.add("distance", "Compute distance and nearest points of a moving mesh and fixed ones, pose by pose");
  const auto options = std::make_shared<DistanceOptions>();
  command.option("--moving", options->moving, "Moving mesh: STL, OBJ, PLY or OFF").takes(ValueKind::kMesh).required();
  command.option("--environment", options->environment, "Fixed meshes, at identity")
      .takes(ValueKind::kMesh)
      .required()
      .values(1, -1);
  command.option("--poses", options->poses, "CSV with x,y,z,qw,qx,qy,qz: poses of the moving mesh in the world")
      .takes(ValueKind::kTable)
      .required();
  command.option(
      "--safety-zone", options->safety_zone,
      "Largest distance to compute, m; beyond it null and distance_at_least are reported. Counts contacts within it");
  command.option("--unit", options->unit, "Unit of the files: m, mm or in (default: from the files, else m)");
  command.flag("--until-contact", options->until_contact, "End at the first pose that collides");
  command.option("--jobs", options->jobs, "Threads (default: one a core)").withinWhole(1, 4096);
  command.flag("--fail-on-contact", options->fail_on_contact, "Exit 1 if any pose collides");
  command.onChosen(
      [options, &chosen] { chosen = [options](ResultWriter& writer) { return runDistance(*options, writer); }; });
}

}  // namespace hapticell::cli
