// SPDX-License-Identifier: Apache-2.0
// The manipulation step in large cells: what one step costs while a hand leads a robot, or a part, among many.
//
// usage: manipulation_bench [robot] [parts] [few]
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "bench/chain_robot.h"
#include "bench/collision_scenes.h"
#include "bench/thread_clock.h"
#include "manipulation/engine/manipulation_engine.h"
#include "tests/manipulation/session/hand_link.h"

namespace hapticell::bench {
namespace {

using manipulation::test::HandLink;

workcell::Entity solid(workcell::EntityId id, std::shared_ptr<const geometry::TriangleMesh> mesh, const Pose& X_WE) {
  workcell::Entity entity;
  entity.id = id;
  entity.name = "part" + std::to_string(id);
  entity.X_WE = X_WE;
  entity.body = workcell::Solid{std::move(mesh)};
  return entity;
}

constexpr int kSteps = 1500;
constexpr std::chrono::milliseconds kPeriod{2};

std::size_t trianglesOf(const std::vector<workcell::Entity>& entities) {
  std::size_t triangles = 0;
  for (const auto& entity : entities) {
    if (entity.mesh()) triangles += entity.mesh()->triangles.size();
    if (!entity.robot()) continue;
    for (const auto& link : entity.robot()->links) {
      for (const auto& shape : link.collisions) triangles += shape.mesh->triangles.size();
    }
  }
  return triangles;
}

/// Bytes that this program holds in memory now.
double residentBytes() {
  std::ifstream status("/proc/self/statm");
  double all = 0.0, resident = 0.0;
  status >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

struct Cell {
  const char* name;
  std::shared_ptr<const manipulation::PreparedScene> scene;
  std::size_t triangles;
};

Cell prepared(const char* name, std::vector<workcell::Entity> entities) {
  const std::size_t triangles = trianglesOf(entities);
  const double before = residentBytes();
  const auto begin = std::chrono::steady_clock::now();
  Cell cell{name, manipulation::PreparedScene::prepare(std::move(entities), {}, {}), triangles};
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  std::fprintf(stderr, "%s: %zu triangles prepared in %.1f s, %.0f bytes a triangle beside the mesh\n", name, triangles,
               took.count(), (residentBytes() - before) / static_cast<double>(triangles));
  return cell;
}

/// Takes entity 1 and leads it about: circles of 60 mm of the hand, three seconds at 500 steps a second. The search for
/// contacts in the step itself as fast as it goes, or in its own thread, then in real time.
void lead(const Cell& cell, bool in_thread, const dvec3& first_way = dvec3(0.0)) {
  HandLink link;
  manipulation::ManipulationEngine engine(link, {});
  if (in_thread) engine.searchInThread();
  engine.setScene(cell.scene);
  engine.apply(manipulation::command::ChooseEntity{1});
  std::int64_t now = 0;
  std::vector<double> times;
  manipulation::SceneSnapshot snapshot;
  int touching = 0;
  auto due = std::chrono::steady_clock::now();
  for (int i = 0; i < kSteps; ++i) {
    const double t = 0.002 * i, ramp = std::min(1.0, t);
    const dvec3 p =
        ramp * (first_way + 0.06 * dvec3(std::cos(2.0 * t) - 1.0, std::sin(2.0 * t), 0.6 * std::sin(1.3 * t)));
    link.state.X_DS.p = link.state.X_DP.p = p;
    link.state.buttons = i == 10 ? 1 : 0;
    now += 2'000'000;
    const double begin = threadMilliseconds();
    engine.step(now);
    if (i % 17 == 0) engine.fillSnapshot(snapshot);
    if (i > 20) times.push_back(threadMilliseconds() - begin);
    if (!engine.contacts().empty()) ++touching;
    due += kPeriod;
    if (in_thread) std::this_thread::sleep_until(due);
  }
  double sum = 0.0;
  for (const double time : times) sum += time;
  std::sort(times.begin(), times.end());
  std::printf("| %s | %zu | %s | %s | %d of %d | %.3f | %.3f | %.3f | %.0f | %d |\n", cell.name, cell.triangles,
              in_thread ? "its own" : "the step's", engine.held() != nullptr ? "yes" : "no", touching, kSteps,
              times[times.size() / 2], times[times.size() * 99 / 100], times.back(),
              1e3 * static_cast<double>(times.size()) / sum, link.sets);
  std::fflush(stdout);
}

void robotAmongParts() {
  const Chain chain = makeChain(200);
  std::vector<workcell::Entity> entities = {chainRobot(chain)};
  const auto placed = partsAround(chain, 80, 20000);
  const auto mesh = std::make_shared<const geometry::TriangleMesh>(placed.front().mesh);
  for (std::size_t i = 0; i < placed.size(); ++i) entities.push_back(solid(i + 2, mesh, placed[i].X_WP));
  const Cell cell = prepared("7 links x 80 parts", std::move(entities));
  for (const bool in_thread : {false, true}) lead(cell, in_thread);
}

/// A part among others, all different, each of so many triangles; the hand leads it into the one beneath it.
void partAmongMillions(std::size_t triangles) {
  std::vector<workcell::Entity> entities;
  for (int i = 0; i < 20; ++i) {
    const double around = 2.0 * std::numbers::pi * i / 19.0;
    // Each has its own number of triangles; every other one is a scan, without any surface to recognise.
    const int own = static_cast<int>(triangles + triangles / 50 * static_cast<std::size_t>(i));
    const auto mesh = std::make_shared<const geometry::TriangleMesh>(i % 2 == 0 ? cadPart(own) : scanPart(own));
    entities.push_back(solid(static_cast<workcell::EntityId>(i + 1), mesh,
                             {{0.9 * std::cos(around), 0.9 * std::sin(around), 0.02 * i - 0.2},
                              quaternionFromRotationVector({0.3 * i, 0.2, around})}));
  }
  entities[0].X_WE = {};
  entities[1].X_WE = {{0.0, 0.0, -0.26}, dquat(1, 0, 0, 0)};
  const Cell cell = prepared("a part among 19 others", std::move(entities));
  for (const bool in_thread : {false, true}) lead(cell, in_thread, {0.0, 0.0, -0.15});
}

}  // namespace
}  // namespace hapticell::bench

int main(int argc, char** argv) {
  using namespace hapticell::bench;
  std::vector<std::string> wanted(argv + 1, argv + argc);
  if (wanted.empty()) wanted = {"robot", "parts"};
  std::printf(
      "| cell | triangles | thread of the search | held | steps in contact | step, ms of CPU (median) | p99 | max | "
      "steps a second on the mean | sets |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::string& name : wanted) {
    if (name == "robot") robotAmongParts();
    if (name == "parts") partAmongMillions(1000000);
    if (name == "few") partAmongMillions(100000);
  }
  return 0;
}
