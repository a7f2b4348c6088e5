// SPDX-License-Identifier: Apache-2.0
// Cells of many entities: what it costs to open one, and a step while one of its parts is led about. Processor time.
//
// usage: cell_bench [open] [hold]
// open: prepared, touching pairs looked for, distances of one entity; hold: steps of the manipulation. Default: both.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "bench/thread_clock.h"
#include "geometry/shapes/shapes.h"
#include "manipulation/engine/manipulation_engine.h"
#include "manipulation/scene/rest_pairs.h"
#include "tests/manipulation/session/hand_link.h"

namespace hapticell::bench {
namespace {

using Poses = std::vector<Pose>;

Poses scattered(std::mt19937& random, int parts, double side) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Poses poses;
  for (int i = 0; i < parts; ++i) {
    const dvec3 p = 0.5 * side * dvec3(unit(random), unit(random), unit(random));
    poses.push_back({p, glm::normalize(dquat(unit(random), unit(random), unit(random), unit(random)))});
  }
  return poses;
}

std::vector<workcell::Entity> cellOf(int parts) {
  std::mt19937 random(3);
  // A bolt, a bracket and a plate, each in many places; a third of them stand on each other.
  const std::shared_ptr<const geometry::TriangleMesh> shapes[] = {
      std::make_shared<const geometry::TriangleMesh>(geometry::makeCylinder(0.02, 0.1, 24)),
      std::make_shared<const geometry::TriangleMesh>(geometry::makeBox({0.2, 0.1, 0.05})),
      std::make_shared<const geometry::TriangleMesh>(geometry::makeBox({0.3, 0.3, 0.02}))};
  std::vector<workcell::Entity> entities;
  const Poses places = scattered(random, parts, 0.5 * std::cbrt(parts));
  for (int i = 0; i < parts; ++i) {
    workcell::Entity entity;
    entity.id = static_cast<workcell::EntityId>(i + 1);
    entity.name = "part" + std::to_string(i + 1);
    entity.body = workcell::Solid{shapes[i % 3]};
    entity.X_WE = places[static_cast<std::size_t>(i)];
    if (i % 3 == 0) entity.X_WE = Pose::translation(places[static_cast<std::size_t>(i)].p);
    entities.push_back(std::move(entity));
  }
  return entities;
}

void openCells() {
  for (const int parts : {1000, 3000, 5000}) {
    auto entities = cellOf(parts);
    const double begin = threadMilliseconds();
    const auto scene = manipulation::PreparedScene::prepare(std::move(entities), {}, {});
    const double prepared = threadMilliseconds();
    const auto rules = manipulation::touchingAtRest(*scene);
    const double touching = threadMilliseconds();
    const auto near = manipulation::pairsAtRest(*scene, 1, 0.1);
    const double end = threadMilliseconds();
    std::printf(
        "cell of %d entities: prepared in %.0f ms, %zu touching pairs in %.0f ms, %zu pairs of one in %.0f ms\n", parts,
        prepared - begin, rules.size(), touching - prepared, near.size(), end - touching);
    std::fflush(stdout);
  }
}

/// Takes one of the entities and leads it about, 1000 steps a second.
void holdInCells() {
  for (const int parts : {50, 1000, 3000, 5000}) {
    manipulation::test::HandLink link;
    manipulation::ManipulationEngine engine(link, {});
    engine.setScene(manipulation::PreparedScene::prepare(cellOf(parts), {}, {}));
    engine.apply(manipulation::command::ChooseEntity{1});
    std::int64_t now = 0;
    std::vector<double> times;
    manipulation::SceneSnapshot snapshot;
    for (int i = 0; i < 2000; ++i) {
      const double t = 0.001 * i;
      link.state.X_DS.p = link.state.X_DP.p =
          0.06 * dvec3(std::cos(2.0 * t) - 1.0, std::sin(2.0 * t), 0.6 * std::sin(1.3 * t));
      link.state.buttons = i == 10 ? 1 : 0;
      now += 1'000'000;
      const double begin = threadMilliseconds();
      engine.step(now);
      if (i % 17 == 0) engine.fillSnapshot(snapshot);
      times.push_back(threadMilliseconds() - begin);
    }
    const double taking = *std::max_element(times.begin(), times.begin() + 21);
    times.erase(times.begin(), times.begin() + 21);
    double sum = 0.0;
    for (const double time : times) sum += time;
    std::sort(times.begin(), times.end());
    std::printf(
        "held among %d entities: taken in %.1f ms, a step %.3f / %.3f / %.3f ms (median, p99, max), %.0f a second\n",
        parts, taking, times[times.size() / 2], times[times.size() * 99 / 100], times.back(),
        1e3 * static_cast<double>(times.size()) / sum);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace hapticell::bench

int main(int argc, char** argv) {
  std::vector<std::string> wanted(argv + 1, argv + argc);
  if (wanted.empty()) wanted = {"open", "hold"};
  for (const std::string& what : wanted) {
    if (what == "open") hapticell::bench::openCells();
    if (what == "hold") hapticell::bench::holdInCells();
  }
  return 0;
}
