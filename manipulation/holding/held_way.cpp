// SPDX-License-Identifier: Apache-2.0
#include "manipulation/holding/held_way.h"

#include <algorithm>
#include <cmath>

namespace hapticell::manipulation {

namespace {

using workcell::OnContact;

/// Slides of one step: six independent contacts hold a body. Half: it stays behind in corners; twice: two or more of
/// them again, for nothing.
constexpr int kSlides = 6;
/// m: rotation is dearer here than for the proxy, so that a far target slides and does not tilt beyond what a tangent
/// tells.
constexpr double kSlideLever = 10.0 * haptic::kRotationLever;
/// Of the way that is left, by which a blocked one is pushed out (kSkin at least): the way bends, a bare tangent would
/// be blocked again. Half: more slides; twice: hops at edges.
constexpr double kPushOut = 0.1;
/// m: less is not worth another slide; kTolerance of the solver. Half and twice: nothing that is felt.
constexpr double kArrived = 1e-9;
/// m: the hand has not moved, a twentieth of an encoder step. Half and twice as well.
constexpr double kStood = 1e-6;
/// m of hand that a contact's tangent is good for: off by 0.5 um on a radius of 10 mm. Half: found again twice as
/// often; twice: four times as far off.
constexpr double kTangentStays = 1e-4;
/// Of a step's time: as fast as the joints can, but for rounding. Half or twice of the millionth as well.
constexpr double kAllTheTime = 1.0 - 1e-6;
/// s of a joint's greatest speed: it may have way left although the hand rests. A third of a step at 1000 Hz. Half:
/// more steps at rest; twice: slow ends may be cut.
constexpr double kStillMoving = 3e-4;
/// s: no joint gets anywhere in it. A millionth of a step at 1000 Hz; half and twice as well.
constexpr double kNoTime = 1e-9;
/// Contacts kept from step to step, of the 64 rows that a solver takes. Half: in crowds they are found again; twice:
/// more rows to solve.
constexpr std::size_t kMostKept = 16;
/// rad in all: bounds of an articulated way are good for small pieces, and a long one whole may take seconds
/// (Reliability: p99 14.9 s). Half: twice the checks; twice: looser bounds.
constexpr double kPieceTurn = 0.4;
/// Pieces of one step (3.2 rad); the rest is left to the next. Half: far leaps take twice as many steps; twice: steps
/// of twice the time.
constexpr int kMostPiecesOfAStep = 8;

haptic::Vector6 inMetric(const Twist& t) {
  const dvec3 turned = kSlideLever * t.angular;
  return {t.linear.x, t.linear.y, t.linear.z, turned.x, turned.y, turned.z};
}

Twist outOfMetric(const haptic::Vector6& d) {
  return {{d[0], d[1], d[2]}, dvec3(d[3], d[4], d[5]) / kSlideLever};
}

bool isThere(const Pose& X_WTarget, const Pose& X_WM) {
  const Twist left = difference(X_WTarget, X_WM);
  return glm::length(left.linear) < kArrived && kSlideLever * glm::length(left.angular) < kArrived;
}

/// A gradient over (dx, dtheta) with its value, as a half-space of the metric.
haptic::SolverRow rowOf(const haptic::Vector6& gradient, double slack) {
  haptic::SolverRow row;
  double length = 0.0;
  for (std::size_t i = 0; i < 6; ++i) {
    row.normal[i] = i < 3 ? gradient[i] : gradient[i] / kSlideLever;
    length += row.normal[i] * row.normal[i];
  }
  length = std::sqrt(std::max(length, 1e-24));
  for (double& n : row.normal) n /= length;
  row.slack = slack / length;
  return row;
}

/// How a way went that was cut into pieces.
struct PiecewiseAnswer {
  MotionAnswer last;      ///< Of the last piece.
  double share = 1.0;     ///< Of the whole way.
  bool has_rest = false;  ///< Nothing blocks, but there was more way than one step may take.
};

/// Goes from `accepted` towards `target` and leaves there where it came to.
PiecewiseAnswer goInPieces(FreeMotion& motion, const Manipulator& manipulator, EntityConfiguration& accepted,
                           const EntityConfiguration& target) {
  const EntityConfiguration start = accepted;
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(std::min(1e6, manipulator.turnBound(start, target) / kPieceTurn))));
  PiecewiseAnswer answer;
  for (int piece = 1; piece <= std::min(pieces, kMostPiecesOfAStep); ++piece) {
    const EntityConfiguration next =
        piece == pieces ? target : manipulator.between(start, target, static_cast<double>(piece) / pieces);
    answer.last = motion.advance(manipulator, accepted, next);
    accepted = answer.last.s >= 1.0 ? next : manipulator.between(accepted, next, answer.last.s);
    answer.share = (piece - 1 + answer.last.s) / pieces;
    if (answer.last.blocked) return answer;
  }
  answer.has_rest = pieces > kMostPiecesOfAStep;
  return answer;
}

}  // namespace

