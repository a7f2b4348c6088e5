// SPDX-License-Identifier: Apache-2.0
// Whole cells: which parts are near, beside the peer's broad phase in the same process. Prints a table of
// docs/dev/performance.md.
//
// usage: scene_bench [alone] [chain] [one] [cell] [moving]
// alone: without the peer (for a profiler);
// chain: 7 links x 80 parts; one: 1 part x 10 to 5000; cell: 7 links in cells of 50 and 5000 parts of one density;
// moving: what it costs that parts of a cell of 5000 move, come and go. Default: all. cell_bench opens and holds such
// cells.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "bench/collision_scenes.h"
#include "bench/thread_clock.h"
#include "collision/queries/scene.h"
#ifdef HAPTICELL_HAS_FCL
#include "bench/fcl_peer.h"
#endif

namespace hapticell::bench {
namespace {

using Collider = std::shared_ptr<const collision::MeshCollider>;
using Poses = std::vector<Pose>;
constexpr int kWalks = 5, kSamplesOfEdge = 20;
constexpr std::size_t kSteps = 1000, kEdges = 200;
bool with_peer = true;

/// Processor time of the thread.
double microseconds() {
  return 1e3 * threadMilliseconds();
}

/// Each step's least time of several walks, us, sorted.
template <typename Query>
std::vector<double> timed(std::size_t steps, const Query& query) {
  static const double cost = 1e3 * threadClockCost();
  std::vector<double> least(steps, 1e9);
  for (int walk = 0; walk < kWalks; ++walk) {
    for (std::size_t i = 0; i < steps; ++i) {
      const double begin = microseconds();
      query(i);
      least[i] = std::min(least[i], std::max(0.0, microseconds() - begin - cost));
    }
  }
  std::sort(least.begin(), least.end());
  return least;
}

void row(const std::string& scene, const std::string& query, const std::vector<double>& ours,
         const std::vector<double>& peer, const std::string& note) {
  const auto at = [](const std::vector<double>& times, double share) {
    return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
  };
  std::printf("| %s | %s | %.2f / %.1f / %.0f |", scene.c_str(), query.c_str(), at(ours, 0.5), at(ours, 0.99),
              ours.back());
  if (peer.empty()) {
    std::printf(" | |");
  } else {
    std::printf(" %.2f / %.1f / %.0f | %.1f |", at(peer, 0.5), at(peer, 0.99), peer.back(),
                at(peer, 0.5) / at(ours, 0.5));
  }
  std::printf(" %s |\n", note.c_str());
  std::fflush(stdout);
}

/// Some moved parts against standing ones of one shape, for both engines.
class Group {
 public:
  Group(const std::vector<geometry::TriangleMesh>& moved, const geometry::TriangleMesh& standing, const Poses& X_WS)
#ifdef HAPTICELL_HAS_FCL
      : peer_(moved, {standing}, X_WS)
#endif
  {
    for (const auto& mesh : moved) moved_.push_back(scene_.addPart({0, 0}, collision::MeshCollider::build(mesh)));
    const Collider shape = collision::MeshCollider::build(standing);
    for (const Pose& X : X_WS) standing_.push_back(scene_.addPart({1, 0}, shape, X));
#ifdef HAPTICELL_SCENE_SETS
    scene_.addPairs(moved_, standing_);
#else
    for (const auto part : moved_) {
      for (const auto other : standing_) scene_.addPair(part, other);
    }
#endif
  }

  bool isFree(const Poses& X_WM) {
    place(X_WM);
    return !scene_.collides();
  }

  void place(const Poses& X_WM) {
    for (std::size_t i = 0; i < moved_.size(); ++i) scene_.setPose(moved_[i], X_WM[i]);
  }

  void measureCollides(const std::string& name, const std::string& query, const std::vector<Poses>& path) {
    std::vector<char> ours(path.size()), theirs(path.size());
    const auto times = timed(path.size(), [&](std::size_t i) {
      place(path[i]);
      ours[i] = scene_.collides();
    });
    std::vector<double> peer;
#ifdef HAPTICELL_HAS_FCL
    theirs = ours;
    if (with_peer) peer = timed(path.size(), [&](std::size_t i) { theirs[i] = peer_.collides(path[i]); });
    const int others =
        static_cast<int>(path.size()) - static_cast<int>(std::inner_product(ours.begin(), ours.end(), theirs.begin(), 0,
                                                                            std::plus<>(), std::equal_to<>()));
    const std::string differ = ", " + std::to_string(others) + " answers differ";
#else
    const std::string differ;
#endif
    row(name, query, times, peer, std::to_string(std::count(ours.begin(), ours.end(), 1)) + " collide" + differ);
  }

