// SPDX-License-Identifier: Apache-2.0
// Figures of trajectories: smoothing, time-optimal timing, checks of a path, files of hours.
//
// usage: trajectory_bench [smooth] [time] [check] [hours]
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <string>

#include "bench/chain_robot.h"
#include "collision/queries/proximity_query.h"
#include "manipulation/checks/path_check.h"
#include "tests/trajectory/motion/motions.h"
#include "trajectory/editing/simplification.h"
#include "trajectory/editing/smoothing.h"
#include "trajectory/timing/time_optimal.h"
#include "trajectory/files/trajectory_io.h"

namespace hapticell::bench {
namespace {

using trajectory::Trajectory;

/// Of this thread alone, so that other programs' time slices are out.
double milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void smooth() {
  const Trajectory recording = test::recordedGesture(30.0, 1000.0, 0.0003);
  std::vector<double> times;
  trajectory::Smoothed result{recording, {}};
  for (int i = 0; i < 9; ++i) {
    const double begin = milliseconds();
    result = trajectory::smoothed(recording, {});
    times.push_back(milliseconds() - begin);
  }
  double before = 0.0, after = 0.0;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const dvec3 truth = test::gestureAt(recording[i].t).p;
    before += std::pow(glm::distance(recording[i].X_WT.p, truth), 2);
    after += std::pow(glm::distance(result.trajectory[i].X_WT.p, truth), 2);
  }
  const auto& report = result.report;
  std::printf(
      "smoothing 30 s at 1 kHz: median %.1f ms, least %.1f; %.3f mm, %.3f deg; jerk %.1f -> %.3f (/ %.0f); from the "
      "true path rms %.3f -> %.3f mm; %zu spans\n",
      median(times), *std::min_element(times.begin(), times.end()), 1e3 * report.max_deviation.position,
      57.2958 * report.max_deviation.angle, report.rms_jerk_before, report.rms_jerk_after,
      report.rms_jerk_before / report.rms_jerk_after, 1e3 * std::sqrt(before / static_cast<double>(recording.size())),
      1e3 * std::sqrt(after / static_cast<double>(recording.size())), report.spans);
}

trajectory::CubicSpline randomPath(std::mt19937& random, std::size_t points) {
  std::uniform_real_distribution<double> joint(-1.5, 1.5);
  std::vector<double> u, values;
  for (std::size_t i = 0; i < points; ++i) {
    u.push_back(static_cast<double>(i));
    for (int j = 0; j < 6; ++j) values.push_back(joint(random));
  }
  return trajectory::fitSpline({u, values, {}, 6}, u, 1e-9);
}

void timeOptimal() {
  constexpr int kPaths = 10000;
  std::mt19937 random(11);
  trajectory::MotionLimits limits;
  for (int j = 0; j < 6; ++j) {
    limits.velocity.push_back(2.0 + 0.3 * j);
    limits.acceleration.push_back(6.0 + j);
  }
  std::vector<double> times;
  int solved = 0;
  double velocity = 0.0, acceleration = 0.0, longest = 0.0;
  for (int i = 0; i < kPaths; ++i) {
    const auto path = randomPath(random, 4 + static_cast<std::size_t>(i % 47));
    const double begin = milliseconds();
    const auto timing = trajectory::timeOptimal(path, limits);
    times.push_back(milliseconds() - begin);
    if (!timing) continue;
    ++solved;
    // 4000 places of the motion, not those of the grid.
    const auto use = trajectory::limitUse(path, *timing, limits, timing->duration() / 4001.7);
    velocity = std::max(velocity, use.velocity);
    acceleration = std::max(acceleration, use.acceleration);
    if (i % 50 != 0) continue;
    const auto fine = trajectory::timeOptimal(path, limits, {8000});
    if (fine) longest = std::max(longest, timing->duration() / fine->duration() - 1.0);
  }
  std::sort(times.begin(), times.end());
  std::printf(
      "time-optimal, 6 axes, 1000 grid points: %d of %d solved; median %.2f ms, p99 %.2f; limits used %.5f velocity, "
      "%.5f "
      "acceleration; at most %.3f %% longer than on 8000 points (every 50th)\n",
      solved, kPaths, times[times.size() / 2], times[times.size() * 99 / 100], velocity, acceleration, 100.0 * longest);
}

/// What meets at a place of the motion, by name.
std::set<std::string> meetingAt(const manipulation::PreparedScene& scene, const std::vector<double>& joints) {
  std::set<std::string> names;
  const workcell::Entity& robot = *scene.find("robot");
  for (const auto& part : scene.parts()) {
    if (part.entity != robot.id) continue;
    const Pose X_WP = manipulation::PreparedScene::partPose(robot, robot.X_WE, joints, part.link);
    for (const auto& other : scene.parts()) {
      if (other.entity == robot.id) continue;
      const workcell::Entity& entity = *scene.find(other.entity);
      const auto found = collision::distance(part.mesh.collider, X_WP, other.mesh.collider, entity.X_WE, 1e-6);
      if (found.colliding) names.insert(part.name + ":" + entity.name);
    }
  }
  return names;
}

void check() {
  const Chain chain = makeChain(200);
  std::vector<workcell::Entity> entities = {chainRobot(chain)};
  const auto placed = partsAround(chain, 20, 5000);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    workcell::Entity part;
    part.id = i + 2;
    part.name = "part" + std::to_string(part.id);
    part.X_WE = placed[i].X_WP;
    part.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(placed[i].mesh)};
    entities.push_back(std::move(part));
  }
  const auto scene = manipulation::PreparedScene::prepare(entities, {}, {});
  for (const double swing : {0.25, 1.0}) {
    Trajectory motion;
    motion.entity = "robot";
    for (int j = 0; j < 7; ++j) motion.joint_names.push_back("joint" + std::to_string(j));
    const auto jointsAt = [&](double t) {
      std::vector<double> q = entities.front().joints();
      for (std::size_t j = 0; j < q.size(); ++j)
        q[j] += swing * std::sin(0.3 * t * (1.0 + 0.2 * static_cast<double>(j)));
      return q;
    };
    for (int i = 0; i <= 1000; ++i) motion.addFrame({0.01 * i, {}}, jointsAt(0.01 * i));
    manipulation::PathCheckOptions options;
    options.pose_tolerance = 1e9;
    std::vector<double> times;
    Expected<manipulation::PathCheckResult> result = tl::unexpected(Error{});
    for (int i = 0; i < 5; ++i) {
      const double begin = milliseconds();
      result = manipulation::checkPath(scene, "robot", motion, options, {});
      times.push_back(milliseconds() - begin);
    }
    if (!result) {
      std::printf("check: %s\n", result.error().message().c_str());
      return;
    }
    int missed = 0, meeting = 0;
    const double begin = milliseconds();
    for (int i = 0; i <= 10000; ++i) {
      const double t = 0.001 * i;
      for (const std::string& pair : meetingAt(*scene, motion.jointsAt(t))) {
        ++meeting;
        const auto covers = [&](const manipulation::PathFinding& f) {
          const std::string name = f.first.substr(f.first.find('/') + 1) + ":" + f.second;
          return f.kind == manipulation::PathFinding::Kind::kCollision && name == pair && t > f.t_in - 0.02 &&
                 t < f.t_out + 0.02;
        };
        const bool found = std::any_of(result->findings.begin(), result->findings.end(), covers) ||
                           std::any_of(result->touching_at_start.begin(), result->touching_at_start.end(), covers);
        missed += found ? 0 : 1;
      }
    }
    const double brute = milliseconds() - begin;
    std::printf(
        "check of 10 s, 1001 frames, seven links among 20 parts, swing %.2f rad: median %.1f ms, least %.1f; %zu "
        "findings, "
        "least gap %.1f mm; brute force at 10 001 places: %d meetings, %d missed (%.0f ms)\n",
        swing, median(times), *std::min_element(times.begin(), times.end()), result->findings.size(),
        1e3 * result->least_clearance, meeting, missed, brute);
  }
}

