// SPDX-License-Identifier: Apache-2.0
#include "bench/pqp_peer.h"

#include <PQP.h>

namespace hapticell::bench {

namespace {

void fill(PQP_Model& model, const geometry::TriangleMesh& mesh) {
  model.BeginModel(static_cast<int>(mesh.triangles.size()));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    PQP_REAL corners[3][3];
    for (int k = 0; k < 3; ++k) {
      const dvec3 corner = mesh.corner(static_cast<std::uint32_t>(i), k);
      for (int axis = 0; axis < 3; ++axis) corners[k][axis] = corner[axis];
    }
    model.AddTri(corners[0], corners[1], corners[2], static_cast<int>(i));
  }
  model.EndModel();
}

/// A pose as PQP takes it.
struct Placed {
  explicit Placed(const Pose& X) {
    const dmat3 of = X.R();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) R[row][column] = of[column][row];
      p[row] = X.p[row];
    }
  }
  PQP_REAL R[3][3], p[3];
};

}  // namespace

struct PqpPeer::Models {
  PQP_Model moved, standing;
};

PqpPeer::PqpPeer(const geometry::TriangleMesh& moved, const geometry::TriangleMesh& standing)
    : models_(std::make_unique<Models>()) {
  fill(models_->moved, moved);
  fill(models_->standing, standing);
}

PqpPeer::~PqpPeer() = default;

double PqpPeer::distance(const Pose& X_WM, int queue) {
  Placed moved(X_WM), standing(Pose::identity());
  PQP_DistanceResult result;
  PQP_Distance(&result, moved.R, moved.p, &models_->moved, standing.R, standing.p, &models_->standing, 0.0, 0.0,
               queue);
  return result.Distance();
}

bool PqpPeer::isWithin(const Pose& X_WM, double tolerance) {
  Placed moved(X_WM), standing(Pose::identity());
  PQP_ToleranceResult result;
  PQP_Tolerance(&result, moved.R, moved.p, &models_->moved, standing.R, standing.p, &models_->standing, tolerance);
  return result.CloserThanTolerance() != 0;
}

bool PqpPeer::collides(const Pose& X_WM) {
  Placed moved(X_WM), standing(Pose::identity());
  PQP_CollideResult result;
  PQP_Collide(&result, moved.R, moved.p, &models_->moved, standing.R, standing.p, &models_->standing,
              PQP_FIRST_CONTACT);
  return result.NumPairs() > 0;
}

void PqpPeer::forget() {
  models_->moved.last_tri = models_->moved.tris;
  models_->standing.last_tri = models_->standing.tris;
}

}  // namespace hapticell::bench