void HalfSpaces::moveBy(const haptic::Vector6& d) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 6; ++k) rows[i].slack += rows[i].normal[k] * d[k];
  }
}

void HeldWay::Contacts::found(const haptic::SolverRow& row) {
  if (spaces.count >= kMostKept) return;
  moved[spaces.count] = 0.0;
  spaces.add(row);
}

void HeldWay::Contacts::moveBy(const haptic::Vector6& d) {
  double length = 0.0;
  for (const double x : d) length += x * x;
  length = std::sqrt(length);
  spaces.moveBy(d);
  for (std::size_t i = 0; i < spaces.count; ++i) moved[i] += length;
}

/// A tangent is true near where it was found only.
void HeldWay::Contacts::forgetOld() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < spaces.count; ++i) {
    if (moved[i] > kTangentStays) continue;
    spaces.rows[kept] = spaces.rows[i];
    moved[kept++] = moved[i];
  }
  spaces.count = kept;
}

/// What stood in the way is somewhere else now.
void HeldWay::forget() {
  known_ = false;
  contacts_.spaces.count = 0;
}

void HeldWay::addSoftRows(const BuiltConstraints* built, const MotionMapping& mapping, HalfSpaces& spaces) const {
  if (built == nullptr || !state_.motion.anySoft()) return;
  const Twist t = difference(mapping.toDevice(state_.movedFrame(), built->set.X_DR), built->set.X_DR);
  const haptic::Vector6 xi{t.linear.x, t.linear.y, t.linear.z, t.angular.x, t.angular.y, t.angular.z};
  const haptic::ConstraintSet& set = built->set;
  for (std::size_t i = 0; i < set.count;) {
    std::size_t best = i, last = i;
    for (; last < set.count && set.constraints[last].group == set.constraints[i].group; ++last) {
      if (haptic::evaluate(set.constraints[last], xi) > haptic::evaluate(set.constraints[best], xi)) best = last;
    }
    const int pair = built->origins[i].pair;
    if (pair >= 0 && state_.motion.isSoft(static_cast<std::uint32_t>(pair))) {
      const haptic::Constraint& entry = set.constraints[best];
      spaces.add(rowOf(haptic::gradientAt(entry, xi), std::max(0.0, haptic::evaluate(entry, xi))));
    }
    i = last;
  }
}

/// How the distance of a pair changes with the moved frame, at its nearest points.
haptic::Constraint HeldWay::contactOf(const MotionPair& pair, const collision::DistanceResult& found) const {
  const std::vector<PartDifferential> parts = state_.manipulator->differentiate(state_.accepted);
  PointCondition condition;
  condition.p_WQ = found.p_WA;
  condition.nhat_W = found.nhat_BA_W;
  haptic::Constraint constraint;
  applyCondition(parts[pair.part], condition, constraint);
  if (pair.other_part < 0) return constraint;
  haptic::Constraint met;
  condition.p_WQ = found.p_WB;
  applyCondition(parts[static_cast<std::size_t>(pair.other_part)], condition, met);
  for (std::size_t i = 0; i < 6; ++i) constraint.gradient[i] -= met.gradient[i];
  for (std::size_t i = 0; i < 21; ++i) constraint.curvature[i] -= met.curvature[i];
  return constraint;
}

