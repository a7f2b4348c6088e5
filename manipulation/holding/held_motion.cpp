// SPDX-License-Identifier: Apache-2.0
// How the held entity follows the hand: as far as it is free, and along what stands in the way.
#include <algorithm>
#include <cmath>
#include <limits>

#include "haptic/rendering/active_set_solver.h"
#include "manipulation/holding/contact_search.h"
#include "manipulation/holding/held_entity.h"

namespace hapticell::manipulation {

namespace {

using workcell::OnContact;

constexpr int kSlides = 6;
/// m: rotation is dearer here than for the proxy, so that a far target slides and does not tilt beyond what a tangent
/// tells.
constexpr double kSlideLever = 10.0 * haptic::kRotationLever;
constexpr double kPushOut = 0.1;
constexpr double kArrived = 1e-9;           ///< m: less is not worth another slide.
constexpr double kStood = 1e-6;             ///< m: the hand has not moved.
constexpr double kTangentStays = 1e-4;      ///< m of hand that a contact's tangent is good for.
constexpr double kAllTheTime = 1.0 - 1e-6;  ///< Of a step's time: as fast as the joints can.
constexpr double kStillMoving = 3e-4;       ///< s of a joint's greatest speed: it may have way left.
constexpr double kNoTime = 1e-9;            ///< s: no joint gets anywhere in it.
constexpr std::size_t kMostKept = 16;
/// rad in all: bounds of an articulated way are good for small pieces, and a long one whole may take seconds.
constexpr double kPieceTurn = 0.4;
constexpr int kMostPiecesOfAStep = 8;

haptic::Vector6 inMetric(const Twist& t) {
  const dvec3 turned = kSlideLever * t.angular;
  return {t.linear.x, t.linear.y, t.linear.z, turned.x, turned.y, turned.z};
}

Twist outOfMetric(const haptic::Vector6& d) {
  return {{d[0], d[1], d[2]}, dvec3(d[3], d[4], d[5]) / kSlideLever};
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

/// Half-spaces over small motions of the hand.
struct HeldEntity::Rows {
  std::array<haptic::SolverRow, haptic::kMaxRows> rows{};
  std::size_t count = 0;
  void add(const haptic::SolverRow& row) {
    if (count < rows.size()) rows[count++] = row;
  }
  std::span<const haptic::SolverRow> all() const { return {rows.data(), count}; }
  void moveBy(const haptic::Vector6& d) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < 6; ++k) rows[i].slack += rows[i].normal[k] * d[k];
    }
  }
};

/// What stood in the way lately.
struct HeldEntity::Way {
  Rows contacts;
  std::array<double, haptic::kMaxRows> moved{};  ///< m of hand since each was found.
  dquat axes{1.0, 0.0, 0.0, 0.0};
  double scale = 0.0;
  Pose X_WWanted;       ///< Of the last step,
  FollowResult result;  ///< and what came of it.
  bool known = false;

  void found(const haptic::SolverRow& row) {
    if (contacts.count >= kMostKept) return;
    moved[contacts.count] = 0.0;
    contacts.add(row);
  }
  void moveBy(const haptic::Vector6& d) {
    double length = 0.0;
    for (const double x : d) length += x * x;
    length = std::sqrt(length);
    contacts.moveBy(d);
    for (std::size_t i = 0; i < contacts.count; ++i) moved[i] += length;
  }
  /// A tangent is true near where it was found only.
  void forgetOld() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < contacts.count; ++i) {
      if (moved[i] > kTangentStays) continue;
      contacts.rows[kept] = contacts.rows[i];
      moved[kept++] = moved[i];
    }
    contacts.count = kept;
  }
};

HeldEntity::HeldEntity() : finder_(std::make_shared<collision::ContactFinder>()), way_(std::make_unique<Way>()) {}

HeldEntity::~HeldEntity() {
  if (asked_) search_->drop();
}

