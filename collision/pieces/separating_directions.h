// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "collision/pieces/convex_pieces.h"
#include "geometry/shapes/pose.h"

namespace hapticell::collision {

/// A convex piece placed in the world.
struct PlacedPiece {
  const ConvexPiece* piece = nullptr;
  Pose X_MW;  ///< Pose of the world in the mesh's frame.
  std::vector<dvec3> vertices_W;
  std::vector<HullPlane> planes_W;
  std::vector<dvec3> beyond_W;
  geometry::Bounds bounds_W;
};

PlacedPiece placed(const ConvexPiece& piece, const Pose& X_W);

/// One pair of points that supports a separating direction: the moving body's point (or, where the normal moves, the
/// obstacle's point as if it belonged to the body) and its gap along the direction.
struct SupportPoint {
  dvec3 p_W{0.0};    ///< Moves with the body.
  dvec3 q_W{0.0};    ///< On the obstacle, or on the body's face if the normal moves.
  double gap = 0.0;  ///< Metres.
  bool normal_moves = false;
  std::uint32_t feature =
      0;  ///< Vertex of the moving piece (from 2^30: end of an edge); plus 2^31 for the obstacle.
};

enum class DirectionRank : std::uint8_t {
  kFace = 0,     ///< Faces and convex edges that the meshes have.
  kBeyond = 1,   ///< Faces of the mesh next to the piece.
  kVirtual = 2,  ///< Faces or edges that only close a piece; used if no other direction shows that a place is free.
};

/// A direction in which a moving piece A and an obstacle piece B are separated, or could become so.
struct SeparatingDirection {
  dvec3 nhat_W{0.0, 0.0, 1.0};  ///< Unit, from B towards A.
  double gap = 0.0;             ///< min over A of nhat.a - max over B of nhat.b, metres.
  DirectionRank rank = DirectionRank::kFace;
  std::uint32_t feature_A = 0;  ///< For ids: plane, edge or vertex number.
  std::uint32_t feature_B = 0;
  double tightened = 0.0;  ///< Metres to subtract from the gaps, because the direction replaces others that were left
                           ///< out.
  bool on_obstacle_face = false;  ///< A corner of A on a face of B; both may be true if faces are parallel.
  bool on_moving_face = false;    ///< A corner of B on a face of A; neither: two edges.
  SupportPoint support{};         ///< The point that determines the gap.
  std::vector<SupportPoint>
      supports{};  ///< Filled by completeSupports(): `support` and the points that turning could make relevant.
};

struct DirectionLimits {
  double reach = 0.0;         ///< Metres the body's points can move; directions with gap < -reach are left out.
  double max_rotation = 0.0;  ///< Radians; decides which other support points matter.
  std::size_t max_supports = 8;
};

/// The faces of the Minkowski difference of two convex pieces that a motion within the limits can meet (Gauss-map test
/// for edge pairs: Gregorius, "The separating axis test between convex polyhedra", GDC 2013), plus the planes beyond
/// the pieces' convex borders. After a translation d the pieces are apart exactly if some direction has gap + nhat . d
/// > 0. Every direction found is valid even if others were not found. Largest gap first; empty if the pieces are too
/// far apart to meet (or overlap so deeply that no face is near, see isInside()).
std::vector<SeparatingDirection> separatingDirections(const PlacedPiece& moving, const PlacedPiece& obstacle,
                                                      const DirectionLimits& limits);

/// Whether faces of each come within the reach of the other's box, or one is inside the other; false for most pairs
/// that cannot meet.
bool mayMeet(const PlacedPiece& moving, const PlacedPiece& obstacle, double reach);

/// Approximately the direction of the nearest points: its gap is never more than the distance, and close to it if the
/// pieces are apart. Ends early if the gap is above `enough`. Gilbert, "An iterative procedure for computing the
/// minimum of a quadratic form on a convex set" (1966), on the Minkowski difference. The result has rank kVirtual.
SeparatingDirection nearestDirection(const PlacedPiece& moving, const PlacedPiece& obstacle, double enough);

/// Whether some corner or the middle of one piece lies inside the other.
bool isInside(const PlacedPiece& moving, const PlacedPiece& obstacle);

/// Finds the further corners (and ends of edges at the rim of the neighbourhood) of a direction's faces.
void completeSupports(SeparatingDirection& direction, const PlacedPiece& moving, const PlacedPiece& obstacle,
                      const DirectionLimits& limits);

/// Keeps the first support and, of the others, those farthest apart.
void thinOut(std::vector<SupportPoint>& supports, std::size_t count);

}  // namespace hapticell::collision