  /// The peer's least distance is in collision_bench.
  void measureNearest(const std::string& name, const std::vector<Poses>& path) {
    const auto nearest = timed(path.size(), [&](std::size_t i) {
      place(path[i]);
      scene_.nearest();
    });
    row(name, "nearest, along a free motion", nearest, {}, "");
    const auto within = timed(path.size(), [&](std::size_t i) {
      place(path[i]);
      found_.clear();
      scene_.pairsWithin(0.05, found_);
    });
    row(name, "pairs within 50 mm, along a free motion", within, {}, "");
  }

  /// Straight ways of the joints; the peer looks at samples of it, as planners do.
  /// The links' poses at the last places that were asked for, as a robot's forward kinematics gives all at once.
  class KnownPoses {
   public:
    template <typename Between>
    const Poses& at(std::size_t edge, double s, const Between& between) {
      const auto found = std::find_if(places_.begin(), places_.end(),
                                      [&](const Place& place) { return place.edge == edge && place.s == s; });
      if (found != places_.end()) return found->X_WL;
      Place& place = places_[next_++ % places_.size()];
      place = {edge, s, chainPoses(between(edge, s))};
      return place.X_WL;
    }
    void forget() { places_ = {}; }

   private:
    struct Place {
      std::size_t edge = 0;
      double s = -1.0;
      Poses X_WL;
    };
    std::array<Place, 32> places_;
    std::size_t next_ = 0;
  };

  void measureEdges(const std::string& name, const std::vector<std::vector<double>>& from,
                    const std::vector<std::vector<double>>& to) {
    int stopped = 0, met = 0;
    const auto between = [&](std::size_t edge, double s) {
      std::vector<double> angles(from[edge]);
      for (std::size_t i = 0; i < angles.size(); ++i) angles[i] += s * (to[edge][i] - from[edge][i]);
      return angles;
    };
    KnownPoses known;
    const auto motions = [&](std::size_t edge) {
      std::vector<collision::MovedPart> parts(moved_.size());
      for (std::size_t i = 0; i < parts.size(); ++i) {
        parts[i].part = moved_[i];
        collision::PartMotion& motion = parts[i].motion;
        const collision::MeshCollider& mesh = scene_.collider(moved_[i]);
        double turned = 0.0;
        for (std::size_t k = 0; k <= i; ++k) {
          const double turn = std::abs(to[edge][k] - from[edge][k]);
          const double reach = 0.26 * static_cast<double>(i - k) + glm::length(mesh.center()) + mesh.radius();
          turned += turn;
          motion.path_bound += turn * reach;
        }
        motion.bend_bound = 2.0 * turned * motion.path_bound;
        motion.along = [&known, &between, edge, i](double s) { return known.at(edge, s, between)[i]; };
      }
      return parts;
    };
    std::vector<std::vector<collision::MovedPart>> all;
    for (std::size_t edge = 0; edge < from.size(); ++edge) all.push_back(motions(edge));
    const auto times = timed(from.size(), [&](std::size_t edge) {
      if (edge == 0) stopped = 0;
      known.forget();
      stopped += scene_.advance(all[edge], 0.0).stopped;
    });
    std::vector<double> peer;
#ifdef HAPTICELL_HAS_FCL
    if (with_peer)
      peer = timed(from.size(), [&](std::size_t edge) {
        if (edge == 0) met = 0;
        bool meets = false;
        for (int k = 0; k <= kSamplesOfEdge && !meets; ++k) {
          meets = peer_.collides(chainPoses(between(edge, static_cast<double>(k) / kSamplesOfEdge)));
        }
        met += meets;
      });
#endif
    row(name, "motion check of an edge of 0.2 rad", times, peer,
        std::to_string(stopped) + " stop; peer (" + std::to_string(kSamplesOfEdge + 1) + " samples) meets " +
            std::to_string(met));
  }

