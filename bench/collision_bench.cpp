// SPDX-License-Identifier: Apache-2.0
// Proximity engine against its peers (FCL; PQP where it is installed), same process, same poses. Prints the tables of docs/dev/performance.md.
//
// usage: collision_bench [--data FOLDER] [SCENE...]
// FOLDER: the shared test data; default $HAPTICELL_TEST_DATA, else ../shared/data. SCENE: cad10k, cad100k, real,
// pulley, scan100k, cad10k-1M, cad1M, scan1M, group, group30; default all.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "bench/collision_scenes.h"
#include "bench/thread_clock.h"
#include "bench/walk_times.h"
#include "collision/queries/proximity_query.h"
#include "collision/queries/scene.h"
#include "workcell/meshes/mesh_reader.h"
#ifdef HAPTICELL_HAS_FCL
#include "bench/fcl_peer.h"
#endif
#ifdef HAPTICELL_HAS_PQP
#include "bench/pqp_peer.h"
#endif

namespace hapticell::bench {
namespace {

using Collider = std::shared_ptr<const collision::MeshCollider>;
/// What issue and facts ask of a row; zero asks nothing.
struct Asked {
  double times_median = 0.0, times_p99 = 0.0;  ///< Of the peer's time over ours.
  double median_us = 0.0, p99_us = 0.0;        ///< Absolute.
};

void row(const std::string& scene, const char* query, const Times& ours, const Times* peer, const Asked& asked) {
  std::printf("| %s | %s | %.2f / %.1f / %.0f |", scene.c_str(), query, ours.median_us, ours.p99_us, ours.max_us);
  bool reached = (asked.median_us == 0.0 || ours.median_us <= asked.median_us) &&
                 (asked.p99_us == 0.0 || ours.p99_us <= asked.p99_us);
  if (peer != nullptr) {
    const double median = peer->median_us / ours.median_us, p99 = peer->p99_us / ours.p99_us;
    std::printf(" %.0f / %.0f / %.0f | %.1f | %.1f |", peer->median_us, peer->p99_us, peer->max_us, median, p99);
    reached = reached && median >= asked.times_median && p99 >= asked.times_p99;
  } else {
    std::printf(" | | |");
  }
  const bool asks = asked.times_median > 0.0 || asked.median_us > 0.0 || asked.p99_us > 0.0;
  const char* const answer = reached ? "yes" : "**no**";
  std::printf(" %s |\n", asks ? answer : "");
  std::fflush(stdout);
}

#ifdef HAPTICELL_HAS_FCL
/// The peer on the same poses, and how far the answers agree.
struct Peer {
  FclPeer fcl;
  explicit Peer(const Scene& scene) : fcl(scene.moved, scene.standing) {}
  Times distance(const std::vector<Pose>& path) {
    return timed(
        path.size(), [] {}, [&](std::size_t i) { fcl.distance(path[i]); });
  }
  Times collide(const std::vector<Pose>& path) {
    return timed(
        path.size(), [] {}, [&](std::size_t i) { fcl.collides(path[i]); });
  }
  void compare(const Scene& scene, collision::ProximityQuery& query) {
    double worst = 0.0;
    int booleans = 0, near = 0;
    for (const Pose& X : scene.X_WM) {
      const collision::DistanceResult ours = query.distance(X, {});
      if (!ours.contained) worst = std::max(worst, std::abs(ours.distance - std::max(0.0, fcl.distance(X))));
      if ((ours.colliding && !ours.contained) != fcl.collides(X)) ++booleans;
      near += ours.distance < 0.01;
    }
    std::printf(
        "%s: largest difference of the distances %.2g m, of %zu booleans %d differ; %d poses nearer than 10 mm\n",
        scene.name.c_str(), worst, scene.X_WM.size(), booleans, near);
  }
};
#endif

#ifdef HAPTICELL_HAS_PQP
/// The same queries beside PQP, on the same poses; what is asked of a row is of issue 33.
class PqpRows {
 public:
  explicit PqpRows(const Scene& scene)
      : scene_(scene), pqp_(scene.moved, scene.standing), is_large_(scene.moved.triangles.size() > 500000) {}

