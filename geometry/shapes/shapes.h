// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::geometry {

// Watertight meshes of simple solids: welded, outward (counter-clockwise) triangles, metres, centred on the origin
// unless stated otherwise. Round shapes have their vertices on the true surface, so the mesh lies inside it. Contract:
// sizes are positive and segment counts at least 3. Callers check sizes that come from outside.

/// A box with edges `size` along x, y, z: 8 vertices, 12 triangles.
TriangleMesh makeBox(const dvec3& size);

/// A cylinder about z, from z = -height/2 to +height/2: 4 * segments triangles.
TriangleMesh makeCylinder(double radius, double height, int segments = 48);

/// A cone about z: base at z = -height/2, apex at z = +height/2: 2 * segments triangles.
TriangleMesh makeCone(double radius, double height, int segments = 48);

/// A truncated cone about z, from radius `bottom` at z = -height/2 to radius `top` at z = +height/2.
TriangleMesh makeFrustum(double bottom, double top, double height, int segments = 48);

/// A pipe about z (a plate with a round hole): 8 * segments triangles. Needs inner < outer.
TriangleMesh makePipe(double outer_radius, double inner_radius, double height, int segments = 48);

/// A sphere of `segments` meridians and segments/2 bands, poles on z: 2 * segments * (segments/2 - 1) triangles.
TriangleMesh makeSphere(double radius, int segments = 48);

/// A capsule about z: a cylinder of the given length with a hemisphere at either end (as in SDF and MuJoCo).
TriangleMesh makeCapsule(double radius, double length, int segments = 48);

/// A torus about z: a tube of radius `minor` around a circle of radius `major` (> minor).
TriangleMesh makeTorus(double major_radius, double minor_radius, int major_segments = 48, int minor_segments = 24);

/// A prism: the simple polygon `outline` (counter-clockwise, x y, metres, no point twice) extruded from z = 0 to
/// `height`. The polygon may be concave. Empty where the outline is not such a polygon.
TriangleMesh makePrism(std::span<const glm::dvec2> outline, double height);

/// Cuts a simple polygon (counter-clockwise, at least 3 points) into triangles by ear clipping (G. H. Meisters,
/// "Polygons have ears", 1975); indices into `outline`. Empty if no ear is left: the polygon crosses itself or turns
/// clockwise. `work`, if given, is the number of corners that may still be examined. It is counted down; at 0 the
/// result is empty. The worst polygon of n corners needs n^3 / 6.
std::vector<Triangle> triangulatePolygon(std::span<const glm::dvec2> outline, std::uint64_t* work = nullptr);

}  // namespace hapticell::geometry