void HeldEntity::addSoftRows(const BuiltConstraints* built, const MotionMapping& mapping, Rows& rows) const {
  if (built == nullptr || !motion_->anySoft()) return;
  const Twist t = difference(mapping.toDevice(movedFrame(), built->set.X_DR), built->set.X_DR);
  const haptic::Vector6 xi{t.linear.x, t.linear.y, t.linear.z, t.angular.x, t.angular.y, t.angular.z};
  const haptic::ConstraintSet& set = built->set;
  for (std::size_t i = 0; i < set.count;) {
    std::size_t best = i, last = i;
    for (; last < set.count && set.constraints[last].group == set.constraints[i].group; ++last) {
      if (haptic::evaluate(set.constraints[last], xi) > haptic::evaluate(set.constraints[best], xi)) best = last;
    }
    const int pair = built->origins[i].pair;
    if (pair >= 0 && motion_->isSoft(static_cast<std::uint32_t>(pair))) {
      const haptic::Constraint& entry = set.constraints[best];
      rows.add(rowOf(haptic::gradientAt(entry, xi), std::max(0.0, haptic::evaluate(entry, xi))));
    }
    i = last;
  }
}

haptic::SolverRow HeldEntity::contactRow(const MotionAnswer& answer, const MotionMapping& mapping, double rest) const {
  haptic::Constraint constraint = contactOf(motion_pairs_[answer.pair], answer.contact);
  // Out to its boundary, but by a small part of the way that is left: the way bends, a bare tangent would be blocked
  // again.
  const double outwards = std::clamp(kPushOut * rest, kSkin, std::max(kSkin, feel_[answer.pair].boundary));
  constraint.gap = answer.contact.distance - outwards;
  mapping.toDevice(constraint);
  return rowOf(constraint.gradient, constraint.gap);
}

/// True when the hand asks for what it asked for at the last step.
bool HeldEntity::recall(const MotionMapping& mapping, const Pose& X_WWanted) {
  const bool same_hand = way_->axes == mapping.axes() && way_->scale == mapping.scale();
  if (!same_hand) way_->contacts.count = 0;
  way_->axes = mapping.axes();
  way_->scale = mapping.scale();
  const Twist moved = difference(X_WWanted, way_->X_WWanted);
  const double limit = kStood * mapping.scale();
  if (same_hand && way_->known && glm::length(moved.linear) < limit &&
      haptic::kRotationLever * glm::length(moved.angular) < limit) {
    return true;
  }
  way_->forgetOld();
  way_->X_WWanted = X_WWanted;
  way_->known = true;
  return false;
}

HeldEntity::WayResult HeldEntity::goTo(const EntityConfiguration& target) {
  constexpr double kPiece = 0.05;  // rad or m of a joint: bounds of the way are good for small pieces
  constexpr int kMostPieces = 4000;
  const EntityConfiguration start = accepted_;
  way_->known = false;
  double furthest = glm::length(target.X_WE.p - start.X_WE.p);
  for (std::size_t i = 0; i < start.joints.size(); ++i) {
    furthest = std::max(furthest, std::abs(target.joints[i] - start.joints[i]));
  }
  const int pieces = static_cast<int>(std::clamp(std::ceil(furthest / kPiece), 1.0, static_cast<double>(kMostPieces)));
  for (int piece = 1; piece <= pieces; ++piece) {
    const EntityConfiguration next =
        piece == pieces ? target : manipulator_->between(start, target, static_cast<double>(piece) / pieces);
    const MotionAnswer answer = motion_->advance(*manipulator_, accepted_, next);
    accepted_ = answer.s >= 1.0 ? next : manipulator_->between(accepted_, next, answer.s);
    if (answer.blocked) return {(piece - 1 + answer.s) / pieces, true, answer.pair};
  }
  return {};
}

