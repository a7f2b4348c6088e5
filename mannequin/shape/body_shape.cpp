// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/body_shape.h"

#include <algorithm>
#include <cmath>

#include "mannequin/shape/blob_distance.h"
#include "mannequin/shape/surface_nets.h"

namespace hapticell::mannequin {

namespace {

using S = Segment;

/// About the distance to a blob; `across` is the way from its axis in its own measure.
double distanceTo(const Blob& blob, const dvec3& p, dvec3& across) {
  const dvec3 along = (blob.b - blob.a) / blob.stretch, from = (p - blob.a) / blob.stretch;
  const double square = glm::dot(along, along);
  const double t = square > 1e-12 ? std::clamp(glm::dot(from, along) / square, 0.0, 1.0) : 0.0;
  const double least = std::min({blob.stretch.x, blob.stretch.y, blob.stretch.z});
  across = from - t * along;
  return least * (glm::length(across) - (blob.ra + t * (blob.rb - blob.ra)));
}

}  // namespace

double distanceTo(const Blob& blob, const dvec3& p) {
  dvec3 across;
  return distanceTo(blob, p, across);
}

double blended(double a, double b, double k) {
  const double h = std::max(0.0, k - std::abs(a - b)) / k;
  return std::min(a, b) - 0.25 * h * h * k;
}

double Flesh::distance(const dvec3& p) const {
  dvec3 outward;
  return distance(p, outward);
}

double Flesh::distance(const dvec3& p, dvec3& outward) const {
  dvec3 across;
  double d = 1e9, least = 1e9;
  outward = dvec3(0.0);
  for (const Blob& blob : blobs) {
    const double own = distanceTo(blob, p, across);
    const double softness = blob.blend < 0.0 ? blend : blob.blend;
    d = d > 1e8 ? own : blended(d, own, softness);
    if (own >= least) continue;
    least = own;
    outward = across / blob.stretch;
  }
  const double length = glm::length(outward);
  outward = length > 1e-9 ? outward / length : dvec3(0.0);
  for (const Blob& hollow : hollows) d = -blended(-d, distanceTo(hollow, p, across), hollow.blend);
  if (floor - p.z > d) outward = {0.0, 0.0, -1.0};
  return std::max(d, floor - p.z);
}

geometry::Bounds Flesh::bounds() const {
  geometry::Bounds bounds;
  for (const Blob& blob : blobs) {
    const dvec3 reach_a = blob.ra * blob.stretch + dvec3(0.3 * blend),
                reach_b = blob.rb * blob.stretch + dvec3(0.3 * blend);
    bounds.add(blob.a - reach_a);
    bounds.add(blob.a + reach_a);
    bounds.add(blob.b - reach_b);
    bounds.add(blob.b + reach_b);
  }
  return bounds;
}

std::size_t parentBody(std::size_t body) {
  if (body < kSegmentCount) {
    const auto parent = segmentInfo(static_cast<Segment>(body)).parent;
    return parent ? indexOf(*parent) : body;
  }
  const std::size_t finger = body - kSegmentCount;
  if (finger % kPhalanges != 0) return body - 1;
  return indexOf(finger < kDigits * kPhalanges ? S::kLeftHand : S::kRightHand);
}

geometry::TriangleMesh bodyMesh(const Flesh& flesh, double cell) {
  GridField field{flesh.bounds(), cell, {}};
  field.evaluate = [&](const dvec3&, double, const std::vector<dvec3>& points, std::vector<double>& values) {
    values.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = flesh.distance(points[i]);
  };
  return surfaceOf(field);
}

}  // namespace hapticell::mannequin
