// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <optional>

#include "collision/queries/pose_batch.h"
#include "collision/queries/scene.h"
#include "python/engine/bindings.h"
#include "python/engine/conversion.h"
#include "python/engine/long_work.h"
#include "python/engine/mesh_binding.h"
#include "python/engine/structured_array.h"

namespace hapticell::python {

namespace {

using collision::PartIndex;

/// What Python sees as hapticell.Scene: parts by their numbers.
struct Scene {
  collision::Scene scene;
  std::vector<bool> present;  ///< By number: not removed.

  PartIndex part(std::size_t number) const {
    if (number < present.size() && present[number]) return static_cast<PartIndex>(number);
    raise({.place = "part", .found = Text("%1", number), .expected = "a number that add() returned, not removed"});
  }
  std::vector<PartIndex> parts(const std::vector<std::size_t>& numbers) const {
    std::vector<PartIndex> found;
    for (const std::size_t number : numbers) found.push_back(part(number));
    return found;
  }
};

/// The distance of two parts of a scene.
struct ScenePairDistance {
  PartIndex part, other;
  Distance distance;
};

/// Where a motion ended.
struct Sweep {
  double share;
  bool stopped, began_colliding;
  Pose X_WP;
  std::optional<ScenePairDistance> nearest;
};

ScenePairDistance named(const collision::Scene& scene, const collision::PairDistance& found) {
  return {scene.moved(found.pair), scene.environment(found.pair), found.result};
}

struct BatchRow {
  double distance;
  std::int32_t other;
  bool colliding;
  double point[3], point_other[3];
};

/// The part, and all that it is checked against, by pairs whose tag is the other's number: a batch copies the scene,
/// and what addPairs() added has no index yet.
collision::Scene sceneOf(Scene& self, PartIndex part) {
  collision::Scene own;
  const PartIndex moved = own.addPart({0, 0}, self.scene.sharedCollider(part), self.scene.pose(part));
  for (PartIndex other = 0; other < self.present.size(); ++other) {
    if (!self.present[other] || other == part || !self.scene.pairOf(part, other)) continue;
    const PartIndex at = own.addPart({1, other}, self.scene.sharedCollider(other), self.scene.pose(other));
    own.addPair(moved, at, other);
  }
  return own;
}

BatchRow batchRowOf(const collision::Scene& scene, const std::optional<collision::PairDistance>& found, double limit) {
  if (!found) return {limit, -1, false, {}, {}};
  const dvec3 &p = found->result.p_WA, &other = found->result.p_WB;
  return {found->result.distance,
          static_cast<std::int32_t>(scene.tag(found->pair)),
          found->result.colliding,
          {p.x, p.y, p.z},
          {other.x, other.y, other.z}};
}

py::array distances(Scene& self, std::size_t number, py::handle poses, double limit, int threads) {
  const collision::Scene scene = sceneOf(self, self.part(number));
  const std::vector<Pose> X_WP = posesOf(poses);
  std::vector<BatchRow> rows;
  rows.reserve(X_WP.size());
  std::atomic<bool> stop{false};
  const auto measure = [&] {
    const auto batch = collision::nearestAtPoses(scene, 0, X_WP, {limit, false, threads, &stop});
    for (const auto& nearest : batch.nearest) rows.push_back(batchRowOf(scene, nearest, limit));
  };
  constexpr std::size_t kFew = 256;  // Poses that take some ms at most, less than a thread's start is worth. Half: the same.
  if (X_WP.size() <= kFew) {
    const py::gil_scoped_release unlocked;
    measure();
  } else {
    runLong(measure, [&] { stop = true; });
  }
  return structuredArray(std::move(rows), {{"distance", "f8", offsetof(BatchRow, distance)},
                                           {"other", "i4", offsetof(BatchRow, other)},
                                           {"colliding", "?", offsetof(BatchRow, colliding)},
                                           {"point", "(3,)f8", offsetof(BatchRow, point)},
                                           {"point_other", "(3,)f8", offsetof(BatchRow, point_other)}});
}

Sweep sweep(Scene& self, std::size_t number, py::handle pose, double clearance) {
  const PartIndex part = self.part(number);
  collision::MovedPart moved;
  moved.part = part;
  moved.motion = collision::straightMotion(self.scene.pose(part), poseOf(pose), self.scene.collider(part));
  const py::gil_scoped_release unlocked;
  const collision::SceneStop stop = self.scene.advance({&moved, 1}, clearance);
  Sweep made{stop.s, stop.stopped, stop.began_colliding, moved.motion.at(stop.s), std::nullopt};
  if (stop.stopped) made.nearest = named(self.scene, {stop.pair, stop.nearest});
  return made;
}

void bindResults(py::module_& module) {
  py::class_<ScenePairDistance>(module, "PartDistance", "The distance of two parts of a Scene.")
      .def_readonly("part", &ScenePairDistance::part, "Number of the part that is checked.")
      .def_readonly("other", &ScenePairDistance::other, "Number of the part that it is checked against.")
      .def_readonly("distance", &ScenePairDistance::distance, "A Distance: A is `part`, B is `other`.")
      .def("__float__", [](const ScenePairDistance& d) { return d.distance.distance; })
      .def("__repr__", [](const ScenePairDistance& d) {
        return py::str("<PartDistance {} to {}: {:.6g} m>").format(d.part, d.other, d.distance.distance);
      });
  py::class_<Sweep>(module, "Sweep", "Where a motion ends.")
      .def_readonly("share", &Sweep::share, "0 to 1: the motion is free up to here.")
      .def_readonly("stopped", &Sweep::stopped, "Something blocks the way.")
      .def_readonly("began_colliding", &Sweep::began_colliding, "It collided at the beginning.")
      .def_property_readonly(
          "pose", [](const Sweep& s) { return arrayOf(s.X_WP); }, "The part's pose there, shape (7,).")
      .def_readonly("nearest", &Sweep::nearest, "What stops it, a PartDistance; None unless stopped.")
      .def("__repr__", [](const Sweep& s) {
        return py::str("<Sweep {:.4f} of the way{}>").format(s.share, s.stopped ? ", stopped" : "");
      });
}

void bindQueries(py::class_<Scene>& scene) {
  scene
      .def(
          "nearest",
          [](Scene& self, double limit) -> std::optional<ScenePairDistance> {
            const auto found = self.scene.nearest(limit);
            if (!found) return std::nullopt;
            return named(self.scene, *found);
          },
          py::arg("limit") = kNoLimit,
          "The nearest checked pair, if any is nearer than `limit` (m); colliding ones first.")
      .def(
          "contacts",
          [](Scene& self, double margin) {
            std::vector<collision::PairDistance> found;
            {
              const py::gil_scoped_release unlocked;
              self.scene.pairsWithin(margin, found);
            }
            std::vector<ScenePairDistance> pairs;
            for (const auto& one : found) pairs.push_back(named(self.scene, one));
            return pairs;
          },
          py::arg("margin") = 1e-6,
          "All checked pairs nearer than `margin` (m), each with its exact distance, nearest first.")
      .def(
          "collides", [](Scene& self) { return self.scene.collides(); }, "Whether any checked pair collides.")
      .def(
          "distance",
          [](Scene& self, std::size_t part, std::size_t other) {
            const auto pair = self.scene.pairOf(self.part(part), self.part(other));
            if (pair) return named(self.scene, {*pair, self.scene.distance(*pair)});
            raise({.place = "pair", .found = "these parts are not checked", .expected = "a pair of check()"});
          },
          py::arg("part"), py::arg("other"), "The exact distance of one checked pair.")
      .def("distances", &distances, py::arg("part"), py::arg("poses"), py::arg("limit") = kNoLimit,
           py::arg("threads") = 0,
           "The nearest pair of one part at many poses X_WP of shape (n, 7) or (n, 4, 4), on all cores. The scene "
           "stays as it "
           "is.\n\nA structured array: distance (m; `limit` where nothing is nearer), other (part number, -1), "
           "colliding, "
           "point, point_other.")
      .def("sweep", &sweep, py::arg("part"), py::arg("pose"), py::arg("clearance") = 0.0,
           "How far the part gets on the straight way (rotation about a fixed axis) to `pose`, keeping `clearance` (m) "
           "from "
           "what it is checked against. Nothing is skipped, however thin. The scene stays as it is: move() the part "
           "there.");
}

}  // namespace

void bindScenes(py::module_& module) {
  bindResults(module);
  py::class_<Scene> scene(
      module, "Scene",
      "Meshes placed in the world W, and which of them are checked against which. Use one scene in one thread.");
  scene.def(py::init<>())
      .def(
          "add",
          [](Scene& self, const Mesh& mesh, py::handle pose) {
            const PartIndex part = self.scene.addPart({self.present.size() + 1, 0}, mesh.collider, poseOf(pose));
            if (part >= self.present.size()) self.present.resize(part + 1, false);
            self.present[part] = true;
            return part;
          },
          py::arg("mesh"), py::arg("pose") = py::none(), "Adds a mesh at X_WP; returns the part's number.")
      .def(
          "remove",
          [](Scene& self, std::size_t part) {
            self.scene.removePart(self.part(part));
            self.present[part] = false;
          },
          py::arg("part"), "Removes a part and its pairs.")
      .def(
          "check",
          [](Scene& self, const std::vector<std::size_t>& parts, const std::vector<std::size_t>& others) {
            self.scene.addPairs(self.parts(parts), self.parts(others));
          },
          py::arg("parts"), py::arg("others"), "Each of `parts` is checked against each of `others`, but not itself.")
      .def(
          "move",
          [](Scene& self, std::size_t part, py::handle pose) { self.scene.setPose(self.part(part), poseOf(pose)); },
          py::arg("part"), py::arg("pose"), "Places a part at X_WP.")
      .def(
          "pose", [](const Scene& self, std::size_t part) { return arrayOf(self.scene.pose(self.part(part))); },
          py::arg("part"), "X_WP, shape (7,).")
      .def("__len__", [](const Scene& self) { return std::count(self.present.begin(), self.present.end(), true); })
      .def("__repr__", [](const Scene& self) {
        return py::str("<Scene of {} parts>").format(std::count(self.present.begin(), self.present.end(), true));
      });
  bindQueries(scene);
}

}  // namespace hapticell::python
