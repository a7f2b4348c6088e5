// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/triangle_mesh.h"

namespace hapticell::geometry {

/// Volume integrals of the solid that a mesh encloses, in the mesh's frame M, for density 1 kg/m3.
struct MassProperties {
  double volume = 0.0;     ///< m3; negative when the triangles face inward.
  double area = 0.0;       ///< m2, of the surface.
  dvec3 p_MC{0.0};         ///< Centre of the volume; of the surface where the volume is zero (an open or flat mesh).
  dmat3 inertia_C_M{0.0};  ///< About C, along M's axes, m5 (times density: kg m2); for |volume|.
  bool closed =
      false;  ///< Each edge is used equally often in both directions; only then is `volume` meaningful.
};

/// Integrates over the surface by the divergence theorem (one signed tetrahedron from the bounds' centre per triangle).
/// Weld the mesh first: otherwise shared edges do not count as shared, and `closed` is false. An empty mesh gives
/// zeros.
MassProperties massProperties(const TriangleMesh& mesh);

/// MassProperties::volume alone, in a tenth of the time.
double enclosedVolume(const TriangleMesh& mesh);

/// True when each edge is used equally often in both directions: the surface of a solid, without border.
bool isClosed(const TriangleMesh& mesh);

}  // namespace hapticell::geometry