 private:
  collision::Scene scene_;
  std::vector<collision::PartIndex> moved_, standing_;
  std::vector<collision::PairDistance> found_;
#ifdef HAPTICELL_HAS_FCL
  FclGroup peer_;
#endif
};

std::vector<double> randomAngles(std::mt19937& random) {
  std::uniform_real_distribution<double> turn(-2.5, 2.5), bend(-1.2, 1.2);
  std::vector<double> angles;
  for (int i = 0; i < 7; ++i) angles.push_back(i % 2 == 0 ? turn(random) : bend(random));
  return angles;
}

/// The chain from random posture to random posture, 0.5 degrees a step of its fastest joint.
std::vector<Poses> randomMotion(std::mt19937& random) {
  constexpr double kStep = 0.5 * std::numbers::pi / 180.0;
  std::vector<Poses> path;
  std::vector<double> at = randomAngles(random);
  while (path.size() < kSteps) {
    const std::vector<double> to = randomAngles(random);
    double furthest = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) furthest = std::max(furthest, std::abs(to[i] - at[i]));
    const int steps = static_cast<int>(furthest / kStep);
    for (int k = 0; k < steps && path.size() < kSteps; ++k) {
      std::vector<double> angles(at);
      for (std::size_t i = 0; i < at.size(); ++i) angles[i] += (to[i] - at[i]) * k / steps;
      path.push_back(chainPoses(angles));
    }
    at = to;
  }
  return path;
}

void measureEdges(const std::string& name, Group& group, std::mt19937& random) {
  std::vector<std::vector<double>> from, to;
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  while (from.size() < kEdges) {
    const std::vector<double> begin = randomAngles(random);
    if (!group.isFree(chainPoses(begin))) continue;  // As a planner's tree is.
    from.push_back(begin);
    std::vector<double> way(7);
    double length = 0.0;
    for (double& w : way) {
      w = unit(random);
      length += w * w;
    }
    to.push_back(from.back());
    for (std::size_t i = 0; i < way.size(); ++i) to.back()[i] += 0.2 * way[i] / std::sqrt(length);
  }
  group.measureEdges(name, from, to);
}

void measureChain(const std::string& name, Group& group) {
  std::mt19937 random(17);
  group.measureCollides(name, "collides, along a motion", randomMotion(random));
  std::vector<Poses> unrelated;
  for (std::size_t i = 0; i < kSteps; ++i) unrelated.push_back(chainPoses(randomAngles(random)));
  group.measureCollides(name, "collides, unrelated poses", unrelated);
  measureEdges(name, group, random);
}

Poses scattered(std::mt19937& random, int parts, double side, double around) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Poses poses;
  while (static_cast<int>(poses.size()) < parts) {
    const dvec3 p = 0.5 * side * dvec3(unit(random), unit(random), unit(random));
    const dquat q = glm::normalize(dquat(unit(random), unit(random), unit(random), unit(random)));
    if (std::hypot(p.x, p.y) > around) poses.push_back({p, q});
  }
  return poses;
}

void chainAmongParts() {
  const Chain chain = makeChain(static_cast<int>(kSteps));
  Poses X_WS;
  const auto placed = partsAround(makeChain(600), 80, 20000);
  for (const PlacedPart& part : placed) X_WS.push_back(part.X_WP);
  Group group(chain.links, placed.front().mesh, X_WS);
  const std::string name = "7 links x 80 parts, 1.7 M triangles";
  group.measureCollides(name, "collides, along a free motion", chain.X_WL);
  group.measureNearest(name, chain.X_WL);
  measureChain(name, group);
}

void onePart() {
  for (const int parts : {10, 100, 1000, 5000}) {
    std::mt19937 random(5);
    const double side = 0.9 * std::cbrt(parts);
    Group group({cadPart(20000)}, cadPart(2000), scattered(random, parts, side, 0.0));
    std::vector<Poses> motion, unrelated;
    for (std::size_t i = 0; i < kSteps; ++i) {
      const double t = 0.004 * static_cast<double>(i);
      motion.push_back({Pose{0.4 * side * dvec3(std::cos(t), std::sin(t), std::sin(1.7 * t)),
                             quaternionFromRotationVector({0.9 * t, 0.0, 1.1 * t})}});
      unrelated.push_back(scattered(random, 1, side, 0.0));
    }
    const std::string name = "1 part x " + std::to_string(parts);
    group.measureCollides(name, "collides, along a motion", motion);
    group.measureCollides(name, "collides, unrelated poses", unrelated);
  }
}

