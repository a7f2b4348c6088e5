// SPDX-License-Identifier: Apache-2.0
// Reading STEP: the tree of parts, their places and their triangles. usage: read_step FILE.step
// The file is read by another process, hapticell-importer, so that what is broken in it is an error here and no more.
#include <workcell/scenes/import_monitor.h>
#include <workcell/scenes/import_scene.h>

#include <cstdio>
#include <string>
#include <vector>

using hapticell::Pose;
namespace workcell = hapticell::workcell;

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: read_step FILE.step\n");
    return 2;
  }
  workcell::ImportOptions options;
  options.tessellation.chord = 5e-5;  // m: how far a triangle may lie from the true face.
  workcell::ImportMonitor monitor;    // Another thread may ask it for the progress, or cancel by it.
  const auto scene = workcell::readScene(words[1], options, &monitor);
  if (!scene) {
    std::fprintf(stderr, "%s\n", scene.error().message().c_str());
    return 1;
  }
  for (const hapticell::Text& sentence : scene->warnings) std::fprintf(stderr, "note: %s\n", english(sentence).c_str());

  std::printf("%s, %g m per unit, %zu nodes\n", scene->format.c_str(), scene->metres_per_unit, scene->nodes.size());
  const std::vector<Pose> X_FN = workcell::nodePoses(*scene);
  const std::vector<std::string> paths = workcell::partPaths(*scene);
  for (std::size_t i = 0; i < scene->nodes.size(); ++i) {
    const workcell::SceneNode& node = scene->nodes[i];
    if (node.mesh < 0) continue;
    const hapticell::geometry::TriangleMesh& mesh = scene->meshes[static_cast<std::size_t>(node.mesh)];
    const hapticell::dvec3 size = mesh.bounds().max - mesh.bounds().min;
    std::printf("%s: %zu triangles, %.1f x %.1f x %.1f mm, at %.1f %.1f %.1f mm\n", paths[i].c_str(),
                mesh.triangles.size(), 1e3 * size.x, 1e3 * size.y, 1e3 * size.z, 1e3 * X_FN[i].p.x, 1e3 * X_FN[i].p.y,
                1e3 * X_FN[i].p.z);
  }
  return 0;
}