  void print(const Times& distance, const Times& cold, const Times& within, const Times& collide) {
    const std::vector<Pose>& path = scene_.X_WM;
    add("distance", distance, path, [&](const Pose& X) { pqp_.distance(X); },
        is_large_ ? Asked{8.0, 8.0, 14.0, 70.0} : Asked{8.0, 8.0, 8.0, 40.0});
    const auto from_nothing = [&](const Pose& X) {
      pqp_.forget();
      pqp_.distance(X);
    };
    add("distance, cold", cold, path, from_nothing, {4.0, 0.0, 0.0, 0.0});
    const auto best_first = [&](const Pose& X) {
      pqp_.forget();
      pqp_.distance(X, 1000);
    };
    add("distance, cold, PQP best first", cold, path, best_first, {4.0, 0.0, 0.0, 0.0});
    add("within 5 mm", within, path, [&](const Pose& X) { pqp_.isWithin(X, 0.005); }, {0.0, 0.0, 0.5, 30.0});
    add("collide", collide, path, [&](const Pose& X) { pqp_.collides(X); }, {0.0, 0.0, 1.5, 10.0});
  }
  void printHaptic(const Times& ours, const std::vector<Pose>& path) {
    add("distance, 0.15 mm steps", ours, path, [&](const Pose& X) { pqp_.distance(X); }, {0.0, 0.0, 1.5, 25.0});
  }

  /// How far the answers agree.
  void compare(collision::ProximityQuery& query) {
    double worst = 0.0;
    int booleans = 0;
    for (const Pose& X : scene_.X_WM) {
      const collision::DistanceResult ours = query.distance(X, {});
      if (ours.contained) continue;
      worst = std::max(worst, std::abs(ours.distance - pqp_.distance(X)));
      booleans += ours.colliding != pqp_.collides(X) ? 1 : 0;
    }
    std::printf("%s: PQP's distances differ by %.2g m at most, %d of its booleans\n", scene_.name.c_str(), worst,
                booleans);
  }

 private:
  void add(const char* query, const Times& ours, const std::vector<Pose>& path,
           const std::function<void(const Pose&)>& ask, const Asked& asked) {
    const Times theirs = timed(
        path.size(), [&] { pqp_.forget(); }, [&](std::size_t i) { ask(path[i]); });
    row(scene_.name + ", beside PQP", query, ours, &theirs, asked);
  }

