// SPDX-License-Identifier: Apache-2.0
// The manipulation step in large cells: what one step costs while a hand leads a robot, or a part, among many.
//
// usage: manipulation_bench [robot] [parts]
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "bench/chain_robot.h"
#include "bench/collision_scenes.h"
#include "manipulation/manipulation_step.h"
#include "tests/manipulation/hand_link.h"

namespace hapticell::bench {
namespace {

using manipulation::test::HandLink;

/// Of this thread alone, so that other programs' time slices are out.
double cpuMilliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

workcell::Entity solid(workcell::EntityId id, std::shared_ptr<const geometry::TriangleMesh> mesh, const Pose& X_WE) {
  workcell::Entity entity;
  entity.id = id;
  entity.name = "part" + std::to_string(id);
  entity.X_WE = X_WE;
  entity.mesh = std::move(mesh);
  return entity;
}

constexpr int kSteps = 1500;

/// Takes entity 1 and leads it about: circles of 60 mm of the hand, three seconds at 500 steps a second.
void lead(const char* name, std::vector<workcell::Entity> entities) {
  std::size_t triangles = 0;
  for (const auto& entity : entities) {
    if (entity.mesh) triangles += entity.mesh->triangles.size();
    if (!entity.robot) continue;
    for (const auto& link : entity.robot->links) {
      for (const auto& shape : link.collisions) triangles += shape.mesh->triangles.size();
    }
  }
  HandLink link;
  manipulation::ManipulationEngine engine(link, {});
  const double before = cpuMilliseconds();
  engine.apply(manipulation::command::SetDocument{std::move(entities), {}});
  const double preparation = cpuMilliseconds() - before;
  engine.apply(manipulation::command::ChooseEntity{1});
  std::int64_t now = 0;
  std::vector<double> times;
  manipulation::SceneSnapshot snapshot;
  for (int i = 0; i < kSteps; ++i) {
    const double t = 0.002 * i, ramp = std::min(1.0, t);
    const dvec3 p = 0.06 * ramp * dvec3(std::cos(2.0 * t) - 1.0, std::sin(2.0 * t), 0.6 * std::sin(1.3 * t));
    link.state.X_DS.p = link.state.X_DP.p = p;
    link.state.buttons = i == 10 ? 1 : 0;
    now += 2'000'000;
    const double begin = cpuMilliseconds();
    engine.step(now);
    if (i % 17 == 0) engine.fillSnapshot(snapshot);
    if (i > 20) times.push_back(cpuMilliseconds() - begin);
  }
  double sum = 0.0;
  for (const double time : times) sum += time;
  std::sort(times.begin(), times.end());
  std::printf("| %s | %zu | %s | %.3f | %.3f | %.3f | %.0f | %d | %.0f |\n", name, triangles,
              engine.held() != nullptr ? "yes" : "no", times[times.size() / 2], times[times.size() * 99 / 100],
              times.back(), 1e3 * static_cast<double>(times.size()) / sum, link.sets, preparation);
  std::fflush(stdout);
}

void robotAmongParts() {
  const Chain chain = makeChain(200);
  std::vector<workcell::Entity> entities = {chainRobot(chain)};
  const auto placed = partsAround(chain, 80, 20000);
  const auto mesh = std::make_shared<const geometry::TriangleMesh>(placed.front().mesh);
  for (std::size_t i = 0; i < placed.size(); ++i) entities.push_back(solid(i + 2, mesh, placed[i].X_WP));
  lead("7 links x 80 parts", std::move(entities));
}

void partAmongMillions() {
  const auto mesh = std::make_shared<const geometry::TriangleMesh>(cadPart(1000000));
  std::vector<workcell::Entity> entities = {solid(1, mesh, {})};
  for (int i = 0; i < 19; ++i) {
    const double around = 2.0 * std::numbers::pi * i / 19.0;
    entities.push_back(solid(static_cast<workcell::EntityId>(i + 2), mesh,
                             {{0.9 * std::cos(around), 0.9 * std::sin(around), 0.02 * i - 0.2},
                              quaternionFromRotationVector({0.3 * i, 0.2, around})}));
  }
  entities[1].X_WE = {{0.0, 0.0, 0.16}, dquat(1, 0, 0, 0)};
  lead("a part among 19, a million triangles each", std::move(entities));
}

}  // namespace
}  // namespace hapticell::bench

int main(int argc, char** argv) {
  using namespace hapticell::bench;
  std::vector<std::string> wanted(argv + 1, argv + argc);
  if (wanted.empty()) wanted = {"robot", "parts"};
  std::printf(
      "| cell | triangles | held | step, ms (median) | p99 | max | steps a second | sets | prepared in, ms |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::string& name : wanted) {
    if (name == "robot") robotAmongParts();
    if (name == "parts") partAmongMillions();
  }
  return 0;
}