/// Ten hours at 100 Hz, written, read back, thinned.
void hours() {
  const Trajectory recording = test::recordedGesture(36000.0, 100.0, 0.0003);
  const auto file = std::filesystem::temp_directory_path() / "trajectory_bench_hours.csv";
  double begin = milliseconds();
  {
    std::ofstream stream(file, std::ios::binary);
    stream << trajectory::toCsvText(recording);
  }
  const double written = milliseconds() - begin;
  begin = milliseconds();
  const auto read = trajectory::readTrajectory(file);
  const double reading = milliseconds() - begin;
  const bool same = read && read->size() == recording.size() && (*read)[1234567].X_WT.p == recording[1234567].X_WT.p;
  begin = milliseconds();
  const Trajectory few = trajectory::simplified(recording, {});
  const double thinning = milliseconds() - begin;
  std::printf(
      "ten hours at 100 Hz: %zu frames, %.0f MB as CSV; written in %.1f s, read in %.1f s (%s), simplified to %zu "
      "frames in "
      "%.1f s\n",
      recording.size(), 1e-6 * static_cast<double>(std::filesystem::file_size(file)), 1e-3 * written, 1e-3 * reading,
      same ? "the same" : "NOT THE SAME", few.size(), 1e-3 * thinning);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace hapticell::bench

int main(int argc, char** argv) {
  std::set<std::string> wanted(argv + 1, argv + argc);
  const auto is = [&](const char* name) { return wanted.empty() || wanted.contains(name); };
  if (is("smooth")) hapticell::bench::smooth();
  if (is("time")) hapticell::bench::timeOptimal();
  if (is("check")) hapticell::bench::check();
  if (is("hours")) hapticell::bench::hours();
  return 0;
}
