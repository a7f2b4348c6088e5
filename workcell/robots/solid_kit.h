// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "geometry/shapes/triangle_mesh.h"
#include "kinematics/model/robot_model.h"

namespace hapticell::workcell {

/// Watertight castings, prisms and turned parts for the bodies of the built-in robots. Metres.
namespace solid {

using Outline = std::vector<glm::dvec2>;

/// Rotates (radius, z) points about z: from the axis at the bottom, up the outside, to the axis at the top.
geometry::TriangleMesh lathe(const Outline& profile, int segments);
/// A cylinder about z with chamfered ends.
geometry::TriangleMesh cylinder(double radius, double z0, double z1, double chamfer, int segments);
/// A cylinder with round ends, whose centres are at z0 and z1.
geometry::TriangleMesh capsule(double radius0, double radius1, double z0, double z1, int segments);
/// A counter-clockwise outline from z0 to z1 with chamfered edges.
geometry::TriangleMesh prism(const Outline& outline, double z0, double z1, double chamfer);
geometry::TriangleMesh box(const dvec3& least, const dvec3& most, double chamfer);

/// The outline about two circles (a link seen from its side).
Outline belt(const glm::dvec2& p0, double r0, const glm::dvec2& p1, double r1, int steps);
Outline roundedRectangle(double width, double depth, double radius, int steps);

/// Poses that place shapes made about z or in the x-y plane: z to x, z to y, and a plate upright, (x, y, z) to (x, -z,
/// y).
Pose alongX(const dvec3& p = dvec3(0.0));
Pose alongY(const dvec3& p = dvec3(0.0));
Pose upright(const dvec3& p = dvec3(0.0));
/// Turns z to the direction.
Pose along(const dvec3& p, const dvec3& direction);

}  // namespace solid

using PaintColor = std::array<float, 4>;

/// Collects the parts of links, one shape per colour; fine ones for drawing, coarse ones for checks.
class BodyMaker {
 public:
  explicit BodyMaker(kinematics::RobotModel& model) : model_(model) {}
  ~BodyMaker() { flush(); }
  BodyMaker(const BodyMaker&) = delete;
  BodyMaker& operator=(const BodyMaker&) = delete;

  /// From now on, adds parts to this link.
  void link(int index);
  void link(const std::string& name) { link(model_.findLink(name)); }

  /// Segments of a full circle, and chamfers, for the drawn or the checked shape.
  struct Detail {
    int segments = 40;
    int steps = 14;
    double chamfer = 1.0;
    bool fine = true;
  };
  /// Calls `make(detail)` twice, for the visual and for the collision shape. `placed` is relative to the link's frame.
  template <typename Make>
  void add(const PaintColor& color, const Pose& placed, const Make& make) {
    append(color, make(Detail{}), placed);
    geometry::append(collision_, make(Detail{14, 4, 0.0, false}), placed);
  }
  /// For drawing only: bolts, caps, bands.
  template <typename Make>
  void decorate(const PaintColor& color, const Pose& placed, const Make& make) {
    append(color, make(Detail{24, 8, 1.0, true}), placed);
  }

 private:
  void append(const PaintColor& color, const geometry::TriangleMesh& mesh, const Pose& placed);
  void flush();

  kinematics::RobotModel& model_;
  int link_ = -1;
  std::vector<std::pair<PaintColor, geometry::TriangleMesh>> visual_;
  geometry::TriangleMesh collision_;
};

}  // namespace hapticell::workcell