  const Scene& scene_;
  PqpPeer pqp_;
  bool is_large_;
};
#endif

Times measureHaptic(const Scene& scene, collision::ProximityQuery& query, const std::function<void()>& fresh,
                   const Times* peer) {
  const std::vector<Pose> path = hapticSteps(scene.X_WM, kApproach + 100, 150, 20);
  const Times ours = timed(path.size(), fresh, [&](std::size_t i) { query.distance(path[i], {}); });
  const bool large = scene.moved.triangles.size() > 500000;
  row(scene.name, "distance, 0.15 mm steps", ours, peer, {45.0, 0.0, 0.0, large ? 60.0 : 40.0});
  return ours;
}

void measure(const Scene& scene) {
  const double begin = threadMilliseconds();
  const Collider moved = collision::MeshCollider::build(scene.moved),
                 standing = collision::MeshCollider::build(scene.standing);
  const double build_ms = threadMilliseconds() - begin;
  collision::ProximityQuery query(moved, standing);
  const std::function<void()> fresh = [&] { query = collision::ProximityQuery(moved, standing); };
  const std::vector<Pose>& path = scene.X_WM;
  const Times distance = timed(path.size(), fresh, [&](std::size_t i) { query.distance(path[i], {}); });
  const Times cold = timed(path.size(), fresh, [&](std::size_t i) {
    fresh();
    query.distance(path[i], {});
  });
  const Times within = timed(path.size(), fresh, [&](std::size_t i) { query.within(path[i], {}, 0.005); });
  const Times collide = timed(path.size(), fresh, [&](std::size_t i) { query.collides(path[i], {}); });
  const bool haptic = scene.name == "cad100k" || scene.name == "cad1M";
#ifdef HAPTICELL_HAS_FCL
  Peer peer(scene);
  const Times peer_distance = peer.distance(path), peer_collide = peer.collide(path);
  const Times peer_haptic = haptic ? peer.distance(hapticSteps(path, kApproach + 100, 150, 2)) : Times{};
  const Times *distance_of_peer = &peer_distance, *collide_of_peer = &peer_collide, *haptic_of_peer = &peer_haptic;
#else
  const Times *distance_of_peer = nullptr, *collide_of_peer = nullptr, *haptic_of_peer = nullptr;
#endif
  row(scene.name, "distance", distance, distance_of_peer, {30.0, 20.0, 0.0, 0.0});
  row(scene.name, "distance, cold", cold, distance_of_peer, {});
  const Times steps = haptic ? measureHaptic(scene, query, fresh, haptic_of_peer) : Times{};
  row(scene.name, "within 5 mm", within, nullptr, {0.0, 0.0, 3.0, 60.0});
  row(scene.name, "collide", collide, collide_of_peer, {8.0, 0.0, 0.0, 0.0});
#ifdef HAPTICELL_HAS_PQP
  PqpRows pqp(scene);
  pqp.print(distance, cold, within, collide);
  if (haptic) pqp.printHaptic(steps, hapticSteps(path, kApproach + 100, 150, 20));
  pqp.compare(query);
#else
  static_cast<void>(steps);
#endif
  const std::size_t triangles = scene.moved.triangles.size() + scene.standing.triangles.size();
  std::printf("%s: %zu x %zu triangles; build %.0f ms, %.0f bytes a triangle", scene.name.c_str(),
              scene.moved.triangles.size(), scene.standing.triangles.size(), build_ms,
              static_cast<double>(moved->memory() + standing->memory()) / static_cast<double>(triangles));
#ifdef HAPTICELL_HAS_FCL
  std::printf("; FCL's build %.0f ms (%.2f)\n", peer.fcl.buildMilliseconds(), build_ms / peer.fcl.buildMilliseconds());
  peer.compare(scene, query);
#endif
  std::printf("\n");
}

/// Seven links against many parts: one least distance over all pairs.
void measureGroup(const char* name, int parts, double speed) {
  const int steps = 600;
  Chain chain = makeChain(steps);
  if (speed < 1.0) {
    Chain fine = makeChain(200);
    for (std::size_t step = 0; step < chain.X_WL.size(); ++step) {
      const double at = static_cast<double>(step) * speed;
      const auto from = static_cast<std::size_t>(at);
      for (std::size_t i = 0; i < chain.links.size(); ++i) {
        chain.X_WL[step][i] = interpolate(fine.X_WL[from][i], fine.X_WL[from + 1][i], at - static_cast<double>(from));
      }
    }
  }
  const std::vector<PlacedPart> placed = partsAround(makeChain(steps), parts, 20000);
  collision::Scene scene;
  std::vector<collision::PartIndex> links, standing;
  for (const auto& link : chain.links) links.push_back(scene.addPart({0, 0}, collision::MeshCollider::build(link)));
  const Collider part = collision::MeshCollider::build(placed.front().mesh);
  for (const PlacedPart& p : placed) standing.push_back(scene.addPart({1, 0}, part, p.X_WP));
  for (const auto link : links) {
    for (const auto other : standing) scene.addPair(link, other);
  }
  const auto pose = [&](std::size_t step) {
    for (std::size_t i = 0; i < links.size(); ++i) scene.setPose(links[i], chain.X_WL[step][i]);
  };
  std::vector<double> distances(chain.X_WL.size());
  const Times ours = timed(
      chain.X_WL.size(), [] {},
      [&](std::size_t step) {
        pose(step);
        distances[step] = scene.nearest()->result.distance;
      });
  const Asked asked{speed < 1.0 ? 0.0 : 80.0, speed < 1.0 ? 0.0 : 45.0, 0.0, 0.0};
#ifdef HAPTICELL_HAS_FCL
  std::vector<geometry::TriangleMesh> meshes;
  std::vector<Pose> poses;
  for (const PlacedPart& p : placed) {
    meshes.push_back(p.mesh);
    poses.push_back(p.X_WP);
  }
  FclGroup fcl(chain.links, meshes, poses);
  double worst = 0.0;
  const Times peer = timed(
      chain.X_WL.size(), [] {},
      [&](std::size_t step) { worst = std::max(worst, std::abs(fcl.distance(chain.X_WL[step]) - distances[step])); });
  row(name, "least distance", ours, &peer, asked);
  std::printf("%s: largest difference of the distances %.2g m", name, worst);
#else
  row(name, "least distance", ours, nullptr, asked);
#endif
  std::sort(distances.begin(), distances.end());
  std::printf("; least %.1f mm, median %.1f mm\n\n", 1e3 * distances.front(), 1e3 * distances[distances.size() / 2]);
}

/// All files in one mesh, as they lie.
geometry::TriangleMesh readAll(const std::vector<std::filesystem::path>& files, double scale) {
  geometry::TriangleMesh whole;
  for (const auto& file : files) {
    Diagnostics ignored;
    workcell::MeshReadOptions options;
    options.scale = scale;
    const auto mesh = workcell::readMesh(file, options, ignored);
    if (mesh)
      append(whole, *mesh, {});
    else
      std::fprintf(stderr, "%s\n", mesh.error().message().c_str());
  }
  return whole;
}

geometry::TriangleMesh robotLinks(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return readAll(files, 1.0);
}

void measureNamed(const std::string& name, const std::filesystem::path& data) {
  const std::filesystem::path stl = data / "cad/stl";
  if (name == "cad10k") measure(makeScene(name, cadPart(10000), cadPlate(10000)));
  if (name == "cad100k") measure(makeScene(name, cadPart(100000), cadPlate(100000)));
  if (name == "cad10k-1M") measure(makeScene(name, cadPart(10000), cadPlate(1000000)));
  if (name == "cad1M") measure(makeScene(name, cadPart(1000000), cadPlate(1000000)));
  if (name == "scan100k") measure(makeScene(name, scanPart(100000), scanTerrain(100000)));
  if (name == "scan1M") measure(makeScene(name, scanPart(1000000), scanTerrain(1000000)));
  if (name == "group") measureGroup("7 links x 80 parts", 80, 1.0);
  if (name == "group30") measureGroup("7 links x 30 parts, 1/20 of the speed", 30, 0.05);
  if (name == "pulley" && std::filesystem::exists(stl)) {
    measure(makeScene(name, readAll({stl / "odri_transmission_pulley_at3_t30_output.stl"}, 0.001),
                      readAll({stl / "odri_hip_aa_module_shell_base.stl"}, 0.001)));
  }
  if (name == "real" && std::filesystem::exists(stl)) {
    const auto robots = data / "robots";
    measure(makeScene(name, readAll({stl / "odri_hip_aa_module_shell_base.stl"}, 0.004),
                      robotLinks(robots / "kuka_kr120r2500pro/kuka_kr120_support/meshes/kr120r2500pro/collision")));
  }
}

}  // namespace
}  // namespace hapticell::bench

int main(int argc, char** argv) {
  using namespace hapticell::bench;
  const char* named = std::getenv("HAPTICELL_TEST_DATA");
  std::filesystem::path data = named ? named : "../shared/data";
  std::vector<std::string> scenes;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--data" && i + 1 < argc)
      data = argv[++i];
    else
      scenes.push_back(argument);
  }
  if (scenes.empty()) {
    scenes = {"cad10k", "cad100k", "real", "pulley", "scan100k", "cad10k-1M", "cad1M", "scan1M", "group", "group30"};
  }
  std::printf("| scene | query | HaptiCell, us (median / p99 / max) | FCL or PQP, us | x median | x p99 | reached |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::string& scene : scenes) measureNamed(scene, data);
  return 0;
}
