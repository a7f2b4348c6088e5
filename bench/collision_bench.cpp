// SPDX-License-Identifier: Apache-2.0
// Proximity engine against its peer, same process, same poses. Prints the table of docs/performance.md.
//
// usage: collision_bench [FOLDER]   FOLDER: the shared test data; default $HAPTICELL_TEST_DATA, else ../shared/data
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "bench/collision_scenes.h"
#include "collision/proximity_query.h"
#include "workcell/mesh_reader.h"
#ifdef HAPTICELL_HAS_FCL
#include "bench/fcl_peer.h"
#endif

namespace hapticell::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kWalks = 3;

struct Times {
  double median_us = 0.0, p99_us = 0.0, max_us = 0.0;
};

/// Walks the path several times from a fresh state; each step's time is the least of its walks (takes the system's
/// noise out and keeps the engine's own spikes). `begin_walk` forgets what was warm.
Times timed(const std::vector<Pose>& path, const std::function<void()>& begin_walk,
            const std::function<void(const Pose&)>& query) {
  std::vector<double> least(path.size(), std::numeric_limits<double>::infinity());
  for (int walk = 0; walk < kWalks; ++walk) {
    begin_walk();
    for (std::size_t i = 0; i < path.size(); ++i) {
      const auto begin = Clock::now();
      query(path[i]);
      least[i] = std::min(least[i], std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
    }
  }
  std::sort(least.begin(), least.end());
  return {least[least.size() / 2], least[least.size() * 99 / 100], least.back()};
}

void row(const std::string& scene, const char* query, const char* engine, const Times& t, const Times& ours) {
  std::printf("| %s | %s | %s | %.1f | %.1f | %.1f | %.1f | %.1f |\n", scene.c_str(), query, engine, t.median_us,
              t.p99_us, t.max_us, t.median_us / ours.median_us, t.p99_us / ours.p99_us);
  std::fflush(stdout);
}

void measure(const Scene& scene) {
  auto begin = Clock::now();
  const auto moved = collision::MeshCollider::build(scene.moved),
             standing = collision::MeshCollider::build(scene.standing);
  const double build_ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  collision::ProximityQuery query(moved, standing);
  const auto fresh = [&] { query = collision::ProximityQuery(moved, standing); };
  const Times distance = timed(scene.X_WM, fresh, [&](const Pose& X) { query.distance(X, {}); });
  const Times cold = timed(scene.X_WM, fresh, [&](const Pose& X) {
    fresh();
    query.distance(X, {});
  });
  const Times within = timed(scene.X_WM, fresh, [&](const Pose& X) { query.within(X, {}, 0.005); });
  const Times collide = timed(scene.X_WM, fresh, [&](const Pose& X) { query.collides(X, {}); });
  const std::string name = scene.name + " (" + std::to_string(scene.moved.triangles.size()) + " x " +
                           std::to_string(scene.standing.triangles.size()) + ")";
  row(name, "distance", "HaptiCell", distance, distance);
  row(name, "distance", "HaptiCell, cold", cold, distance);
  row(name, "within 5 mm", "HaptiCell", within, within);
  row(name, "collide", "HaptiCell", collide, collide);
#ifdef HAPTICELL_HAS_FCL
  FclPeer peer(scene.moved, scene.standing);
  row(name, "distance", "FCL",
      timed(
          scene.X_WM, [] {}, [&](const Pose& X) { peer.distance(X); }),
      distance);
  row(name, "collide", "FCL",
      timed(
          scene.X_WM, [] {}, [&](const Pose& X) { peer.collides(X); }),
      collide);
  double worst = 0.0;
  int booleans = 0;
  for (const Pose& X : scene.X_WM) {
    const collision::DistanceResult ours = query.distance(X, {});
    const bool surfaces_meet = ours.colliding && !ours.contained;
    if (!ours.contained) worst = std::max(worst, std::abs(ours.distance - std::max(0.0, peer.distance(X))));
    if (surfaces_meet != peer.collides(X)) ++booleans;
  }
  std::printf(
      "%s: build %.0f ms, FCL %.0f ms; largest difference of the distances %.2g m, of %zu booleans %d differ\n\n",
      name.c_str(), build_ms, peer.buildMilliseconds(), worst, scene.X_WM.size(), booleans);
#else
  std::printf("%s: build %.0f ms; FCL is not installed (libfcl-dev)\n\n", name.c_str(), build_ms);
#endif
}

void measureFiles(const std::filesystem::path& folder) {
  const auto moved_file = folder / "cad/stl/odri_transmission_pulley_at3_t30_output.stl";
  const auto standing_file = folder / "cad/stl/odri_hip_aa_module_shell_base.stl";
  Diagnostics ignored;
  workcell::MeshReadOptions millimetres;
  millimetres.scale = 0.001;
  auto moved = workcell::readMesh(moved_file, millimetres, ignored);
  auto standing = workcell::readMesh(standing_file, millimetres, ignored);
  if (!moved || !standing) {
    std::printf("real parts skipped: %s\n", (!moved ? moved.error() : standing.error()).message().c_str());
    return;
  }
  measure(fileScene("real", std::move(*moved), std::move(*standing)));
}

}  // namespace
}  // namespace hapticell::bench

int main(int argc, char** argv) {
  using namespace hapticell::bench;
  const char* named = std::getenv("HAPTICELL_TEST_DATA");
  const std::filesystem::path folder = argc > 1 ? argv[1] : named ? named : "../shared/data";
  std::printf("| scene (triangles) | query | engine | median us | p99 us | max us | x median | x p99 |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  measure(cadScene("cad10k", 10000));
  measure(cadScene("cad100k", 100000));
  measureFiles(folder);
  return 0;
}
