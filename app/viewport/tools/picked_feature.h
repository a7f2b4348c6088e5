// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "collision/surfaces/recognised_surface.h"
#include "geometry/shapes/pose.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

/// The picked kind of feature. A vertex is preferred to an edge, an edge to a face, if the pointer is near enough.
enum class FeatureKind { kFace, kEdge, kVertex };

/// The kinds that may be picked.
struct FeatureFilter {
  bool faces = true, edges = true, vertices = true;
};

enum class EdgeShape { kLine, kCircle, kCurve };

/// A face, an edge or a corner under the pointer; a value, all in the world frame W, with the part at its pose at the
/// time of the pick.
///
/// Faces: `surface_W` is the recognised surface (kFreeForm if it is not a CAD surface). Edges: `edge`, and for lines
/// and circles `center_W`, `axis_W` (unit), for circles also `radius`. featureFrame_W() makes a frame of any of them
/// with z along the normal, axis or direction.
struct PickedFeature {
  FeatureKind kind = FeatureKind::kFace;
  workcell::EntityId entity = 0;
  int link = -1;  ///< For robots, mechanisms, mannequins: index of the link; -1 for solids.
  std::shared_ptr<const geometry::TriangleMesh> mesh;  ///< The shape that was hit,
  Pose X_WM;                                           ///< its pose,
  std::uint32_t triangle = 0;                          ///< and which triangle of it.
  dvec3 p_WHit{0.0};                                   ///< On the face, exactly under the pointer.
  dvec3 p_WQ{0.0};                                     ///< Snapped: on the edge, or the corner; faces: p_WHit.
  dvec3 nhat_W{0.0, 0.0, 1.0};                         ///< Unit normal of the face at p_WHit, towards the eye.
  collision::SurfaceShape surface_W{.type = collision::SurfaceType::kFreeForm};
  EdgeShape edge = EdgeShape::kCurve;
  dvec3 center_W{0.0}, axis_W{0.0, 0.0, 1.0};
  double radius = 0.0;
  std::vector<std::vector<dvec3>> outline_W;  ///< For drawing: the edge, or the borders of the face, as polylines.
};

/// Origin and axes of the geometry: z is the normal of a plane (towards the eye), the axis of a cylinder, cone, torus
/// or circle, the direction of a straight edge, W's z at a corner, sphere or free form. The origin is the snapped
/// point, moved onto the axis (or to the centre) if there is one.
Pose featureFrame_W(const PickedFeature& feature);

/// "Cylinder, R 25.0 mm", "Edge, 120.0 mm", "Corner": for picking hints and fields.
std::string featureText(const PickedFeature& feature);

}  // namespace hapticell::app
