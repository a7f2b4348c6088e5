// SPDX-License-Identifier: Apache-2.0
// A new manipulator: a drawer that follows the hand along its rails and no other way, until it meets an obstacle.
#include <collision/queries/proximity_query.h>
#include <geometry/shapes/shapes.h>
#include <manipulation/manipulators/manipulator.h>

#include <algorithm>
#include <cstdio>
#include <glm/glm.hpp>
#include <vector>

using hapticell::dvec3;
using hapticell::Pose;
namespace collision = hapticell::collision;
using namespace hapticell::manipulation;  // NOLINT: what the example is about.

namespace {

/// One part, whose frame is the entity's own; its rails are the x axis of the cell, from 0 to `length` metres.
class Drawer final : public Manipulator {
 public:
  explicit Drawer(double length) : length_(length) {}
  Pose movedFrame(const EntityConfiguration& at) const override { return at.X_WE; }
  EntityConfiguration propose(const EntityConfiguration& from, const Pose& X_WM, double) const override {
    EntityConfiguration to = from;
    to.X_WE.p.x = std::clamp(X_WM.p.x, 0.0, length_);  // What the hand wants across the rails is not followed.
    return to;
  }
  EntityConfiguration between(const EntityConfiguration& a, const EntityConfiguration& b, double s) const override {
    return {interpolate(a.X_WE, b.X_WE, s), {}};
  }
  void partPoses(const EntityConfiguration& at, std::span<Pose> X_WP) const override { X_WP[0] = at.X_WE; }
  Pose partPose(const EntityConfiguration& at, std::size_t) const override { return at.X_WE; }
  void pathBounds(const EntityConfiguration& a, const EntityConfiguration& b, std::span<const PartSphere>,
                  std::span<double> bounds) const override {
    bounds[0] = glm::length(b.X_WE.p - a.X_WE.p);
  }
  double turnBound(const EntityConfiguration&, const EntityConfiguration&) const override { return 0.0; }
  std::vector<PartDifferential> differentiate(const EntityConfiguration& at) const override {
    std::vector<PartDifferential> part(1);
    part[0].p_WPo = at.X_WE.p;
    part[0].velocity[0].linear = dvec3(1.0, 0.0, 0.0);  // Of the hand's six ways one moves it.
    return part;
  }
  std::vector<MotionLimit> limits(const EntityConfiguration&, double, double) const override { return {}; }

 private:
  double length_;
};

}  // namespace

int main() {
  const auto drawer = collision::MeshCollider::build(hapticell::geometry::makeBox({0.4, 0.4, 0.1}));
  const auto post = collision::MeshCollider::build(hapticell::geometry::makeBox({0.05, 0.05, 1.0}));
  const Pose X_WPost = Pose::translation({0.5, 0.1, 0.0});
  const Drawer manipulator(0.6);

  EntityConfiguration stands;
  for (int step = 1; step <= 8; ++step) {
    const Pose hand = Pose::translation({0.08 * step, 0.02 * step, 0.05});
    EntityConfiguration wanted = manipulator.propose(stands, hand, 0.02);
    const auto gap = collision::distance(drawer, stands.X_WE, post, X_WPost);
    const double way = glm::length(wanted.X_WE.p - stands.X_WE.p);
    // No point goes further than the gap: it cannot meet the post on the way.
    if (way > gap.distance) wanted = manipulator.between(stands, wanted, 0.999 * gap.distance / way);
    stands = wanted;
    std::printf("hand at %.2f m, drawer at %.3f m\n", hand.p.x, stands.X_WE.p.x);
  }
  return 0;
}
