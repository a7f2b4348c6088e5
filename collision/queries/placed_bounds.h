// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/trees/mesh_collider.h"
#include "collision/trees/oriented_box.h"
#include "geometry/shapes/bounds.h"
#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// What is known of a mesh at one place without a look at its triangles: its sphere and its root box, in the world.
struct PlacedBounds {
  dvec3 center_W{0.0};  ///< Of the sphere,
  double radius = 0.0;  ///< and its radius, m.
  OrientedBox root_W;
  dvec3 reach_W{0.0};  ///< Half sizes of the axis-aligned box around that box.

  geometry::Bounds box_W() const { return {root_W.center - reach_W, root_W.center + reach_W}; }
};

/// Of a mesh that is not empty; of an empty one only the sphere is set. Any thread.
PlacedBounds placedBounds(const MeshCollider& mesh, const Pose& X_WM);

/// Lower bounds (m) of the distance of the two meshes: by the spheres (negative where they overlap), and by the boxes.
double sphereGap(const PlacedBounds& a, const PlacedBounds& b);
double boxGap(const PlacedBounds& a, const PlacedBounds& b);

/// The same while A moves by any share from -1 to 1 of `sweep_W` (m).
double sweptSphereGap(const PlacedBounds& a, const PlacedBounds& b, const dvec3& sweep_W);
double sweptBoxGap(const PlacedBounds& a, const PlacedBounds& b, const dvec3& sweep_W);

}  // namespace hapticell::collision
