// SPDX-License-Identifier: Apache-2.0
// Recognition of surfaces and contacts in a zone, beside the distance query at the same poses.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "collision/contacts/contact_finder.h"
#include "collision/queries/proximity_query.h"
#include "collision/surfaces/surface_recognition.h"
#include "geometry/shapes/shapes.h"
#include "workcell/meshes/mesh_reader.h"

namespace {

using namespace hapticell;

double microseconds() {
  return 1e-3 * static_cast<double>(std::chrono::steady_clock::now().time_since_epoch().count());
}

double share(std::vector<double> times, double part) {
  std::sort(times.begin(), times.end());
  return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
}

struct Scene {
  std::string name;
  geometry::TriangleMesh moving, environment;
  Pose start;
  dvec3 way;  ///< m, slid along in 1000 steps.
};

geometry::TriangleMesh fromFile(const std::filesystem::path& path, double scale) {
  Diagnostics diagnostics;
  workcell::MeshReadOptions options;
  options.scale = scale;
  auto mesh = workcell::readMesh(path, options, diagnostics);
  return mesh ? std::move(*mesh) : geometry::TriangleMesh{};
}

void recognise(const std::string& name, const geometry::TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return;
  double least = 1e300;
  double known = 0.0;
  for (int i = 0; i < 3; ++i) {
    const std::clock_t start = std::clock();
    const auto surface = collision::recogniseSurfaces(mesh);
    least = std::min(least, 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    known = surface.recognisedShare();
  }
  const auto count = static_cast<double>(mesh.triangles.size());
  std::printf("| %s | %zu | %.1f | %.0f | %.2f |\n", name.c_str(), mesh.triangles.size(), 100.0 * known, 1e-3 * least,
              1e-6 * least / count * 1e5);
}

void slide(const Scene& scene) {
  constexpr int kSteps = 1000;
  if (scene.moving.triangles.empty() || scene.environment.triangles.empty()) return;
  const auto moving = collision::SurfaceModel::build(scene.moving);
  const auto environment = collision::SurfaceModel::build(scene.environment);
  const collision::ZonePart fixed{nullptr, Pose::identity(), 2, 0.0, environment.get()};
  collision::ProximityQuery query(collision::MeshCollider::build(scene.moving),
                                  collision::MeshCollider::build(scene.environment));
  collision::ContactFinder contacts{collision::ContactFinder::Ways::kSurfaces};
  collision::ZoneOptions options;
  options.max_rotation = 0.1;
  std::vector<double> distance(kSteps, 1e300), warm(kSteps, 1e300), first(kSteps, 0.0);
  double zone = 1e300;
  std::size_t entries = 0;
  for (int walk = 0; walk < 4; ++walk) {
    for (int i = 0; i < kSteps; ++i) {
      const auto at = static_cast<std::size_t>(i);
      Pose X = scene.start;
      X.p += scene.way * (static_cast<double>(i) / kSteps);
      const double start = microseconds();
      query.distance(X, Pose::identity());
      const double middle = microseconds();
      const collision::ZonePart held{nullptr, X, 1, 0.0, moving.get()};
      const auto found = contacts.find({&held, 1}, {&fixed, 1}, options);
      const double end = microseconds();
      if (walk == 0) {
        first[at] = end - middle;
        continue;
      }
      distance[at] = std::min(distance[at], middle - start);
      warm[at] = std::min(warm[at], end - middle);
      zone = std::min(zone, found.complete ? found.radius : 0.0);
      entries = std::max(entries, found.contacts.size());
    }
  }
  std::printf("| %s | %.1f / %.1f | %.1f / %.1f | %.1f | %.1f / %.1f | %zu | %.1f |\n", scene.name.c_str(),
              share(distance, 0.5), share(distance, 0.99), share(warm, 0.5), share(warm, 0.99),
              share(warm, 0.5) / share(distance, 0.5), 1e-3 * share(first, 0.99), 1e-3 * share(first, 1.0), entries,
              1e3 * zone);
}

}  // namespace

int main(int count, char** words) {
  const std::filesystem::path data = count > 1 ? words[1] : "../shared/data";
  const auto hole = fromFile(data / "cad/obj/factory_round_hole_8mm_subdiv_3x.obj", 1.0);
  const auto peg = fromFile(data / "cad/obj/factory_round_peg_8mm_tight.obj", 1.0);
  const auto gear = fromFile(data / "cad/obj/industreal_gear_base.obj", 1.0);
  const auto pulley = fromFile(data / "cad/stl/odri_transmission_pulley_at3_t30_output.stl", 0.001);
  const auto shell = fromFile(data / "cad/stl/odri_hip_aa_module_shell_base.stl", 0.001);
  std::puts("| mesh | triangles | recognised % | ms | s for 100 000 triangles |\n| --- | --- | --- | --- | --- |");
  recognise("torus, 100 000", geometry::makeTorus(0.05, 0.01, 250, 200));
  recognise("gear base", gear);
  recognise("peg", peg);
  recognise("pulley", pulley);
  recognise("hip shell", shell);
  // Robots' collision shapes are convex hulls of castings: hardly anything of them is a surface.
  for (const char* link : {"base_link", "link_1", "link_2", "link_3"}) {
    const std::string file =
        std::string("robots/kuka_kr120r2500pro/kuka_kr120_support/meshes/kr120r2500pro/collision/") + link + ".stl";
    recognise("KUKA KR 120, hull of " + std::string(link), fromFile(data / file, 1.0));
  }
  std::puts(
      "\n| scene | distance us p50 / p99 | warm us p50 / p99 | warm / distance | first ms p99 / max | entries | zone "
      "mm |");
  std::puts("| --- | --- | --- | --- | --- | --- | --- |");
  const auto plate = geometry::makeBox({0.4, 0.4, 0.02});
  slide(
      {"box along a plate", geometry::makeBox(dvec3(0.04)), plate, Pose::translation({-0.1, 0, 0.0305}), {0.2, 0, 0}});
  slide(
      {"ball along a plate", geometry::makeSphere(0.02, 64), plate, Pose::translation({-0.1, 0, 0.0305}), {0.2, 0, 0}});
  slide({"cylinder over a cylinder",
         geometry::makeCylinder(0.01, 0.1, 64),
         geometry::makeCylinder(0.02, 0.2, 96),
         {dvec3(0.0305, 0, -0.05), quaternionFromRotationVector({1.5, 0, 0})},
         {0, 0, 0.1}});
  slide({"peg in its hole", peg, hole, Pose::translation({0, 0, 0.006}), {0.00002, 0, 0.01}});
  slide({"box over the gear base",
         geometry::makeBox(dvec3(0.02)),
         gear,
         {dvec3(-0.03, 0.0, 0.05), quaternionFromRotationVector({0.1, 0.05, 0})},
         {0.06, 0, 0}});
  slide({"box over the pulley",
         geometry::makeBox(dvec3(0.02)),
         pulley,
         {dvec3(-0.03, 0.0, 0.05), quaternionFromRotationVector({0.1, 0.05, 0})},
         {0.06, 0, 0}});
  slide({"box over the hip shell",
         geometry::makeBox(dvec3(0.02)),
         shell,
         {dvec3(0.0, 0.0, 0.08), quaternionFromRotationVector({0.1, 0.05, 0})},
         {0.06, 0.02, 0}});
  return 0;
}