void chainInCells() {
  for (const int parts : {50, 5000}) {
    std::mt19937 random(7);
    const Chain chain = makeChain(2);
    Group group(chain.links, cadPart(2000), scattered(random, parts, 4.4 * std::cbrt(parts / 50.0), 0.25));
    measureChain("7 links in a cell of " + std::to_string(parts) + " parts", group);
  }
}

/// Each call's time, us, by blocks of them, as the clock is no finer.
template <typename Call>
std::vector<double> timedInBlocks(std::size_t calls, const Call& call) {
  constexpr std::size_t kBlock = 100;
  std::vector<double> times = timed(calls / kBlock, [&](std::size_t block) {
    for (std::size_t i = 0; i < kBlock; ++i) call(kBlock * block + i);
  });
  for (double& time : times) time /= double{kBlock};
  return times;
}

/// 5000 parts that all are sought by one, and what it costs to keep the scene current.
void movingParts() {
  constexpr int kParts = 5000;
  constexpr std::size_t kCalls = 20000;
  std::mt19937 random(9);
  const double side = 4.4 * std::cbrt(kParts / 50.0);
  const Collider shape = collision::MeshCollider::build(cadPart(2000));
  collision::Scene scene;
  std::vector<collision::PartIndex> parts;
  for (const Pose& X : scattered(random, kParts, side, 0.0)) parts.push_back(scene.addPart({1, 0}, shape, X));
  const auto seeker = scene.addPart({0, 0}, shape);
  const std::vector<collision::PartIndex> seekers{seeker};
  scene.addPairs(seekers, parts);
  const Poses anywhere = scattered(random, kParts, side, 0.0);
  const std::string name = "a part of 5000";
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<dvec3> way;
  for (int i = 0; i < kParts; ++i) way.push_back(glm::normalize(dvec3(unit(random), unit(random), unit(random))));
  const auto partOf = [&](std::size_t i) { return parts[i % parts.size()]; };
  for (const double step : {1e-3, 1e-2, 1e-1}) {
    const auto times = timedInBlocks(kCalls, [&](std::size_t i) {
      Pose X = scene.pose(partOf(i));
      X.p += step * way[i % way.size()];
      scene.setPose(partOf(i), X);
    });
    row(name, "moves by " + std::to_string(static_cast<int>(1e3 * step)) + " mm", times, {}, "");
  }
  std::size_t shift = 0;
  const auto far_away = timedInBlocks(kCalls, [&](std::size_t i) {
    if (i % parts.size() == 0) ++shift;
    scene.setPose(partOf(i), anywhere[(i + 7 * shift) % anywhere.size()]);
  });
  row(name, "moves anywhere", far_away, {}, "");
  const auto replaced = timedInBlocks(kCalls, [&](std::size_t i) {
    const Pose X = scene.pose(partOf(i));
    scene.removePart(partOf(i));
    parts[i % parts.size()] = scene.addPart({1, 0}, shape, X);
    scene.addPair(seeker, partOf(i));
  });
  row(name, "is removed, and one added", replaced, {}, "");
}

}  // namespace
}  // namespace hapticell::bench

int main(int argc, char** argv) {
  using namespace hapticell::bench;
  std::vector<std::string> wanted(argv + 1, argv + argc);
  with_peer = std::erase(wanted, "alone") == 0;
  if (wanted.empty()) wanted = {"chain", "one", "cell", "moving"};
  std::printf("| scene | query | HaptiCell, us (median / p99 / max) | FCL, us | x median | |\n");
  std::printf("| --- | --- | --- | --- | --- | --- |\n");
  for (const std::string& scene : wanted) {
    if (scene == "chain") chainAmongParts();
    if (scene == "one") onePart();
    if (scene == "cell") chainInCells();
    if (scene == "moving") movingParts();
  }
  return 0;
}