haptic::SolverRow HeldWay::contactRow(const MotionAnswer& answer, const MotionMapping& mapping, double rest) const {
  haptic::Constraint constraint = contactOf(state_.pairs.motionPairs()[answer.pair], answer.contact);
  // Out to its boundary, but by a small part of the way that is left: the way bends, a bare tangent would be blocked
  // again.
  const double outwards = std::clamp(kPushOut * rest, HeldState::kSkin,
                                     std::max(HeldState::kSkin, state_.pairs.feel()[answer.pair].boundary));
  constraint.gap = answer.contact.distance - outwards;
  mapping.toDevice(constraint);
  return rowOf(constraint.gradient, constraint.gap);
}

/// True when the hand asks for what it asked for at the last step.
bool HeldWay::recall(const MotionMapping& mapping, const Pose& X_WWanted) {
  const bool same_hand = axes_ == mapping.axes() && scale_ == mapping.scale();
  if (!same_hand) contacts_.spaces.count = 0;
  axes_ = mapping.axes();
  scale_ = mapping.scale();
  const Twist moved = difference(X_WWanted, X_WWanted_);
  const double limit = kStood * mapping.scale();
  if (same_hand && known_ && glm::length(moved.linear) < limit &&
      haptic::kRotationLever * glm::length(moved.angular) < limit) {
    return true;
  }
  contacts_.forgetOld();
  X_WWanted_ = X_WWanted;
  known_ = true;
  return false;
}

HeldWay::Gone HeldWay::goTo(const EntityConfiguration& target) {
  /// rad or m of a joint: bounds of the way are good for small pieces. Half: twice the checks of a move; twice: bounds
  /// four times as loose in bends.
  constexpr double kPiece = 0.05;
  /// Pieces of a move to a place: 200 rad or m, some seconds at worst. Longer ones are cut more coarsely. Half and
  /// twice matter to nobody's robot.
  constexpr int kMostPieces = 4000;
  const EntityConfiguration start = state_.accepted;
  known_ = false;
  double furthest = glm::length(target.X_WE.p - start.X_WE.p);
  for (std::size_t i = 0; i < start.joints.size(); ++i) {
    furthest = std::max(furthest, std::abs(target.joints[i] - start.joints[i]));
  }
  const int pieces = static_cast<int>(std::clamp(std::ceil(furthest / kPiece), 1.0, static_cast<double>(kMostPieces)));
  for (int piece = 1; piece <= pieces; ++piece) {
    const EntityConfiguration next =
        piece == pieces ? target : state_.manipulator->between(start, target, static_cast<double>(piece) / pieces);
    const MotionAnswer answer = state_.motion.advance(*state_.manipulator, state_.accepted, next);
    state_.accepted = answer.s >= 1.0 ? next : state_.manipulator->between(state_.accepted, next, answer.s);
    if (answer.blocked) return {(piece - 1 + answer.s) / pieces, true, answer.pair};
  }
  return {};
}

