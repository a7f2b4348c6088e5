// SPDX-License-Identifier: Apache-2.0
#include "access/hand_sweep.h"

#include <algorithm>
#include <cmath>

#include "access/sweep_limits.h"

namespace hapticell::access {

namespace {

constexpr double kLargestReported = 0.1;    ///< m; larger clearances are not reported. Half and twice: only what is reported.
constexpr double kEvery = 5e-3;  ///< m of way between two measured clearances. Half: twice the time; twice: less exact.

class Sweep {
 public:
  Sweep(const RemovalScene& scene, std::size_t unit, UnitSet gone, const std::vector<SweptShape>& shapes)
      : scene_(scene), shapes_(shapes), X_EW_(scene.scene().find(scene.units()[unit].entity)->X_WE.inverse()) {
    std::vector<collision::PartIndex> moved, standing;
    for (const SweptShape& shape : shapes) {
      moved.push_back(swept_.addPart({0, static_cast<std::uint32_t>(moved.size())}, shape.collider, shape.X_WP));
      unit_of_.push_back(unit);
    }
    for (std::size_t other = 0; other < scene.units().size(); ++other) {
      if (other == unit || (other < scene.movableCount() && (gone >> other & 1) != 0)) continue;
      for (const auto& part : scene.units()[other].parts) {
        standing.push_back(swept_.addPart({other + 1, static_cast<std::uint32_t>(unit_of_.size())},
                                          part.part->mesh.collider, part.X_WP));
        unit_of_.push_back(other);
      }
    }
    swept_.addPairs(moved, standing);
  }

  /// Lowers the clearance to what it is with the part at X_WE.
  void measure(const Pose& X_WE, double glove, HandSweep& result) {
    for (std::size_t i = 0; i < shapes_.size(); ++i)
      swept_.setPose(static_cast<collision::PartIndex>(i), X_WE * X_EW_ * shapes_[i].X_WP);
    const auto nearest = swept_.nearest(std::max(result.clearance_m + glove, 1e-6));
    if (!nearest) return;
    result.clearance_m = nearest->result.distance - glove;
    if (result.clearance_m < 0.0) result.blocked_by = nameOf(nearest->pair);
  }

  /// The share of the motion that is free.
  double advance(const Pose& from, const Pose& to, double glove, HandSweep& result) {
    double done = 0.0;
    for (int i = 0; i < kMostContinued; ++i) {
      const Pose now = interpolate(from, to, done);
      std::vector<collision::MovedPart> moved;
      for (std::size_t k = 0; k < shapes_.size(); ++k) {
        const auto part = static_cast<collision::PartIndex>(k);
        const auto& collider = *shapes_[k].collider;
        moved.push_back({part, rigidMotion(now, to, now * X_EW_ * shapes_[k].X_WP,
                                           glm::length(collider.center()) + collider.radius())});
        swept_.setPose(part, moved.back().motion.X_WStart);
      }
      const auto stop = swept_.advance(moved, glove);
      if (!stop.stopped && !stop.began_colliding) return 1.0;
      done += stop.s * (1.0 - done);
      if (stop.began_colliding || stop.nearest.distance < glove + kStopped) {
        result.blocked_by = nameOf(stop.pair);
        return done;
      }
    }
    return done;
  }

 private:
  std::string nameOf(collision::PairIndex pair) const {
    return scene_.units()[unit_of_[swept_.environment(pair)]].name;
  }

  const RemovalScene& scene_;
  const std::vector<SweptShape>& shapes_;
  Pose X_EW_;
  collision::Scene swept_;
  std::vector<std::size_t> unit_of_;
};

}  // namespace

HandSweep sweepHand(const RemovalScene& scene, std::size_t unit, UnitSet gone, const RemovalWay& way,
                    const std::vector<SweptShape>& shapes, double glove) {
  HandSweep result;
  result.clearance_m = kLargestReported;
  Sweep sweep(scene, unit, gone, shapes);
  sweep.measure(way.X_WE.front(), glove, result);
  if (result.clearance_m < 0.0) return result;
  for (std::size_t i = 1; i < way.X_WE.size(); ++i) {
    const double length = glm::length(way.X_WE[i].p - way.X_WE[i - 1].p);
    const double free = sweep.advance(way.X_WE[i - 1], way.X_WE[i], glove, result);
    result.at_m += free * length;
    if (free < 1.0) {
      result.clearance_m = std::min(result.clearance_m, 0.0);
      return result;
    }
    const auto looks = static_cast<int>(std::ceil(length / kEvery));
    for (int k = 1; k <= looks; ++k) {
      sweep.measure(interpolate(way.X_WE[i - 1], way.X_WE[i], static_cast<double>(k) / looks), glove, result);
    }
  }
  // At rest it is measured exactly; between the looks the sweep has proven it.
  result.clearance_m = std::max(result.clearance_m, 0.0);
  result.blocked_by.clear();
  result.fits = true;
  return result;
}

}  // namespace hapticell::access
