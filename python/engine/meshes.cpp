// SPDX-License-Identifier: Apache-2.0
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <cmath>
#include <optional>

#include "collision/queries/contact_regions.h"
#include "collision/queries/motion_check.h"
#include "collision/queries/proximity_query.h"
#include "geometry/shapes/mass_properties.h"
#include "geometry/shapes/shapes.h"
#include "python/engine/bindings.h"
#include "python/engine/conversion.h"
#include "python/engine/mesh_binding.h"
#include "python/engine/structured_array.h"
#include "workcell/files/scene_export.h"
#include "workcell/meshes/length_unit.h"
#include "workcell/scenes/whole_mesh.h"

namespace hapticell::python {

namespace {

using collision::MeshCollider;
using geometry::TriangleMesh;

Mesh built(const TriangleMesh& mesh, std::string name) {
  const py::gil_scoped_release unlocked;
  return {MeshCollider::build(mesh), std::move(name)};
}

dvec3 cornerOf(const double* v) {
  const dvec3 corner(v[0], v[1], v[2]);
  if (std::isfinite(corner.x + corner.y + corner.z)) return corner;
  raise({.place = "vertices", .found = "a number that is not finite", .expected = "finite metres"});
}

Mesh meshOfArrays(py::handle vertices, py::handle triangles) {
  const Doubles points = doublesOf(vertices, "vertices");
  const auto faces = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(triangles);
  if (!faces) PyErr_Clear();
  if (points.ndim() != 2 || points.shape(1) != 3 || !faces || faces.ndim() != 2 || faces.shape(1) != 3) {
    raise({.place = "mesh",
           .found = "arrays of other shapes",
           .expected = "vertices of shape (n, 3) and triangles of shape (m, 3)"});
  }
  TriangleMesh mesh;
  for (py::ssize_t i = 0; i < points.shape(0); ++i) mesh.vertices.push_back(cornerOf(points.data() + 3 * i));
  const auto index = [&](std::int64_t corner) {
    if (corner >= 0 && corner < points.shape(0)) return static_cast<std::uint32_t>(corner);
    raise({.place = "triangles",
           .found = Text("the vertex %1", corner),
           .expected = Text("indices from 0 to %1", points.shape(0) - 1)});
  };
  for (py::ssize_t i = 0; i < faces.shape(0); ++i) {
    const std::int64_t* const f = faces.data() + 3 * i;
    mesh.triangles.push_back({index(f[0]), index(f[1]), index(f[2])});
  }
  return built(mesh, "mesh");
}

Mesh loadMesh(py::object file, const std::optional<std::string>& unit) {
  const std::string path = pathOf(file);
  workcell::ImportOptions options;
  options.weld = false;  // As `distance` reads it: corners stay where they are.
  if (unit) options.metres_per_unit = workcell::metresPer(valueOf(workcell::parseLengthUnit(*unit)));
  Diagnostics diagnostics;
  Expected<TriangleMesh> mesh = [&] {
    const py::gil_scoped_release unlocked;
    return workcell::readWholeMesh(path, options, diagnostics);
  }();
  tellWarnings(diagnostics.warnings);
  return built(valueOf(std::move(mesh)), std::filesystem::path(path).stem().string());
}

void saveMesh(const Mesh& mesh, py::object file) {
  workcell::ImportedScene scene;
  scene.meshes.push_back(mesh.collider->mesh());
  workcell::SceneNode node;
  node.name = mesh.name;
  node.mesh = 0;
  scene.nodes.push_back(node);
  Diagnostics diagnostics;
  valueOf(workcell::exportScene(scene, pathOf(file), {}, diagnostics));
  tellWarnings(diagnostics.warnings);
}

double positive(double size, const char* what) {
  if (std::isfinite(size) && size > 0.0) return size;
  raise({.place = Text::plain(what), .found = Text::plain(std::to_string(size)), .expected = "metres above 0"});
}

int segmentsOf(int segments) {
  if (segments >= 3 && segments <= 100000) return segments;
  raise({.place = "segments", .found = Text("%1", segments), .expected = "3 to 100 000"});
}

/// What a scene's batch has for a pose, and what distances() returns.
struct DistanceRow {
  double distance;
  bool colliding, contained;
  double point_a[3], point_b[3], normal[3];
};

DistanceRow rowOf(const Distance& result) {
  DistanceRow row{result.distance, result.colliding, result.contained, {}, {}, {}};
  put(result.p_WA, row.point_a);
  put(result.p_WB, row.point_b);
  put(result.nhat_BA_W, row.normal);
  return row;
}

/// Calls of one pair, warm, for many poses; without the lock, but looks for Ctrl+C.
py::array distancesOf(collision::ProximityQuery& pair, py::handle poses, py::handle pose_b) {
  const std::vector<Pose> X_WA = posesOf(poses);
  const Pose X_WB = poseOf(pose_b);
  std::vector<DistanceRow> rows(X_WA.size());
  constexpr std::size_t kPiece = 4096;  // Queries between two looks at signals: some ms. Half and twice: the same.
  for (std::size_t begin = 0; begin < rows.size(); begin += kPiece) {
    {
      const py::gil_scoped_release unlocked;
      const std::size_t end = std::min(rows.size(), begin + kPiece);
      for (std::size_t i = begin; i < end; ++i) rows[i] = rowOf(pair.distance(X_WA[i], X_WB));
    }
    checkSignals();
  }
  return structuredArray(std::move(rows), {{"distance", "f8", offsetof(DistanceRow, distance)},
                                           {"colliding", "?", offsetof(DistanceRow, colliding)},
                                           {"contained", "?", offsetof(DistanceRow, contained)},
                                           {"point_a", "(3,)f8", offsetof(DistanceRow, point_a)},
                                           {"point_b", "(3,)f8", offsetof(DistanceRow, point_b)},
                                           {"normal", "(3,)f8", offsetof(DistanceRow, normal)}});
}

void bindDistance(py::module_& module) {
  py::class_<Distance>(
      module, "Distance",
      "Distance and nearest points of two meshes A and B, in the world: metres. float(d) is the distance.")
      .def_readonly("distance", &Distance::distance, "Metres; 0 when touching or intersecting.")
      .def_readonly("colliding", &Distance::colliding, "Touching, intersecting, or one inside the other's solid.")
      .def_readonly("contained", &Distance::contained, "Surfaces are apart, but one is inside the other's solid.")
      .def_property_readonly(
          "point_a", [](const Distance& d) { return arrayOf(d.p_WA); }, "Nearest point on A, shape (3,).")
      .def_property_readonly(
          "point_b", [](const Distance& d) { return arrayOf(d.p_WB); }, "Nearest point on B, shape (3,).")
      .def_property_readonly(
          "normal", [](const Distance& d) { return arrayOf(d.nhat_BA_W); }, "Unit vector from B towards A, shape (3,).")
      .def_readonly("triangle_a", &Distance::triangle_A, "Index of the triangle of A that has the nearest point.")
      .def_readonly("triangle_b", &Distance::triangle_B, "Index of the triangle of B that has the nearest point.")
      .def("__float__", [](const Distance& d) { return d.distance; })
      .def("__repr__", [](const Distance& d) {
        return py::str("<Distance {:.6g} m{}>").format(d.distance, d.colliding ? ", colliding" : "");
      });
}

void bindPair(py::module_& module) {
  using collision::ProximityQuery;
  py::class_<ProximityQuery>(
      module, "Pair",
      "Two meshes A and B that are asked again and again: each query starts from the last answer.\n\n"
      "Poses are X_WA and X_WB: None (identity), x, y, z, qw, qx, qy, qz, or a 4 x 4 matrix.")
      .def(py::init(
               [](const Mesh& a, const Mesh& b) { return std::make_unique<ProximityQuery>(a.collider, b.collider); }),
           py::arg("a"), py::arg("b"))
      .def(
          "distance",
          [](ProximityQuery& pair, py::handle pose_a, py::handle pose_b, double limit) {
            return pair.distance(poseOf(pose_a), poseOf(pose_b), limit);
          },
          py::arg("pose_a") = py::none(), py::arg("pose_b") = py::none(), py::arg("limit") = kNoLimit,
          "The exact distance (m) and the nearest points. From `limit` on, a bound is enough.")
      .def("distances", &distancesOf, py::arg("poses"), py::arg("pose_b") = py::none(),
           "The distances at many poses X_WA of shape (n, 7) or (n, 4, 4), one after the other.\n\n"
           "A structured array: distance, colliding, contained, point_a, point_b, normal.")
      .def(
          "collides",
          [](ProximityQuery& pair, py::handle pose_a, py::handle pose_b) {
            return pair.collides(poseOf(pose_a), poseOf(pose_b));
          },
          py::arg("pose_a") = py::none(), py::arg("pose_b") = py::none(),
          "Whether the surfaces touch or intersect, or one is inside the other's solid.")
      .def(
          "within",
          [](ProximityQuery& pair, double margin, py::handle pose_a, py::handle pose_b) {
            return pair.within(poseOf(pose_a), poseOf(pose_b), margin);
          },
          py::arg("margin"), py::arg("pose_a") = py::none(), py::arg("pose_b") = py::none(),
          "Whether the distance is `margin` (m) or less.")
      .def("__repr__", [](const ProximityQuery& pair) {
        return py::str("<Pair of {} and {} triangles>")
            .format(pair.a().mesh().triangles.size(), pair.b().mesh().triangles.size());
      });
}

void bindShapes(py::class_<Mesh>& mesh) {
  mesh.def_static(
          "box",
          [](double x, double y, double z) {
            return built(geometry::makeBox({positive(x, "x"), positive(y, "y"), positive(z, "z")}), "box");
          },
          py::arg("x"), py::arg("y"), py::arg("z"), "A box with edges x, y, z (m), centred on the origin.")
      .def_static(
          "cylinder",
          [](double radius, double height, int segments) {
            return built(
                geometry::makeCylinder(positive(radius, "radius"), positive(height, "height"), segmentsOf(segments)),
                "cylinder");
          },
          py::arg("radius"), py::arg("height"), py::arg("segments") = 48,
          "A cylinder about z (m), centred on the origin.")
      .def_static(
          "sphere",
          [](double radius, int segments) {
            return built(geometry::makeSphere(positive(radius, "radius"), segmentsOf(segments)), "sphere");
          },
          py::arg("radius"), py::arg("segments") = 48, "A sphere of `segments` meridians (m).")
      .def_static(
          "torus",
          [](double major, double minor) {
            if (!(positive(minor, "minor") < positive(major, "major")))
              raise({.place = "minor", .found = "it is not less than the major radius", .expected = "a thinner tube"});
            return built(geometry::makeTorus(major, minor), "torus");
          },
          py::arg("major"), py::arg("minor"),
          "A tube of radius `minor` around a circle of radius `major` about z (m).");
}

void bindMesh(py::module_& module) {
  py::class_<Mesh> bound(module, "Mesh",
                         "A triangle mesh prepared for distances: metres, in its own frame. It does not change.\n\n"
                         "Mesh(vertices, triangles) takes arrays of shape (n, 3) and (m, 3); counter-clockwise "
                         "triangles face outwards. Raises "
                         "Error for other shapes, indices out of range and numbers that are not finite.");
  bound.def(py::init(&meshOfArrays), py::arg("vertices"), py::arg("triangles"))
      .def_static("load", &loadMesh, py::arg("file"), py::arg("unit") = py::none(),
                  "All of a mesh or CAD file as one mesh. `unit`: m, mm or in; None: as the file says, else metres.")
      .def("save", &saveMesh, py::arg("file"), "Writes STL, OBJ, PLY, OFF, glTF or STEP, by the file's name.")
      .def_property_readonly(
          "vertices",
          [](py::object self) {
            const auto& mesh = self.cast<const Mesh&>().collider->mesh();
            return viewOf(py::dtype::of<double>(), {static_cast<py::ssize_t>(mesh.vertices.size()), 3},
                          mesh.vertices.data(), self);
          },
          "Shape (n, 3), metres: a view, not a copy.")
      .def_property_readonly(
          "triangles",
          [](py::object self) {
            const auto& mesh = self.cast<const Mesh&>().collider->mesh();
            return viewOf(py::dtype::of<std::uint32_t>(), {static_cast<py::ssize_t>(mesh.triangles.size()), 3},
                          mesh.triangles.data(), self);
          },
          "Shape (m, 3), indices of vertices: a view, not a copy.")
      .def_property_readonly(
          "bounds",
          [](const Mesh& self) {
            const geometry::Bounds& bounds = self.collider->bounds();
            py::array_t<double> array({2, 3});
            for (int i = 0; i < 3; ++i) array.mutable_at(0, i) = bounds.min[i], array.mutable_at(1, i) = bounds.max[i];
            return array;
          },
          "Least and greatest x, y, z: shape (2, 3), metres.")
      .def_property_readonly(
          "closed", [](const Mesh& self) { return self.collider->isClosed(); },
          "Whether every connected piece encloses a volume.")
      .def_property_readonly(
          "volume", [](const Mesh& self) { return geometry::enclosedVolume(self.collider->mesh()); }, "m3")
      .def_readwrite("name", &Mesh::name)
      .def(
          "contains",
          [](const Mesh& self, py::handle point) { return self.collider->contains(pointOf(point, "point")); },
          py::arg("point"), "Whether the point (m, in the mesh's frame) lies inside a closed piece.")
      .def(
          "distance",
          [](const Mesh& a, const Mesh& b, py::handle pose, py::handle other_pose, double limit) {
            return collision::distance(a.collider, poseOf(pose), b.collider, poseOf(other_pose), limit);
          },
          py::arg("other"), py::arg("pose") = py::none(), py::arg("other_pose") = py::none(),
          py::arg("limit") = kNoLimit, "Distance to another mesh, asked once; for many poses use Pair or Scene.")
      .def(
          "contact_regions",
          [](const Mesh& a, const Mesh& b, double zone, py::handle pose, py::handle other_pose) {
            const Pose X_AB = poseOf(pose).inverse() * poseOf(other_pose);
            const py::gil_scoped_release unlocked;
            return collision::countContactRegions(*a.collider, *b.collider, X_AB, zone);
          },
          py::arg("other"), py::arg("zone"), py::arg("pose") = py::none(), py::arg("other_pose") = py::none(),
          "How many separate places of both are within `zone` (m) of each other.")
      .def("__repr__", [](const Mesh& self) {
        return py::str("<Mesh '{}': {} triangles>").format(self.name, self.collider->mesh().triangles.size());
      });
  bindShapes(bound);
}

}  // namespace

void bindMeshes(py::module_& module) {
  bindDistance(module);
  bindMesh(module);
  bindPair(module);
}

}  // namespace hapticell::python
