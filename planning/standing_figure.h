// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/system/text.h"
#include "manipulation/manipulators/manipulator_kinds.h"
#include "mannequin/posture/body_state.h"
#include "mannequin/posture/forward_kinematics.h"
#include "mannequin/posture/posture.h"
#include "mannequin/posture/support_polygon.h"

namespace hapticell::planning {

using manipulation::EntityConfiguration;

/// What is known where no posture brings the hand to a pose: the posture that brings it nearest, if it stands.
struct Shortfall {
  double missing = 0.0;  ///< m, a radian counting like 0.1 m; infinite if no posture stands.
  std::optional<EntityConfiguration> nearest = {};
};

/// A mannequin whose one hand moves while its feet stay: pelvis, spine and that arm are free, the legs follow in closed
/// form, neck, fingers and the other arm stay as they are.
///
/// A figure that does not stand on its feet (it sits, hangs, or its legs are in a posture of their own) keeps its
/// pelvis and its legs, and needs no balance; note() says so. Constant once it is made; any thread.
class StandingFigure {
 public:
  /// The free variables: place of the pelvis (m, world) 3, its turn away from the start (rotation vector, rad) 3, spine
  /// 9 and arm 9 (rad).
  static constexpr std::size_t kNumbers = 24, kPelvis = 6, kArm = 15;
  using Numbers = std::array<double, kNumbers>;

  /// `taking` holds the entity, a mannequin, and where it stands; nothing of it is kept but the figure.
  StandingFigure(const manipulation::Taking& taking, mannequin::Side side);

  Numbers numbersOf(const EntityConfiguration& at) const;
  /// The rest is as at the start; where the legs do not reach, they are left as they were, and it does not stand.
  EntityConfiguration configurationOf(const Numbers& numbers) const;
  /// What samples lie in: hard limits, and for the pelvis a box around the start. `lower` is at most the start's value.
  const Numbers& lower() const { return lower_; }
  const Numbers& upper() const { return upper_; }
  bool pelvisStays() const { return pelvis_stays_; }
  /// Whether a part of this link of its model never moves.
  bool standsStill(int link) const;

  /// Feet in place (within 0.2 mm), all joints within their limits but those that are beyond them at the start, and the
  /// centre of mass within the soles.
  bool stands(const EntityConfiguration& at) const;
  /// The same but for the legs, which are as the feet ask for.
  EntityConfiguration onItsFeet(const EntityConfiguration& at) const;
  /// At `s` in [0, 1]: pelvis and joints as mannequin::interpolate(), legs as the feet ask for.
  EntityConfiguration between(const EntityConfiguration& from, const EntityConfiguration& to, double s) const;
  /// Places of that motion, so close that straight motions of all joints between them keep the feet within 0.1 mm;
  /// first and last the ends. Empty: it does not stand somewhere.
  std::vector<EntityConfiguration> knots(const EntityConfiguration& from, const EntityConfiguration& to) const;
  /// s of the motion from one to the other, of the slowest joint; see the speeds in the source.
  double leastTime(const EntityConfiguration& from, const EntityConfiguration& to) const;
  /// rad/s, one a variable of its model.
  std::vector<double> speeds() const;

  /// Standing postures with the hand's grip at X_WM: from the trunks that the posture solver finds from `starts`,
  /// exactly, with the elbow all around; where limits prevent that, the solver's own, within Passing. The nearest to
  /// the first start first. Empty: none; then `shortfall` is set, if given.
  std::vector<EntityConfiguration> posturesAt(const Pose& X_WM, const std::vector<EntityConfiguration>& starts,
                                              Shortfall* shortfall) const;
  /// What stays although it could move, and why; empty: it stands.
  const Text& note() const { return note_; }
  mannequin::Side side() const { return side_; }

 private:
  mannequin::Posture postureOf(const EntityConfiguration& at) const;
  EntityConfiguration configurationOf(const mannequin::Posture& posture) const;
  mannequin::Posture withLegs(const mannequin::Posture& posture) const;
  mannequin::Posture onlyFree(const mannequin::Posture& posture) const;
  double offFeet(const mannequin::FigurePose& pose) const;
  double margin(const mannequin::FigurePose& pose) const;
  void setRanges();
  void decideOnPelvis(bool hangs);
  bool addKnots(const EntityConfiguration& from, const EntityConfiguration& to, std::array<double, 2> span,
                std::vector<EntityConfiguration>& knots) const;
  void addWithElbows(const mannequin::Posture& trunk, const Pose& X_WH, std::vector<EntityConfiguration>& found) const;

  std::shared_ptr<const mannequin::Figure> figure_;
  std::shared_ptr<const kinematics::RobotModel> model_;
  mannequin::Side side_;
  mannequin::Posture start_;
  std::array<mannequin::SegmentPlace, 2> feet_;
  mannequin::SupportPolygon support_;
  std::array<mannequin::HandLoad, 2> loads_{};
  std::vector<std::string> beyond_at_start_;  ///< Names of angles outside their limits.
  bool pelvis_stays_ = false;
  double least_margin_ = 0.0;
  Numbers lower_{}, upper_{};
  Text note_;
};

}  // namespace hapticell::planning