double HeldEntity::moveOther(workcell::EntityId other, const dvec3& way_W) {
  const double length = glm::length(way_W);
  double share = 1.0;
  // Whatever is nearer than its way and the boundary might be hit: what is held goes out of its way first.
  motion_->distances(length + kSkin, near_);
  const bool hit = std::any_of(near_.begin(), near_.end(), [&](const FreeMotion::PairDistance& near) {
    return pairs_[near.pair].other == other && motion_pairs_[near.pair].blocks &&
           glm::dot(way_W, near.result.nhat_BA_W) > 1e-6 * length;
  });
  if (hit) {
    const Pose X_WM = movedFrame();
    const Pose X_WPushed{X_WM.p + way_W, X_WM.q};
    const WayResult gone = goTo(manipulator_->propose(accepted_, X_WPushed, std::numeric_limits<double>::infinity()));
    if (gone.blocked) share = gone.share;
  }
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    if (obstacle_parts_[i]->entity != other) continue;
    obstacles_[i].X_W.p += share * way_W;
    motion_->moveObstacle(static_cast<std::uint32_t>(i), obstacles_[i].X_W);
  }
  way_->known = false;
  way_->contacts.count = 0;
  return share;
}

void HeldEntity::placeOther(workcell::EntityId other, const EntityConfiguration& at) {
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    if (obstacle_parts_[i]->entity != other) continue;
    obstacles_[i].X_W = PreparedScene::partPose(*scene_->find(other), at.X_WE, at.joints, obstacle_parts_[i]->link);
    motion_->moveObstacle(static_cast<std::uint32_t>(i), obstacles_[i].X_W);
  }
  way_->known = false;
  way_->contacts.count = 0;
}

HeldEntity::FollowResult HeldEntity::follow(const Pose& X_DP, const MotionMapping& mapping,
                                            const BuiltConstraints* built, double duration_s) {
  const Pose X_WWanted = mapping.toCell(X_DP);
  if (recall(mapping, X_WWanted)) return way_->result;
  FollowResult& result = way_->result = {};
  Rows rows = way_->contacts;
  addSoftRows(built, mapping, rows);
  Pose X_WTarget = X_WWanted;
  for (int slide = 0; slide < kSlides; ++slide) {
    const Pose X_WM = movedFrame();
    if (rows.count > 0) {
      const haptic::Vector6 d0 = inMetric(mapping.toDevice(difference(X_WWanted, X_WM)));
      const haptic::SolverResult solved = haptic::nearestFeasible(rows.all(), d0);
      if (solved.status == haptic::SolverStatus::kInfeasible) break;
      double length = 0.0;
      for (const double d : solved.d) length += d * d;
      if (std::sqrt(length) < kArrived) break;
      X_WTarget = displaced(X_WM, mapping.toCell(outOfMetric(solved.d)));
    }
    const EntityConfiguration target = manipulator_->propose(accepted_, X_WTarget, duration_s);
    const MotionTime needed = manipulator_->leastTime(accepted_, target);
    // A robot whose joints swing round has way left: it goes on although the hand rests.
    const bool hurried = needed.seconds > kAllTheTime * duration_s;
    result.hurried_joint = hurried ? needed.joint : -1;
    if (hurried || needed.seconds > kStillMoving) way_->known = false;
    const PiecewiseAnswer gone = goInPieces(*motion_, *manipulator_, accepted_, target);
    const MotionAnswer& answer = gone.last;
    duration_s -= gone.share * needed.seconds;
    if (gone.has_rest) way_->known = false;
    const haptic::Vector6 moved = inMetric(mapping.toDevice(difference(movedFrame(), X_WM)));
    rows.moveBy(moved);
    way_->moveBy(moved);
    if (!answer.blocked) break;
    result.blocked = true;
    result.stopped = pairs_[answer.pair].on_contact == OnContact::kStop;
    if (result.stopped) break;
    const haptic::SolverRow row = contactRow(answer, mapping, glm::length(X_WWanted.p - movedFrame().p));
    rows.add(row);
    way_->found(row);
    if (!(duration_s > kNoTime)) break;
  }
  return result;
}

}  // namespace hapticell::manipulation