double HeldWay::moveOther(workcell::EntityId other, const dvec3& way_W) {
  const double length = glm::length(way_W);
  double share = 1.0;
  // Whatever is nearer than its way and the boundary might be hit: what is held goes out of its way first.
  state_.motion.distances(length + HeldState::kSkin, near_);
  const bool hit = std::any_of(near_.begin(), near_.end(), [&](const FreeMotion::PairDistance& near) {
    return state_.pairs[near.pair].other == other && state_.pairs.motionPairs()[near.pair].blocks &&
           glm::dot(way_W, near.result.nhat_BA_W) > 1e-6 * length;
  });
  if (hit) {
    const Pose X_WM = state_.movedFrame();
    const Pose X_WPushed{X_WM.p + way_W, X_WM.q};
    const Gone gone =
        goTo(state_.manipulator->propose(state_.accepted, X_WPushed, std::numeric_limits<double>::infinity()));
    if (gone.blocked) share = gone.share;
  }
  const auto& parts = state_.pairs.obstacleParts();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i]->entity != other) continue;
    const Pose& X_WO = state_.pairs.obstacles()[i].X_W;
    state_.moveObstacle(i, {X_WO.p + share * way_W, X_WO.q});
  }
  forget();
  return share;
}

void HeldWay::placeOther(workcell::EntityId other, const EntityConfiguration& at) {
  const auto& parts = state_.pairs.obstacleParts();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i]->entity != other) continue;
    const workcell::Entity& entity = *state_.model.scene()->find(other);
    state_.moveObstacle(i, PreparedScene::partPose(entity, at.X_WE, at.joints, parts[i]->link));
  }
  forget();
}

HeldWay::Followed HeldWay::follow(const Pose& X_DP, const MotionMapping& mapping, const BuiltConstraints* built,
                                  double duration_s) {
  const Pose X_WWanted = mapping.toCell(X_DP);
  if (recall(mapping, X_WWanted)) return followed_;
  Followed& result = followed_ = {};
  HalfSpaces rows = contacts_.spaces;
  addSoftRows(built, mapping, rows);
  Pose X_WTarget = X_WWanted;
  for (int slide = 0; slide < kSlides; ++slide) {
    const Pose X_WM = state_.movedFrame();
    if (rows.count > 0) {
      const haptic::Vector6 d0 = inMetric(mapping.toDevice(difference(X_WWanted, X_WM)));
      const haptic::SolverResult solved = haptic::nearestFeasible(rows.all(), d0);
      if (solved.status == haptic::SolverStatus::kInfeasible) break;
      double length = 0.0;
      for (const double d : solved.d) length += d * d;
      if (std::sqrt(length) < kArrived) break;
      X_WTarget = displaced(X_WM, mapping.toCell(outOfMetric(solved.d)));
    }
    // A figure that is carried on a way keeps the posture of the way where the hand asks for nothing else.
    if (state_.hand && isThere(X_WTarget, X_WM)) break;
    const EntityConfiguration target = state_.manipulator->propose(state_.accepted, X_WTarget, duration_s);
    const MotionTime needed = state_.manipulator->leastTime(state_.accepted, target);
    // A robot whose joints swing round has way left: it goes on although the hand rests.
    const bool hurried = needed.seconds > kAllTheTime * duration_s;
    result.hurried_joint = hurried ? needed.joint : -1;
    if (hurried || needed.seconds > kStillMoving) known_ = false;
    const PiecewiseAnswer gone = goInPieces(state_.motion, *state_.manipulator, state_.accepted, target);
    const MotionAnswer& answer = gone.last;
    duration_s -= gone.share * needed.seconds;
    if (gone.has_rest) known_ = false;
    const haptic::Vector6 moved = inMetric(mapping.toDevice(difference(state_.movedFrame(), X_WM)));
    rows.moveBy(moved);
    contacts_.moveBy(moved);
    if (!answer.blocked) break;
    result.blocked = true;
    result.stopped = state_.pairs[answer.pair].on_contact == OnContact::kStop;
    if (result.stopped) break;
    const haptic::SolverRow row = contactRow(answer, mapping, glm::length(X_WWanted.p - state_.movedFrame().p));
    rows.add(row);
    contacts_.found(row);
    if (!(duration_s > kNoTime)) break;
  }
  return result;
}

}  // namespace hapticell::manipulation
