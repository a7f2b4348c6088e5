// SPDX-License-Identifier: Apache-2.0
// How far the right hand of small and tall people reaches, standing, by the shoulder alone and with the trunk.
#include <geometry/shapes/triangle_mesh.h>
#include <mannequin/body/figure.h>
#include <mannequin/posture/posture.h>
#include <mannequin/posture/reach_envelope.h>

#include <algorithm>
#include <cstdio>

namespace geometry = hapticell::geometry;
namespace mannequin = hapticell::mannequin;

namespace {

/// The farthest points forward, to the side and upwards of the reach, metres; the feet stand at the origin.
hapticell::dvec3 farthest(const mannequin::Figure& figure, bool with_trunk) {
  const auto standing = mannequin::libraryPosture(figure, "standing");
  mannequin::ReachOptions options;
  options.with_trunk = with_trunk;
  options.meridians = 12;
  // A closed surface in the world: it can be drawn, checked for collisions, or measured as here.
  const geometry::TriangleMesh reach = mannequin::reachEnvelope(figure, *standing, mannequin::Side::kRight, options);
  hapticell::dvec3 most(0.0);
  for (const hapticell::dvec3& p_WQ : reach.vertices) {
    most.x = std::max(most.x, p_WQ.x);
    most.y = std::max(most.y, -p_WQ.y);  // y points to the left.
    most.z = std::max(most.z, p_WQ.z);
  }
  return most;
}

}  // namespace

int main() {
  std::printf("figure  stature   shoulder alone: forward  right  up      with the trunk: forward  right  up (m)\n");
  for (const mannequin::NamedFigure& one : mannequin::boundaryFigures()) {
    const hapticell::dvec3 arm = farthest(one.figure, false), body = farthest(one.figure, true);
    std::printf("%-6s  %5.3f     %21.2f %6.2f %5.2f   %22.2f %6.2f %5.2f\n", one.name.c_str(),
                one.figure.body[mannequin::Dimension::kStature], arm.x, arm.y, arm.z, body.x, body.y, body.z);
  }

  // A figure of one's own: any stature between 1.2 and 2.3 m, and single measures where they are known.
  const auto own = mannequin::makeFigure({.sex = mannequin::Sex::kFemale, .stature = 1.70});
  if (!own) {
    std::fprintf(stderr, "%s\n", own.error().message().c_str());
    return 1;
  }
  std::printf("a woman of 1.70 m grasps up to %.2f m above the floor\n", farthest(*own, false).z);
  return 0;
}
