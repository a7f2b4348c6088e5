// SPDX-License-Identifier: Apache-2.0
#include "planning/standing_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "manipulation/manipulators/mannequin_taking.h"
#include "mannequin/posture/limb_inverse.h"
#include "mannequin/posture/posture_solver.h"
#include "mannequin/shape/body_shape.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::planning {

using mannequin::Dof;
using mannequin::Posture;
using mannequin::Segment;
using mannequin::Side;

namespace {

/// m that a foot may be off its place, a radian of its turn counting 0.1 m. Half: postures of the solver are refused;
/// twice: feet slide by what the written motion is measured by.
constexpr double kOnItsPlace = 2e-4;
/// m that the legs of a straight motion may take a foot off its place between two knots; the least slack of a plan is
/// twice that. Half: 1.4 times the knots; twice: legs may come nearer than was proven by as much as the slack.
constexpr double kKnotOff = 1e-4;
/// Halvings between two knots at most: a stretched knee bends by the root of the way. Half: such legs cannot be
/// crouched; twice: no more are ever needed.
constexpr int kMostHalvings = 10;
/// rad, m between two places where it must stand. Half: twice the time of these looks; twice: it may be out of balance
/// between them by what a hand moves it in half a radian.
constexpr double kStandApart = 0.25, kStandApartPelvis = 0.03;
/// m that samples of the pelvis lie around the start's, level, down and up, and rad. Our choice: what legs reach. Half:
/// low and far places are only reached by way of the goal's posture; twice: samples that no leg reaches.
constexpr double kAround = 0.35, kDown = 0.5, kUp = 0.05, kTurned = 0.7;
/// m inside the soles' edge that the centre of mass stays, if it is so far inside at the start. Half: nearly falls;
/// twice: the solver's own margin, which leaves the search no room.
constexpr double kMargin = 0.01;
/// rad/s: a person who is careful, as the agents' figure (agents/body/moved_figure.cpp). Half, twice: motions take
/// twice or half the time.
constexpr double kSpineSpeed = 0.6, kArmSpeed = 1.6, kLegSpeed = 1.2, kOtherSpeed = 1.0;
/// m/s, rad/s of the pelvis; as above.
constexpr double kPelvisSpeed = 0.25, kPelvisTurn = 0.5;
/// Elbows around the line from shoulder to wrist. Half: a narrow place may want one between; twice: twice the goals.
constexpr int kElbows = 16;
/// rad: legs and arms in closed form may be beyond a limit by rounding. Half, twice: as well.
constexpr double kExact = 1e-9;
/// m, a radian counting like 0.1 m, for a posture of the solver: below Passing. Half: places at joint limits count as
/// out of reach; twice: the written motion misses its pose.
constexpr double kWithin = 9e-4;

constexpr std::array kArmDofs{Dof::kLeftClavicleElevation,
                              Dof::kLeftClavicleProtraction,
                              Dof::kLeftShoulderFlexion,
                              Dof::kLeftShoulderAbduction,
                              Dof::kLeftShoulderInternalRotation,
                              Dof::kLeftElbowFlexion,
                              Dof::kLeftPronation,
                              Dof::kLeftWristFlexion,
                              Dof::kLeftWristUlnarDeviation};

/// The joint of a number after the pelvis's.
Dof dofOf(std::size_t number, Side side) {
  if (number < StandingFigure::kArm) return static_cast<Dof>(number - StandingFigure::kPelvis);
  return armDof(side, kArmDofs[number - StandingFigure::kArm]);
}

bool isOfLeg(Segment segment) {
  return segment >= Segment::kLeftThigh;
}

bool isOfFoot(Segment segment) {
  return segment == Segment::kLeftFoot || segment == Segment::kLeftToes || segment == Segment::kRightFoot ||
         segment == Segment::kRightToes;
}

double speedOf(Dof dof) {
  const Segment segment = mannequin::dofInfo(dof).segment;
  if (isOfLeg(segment)) return kLegSpeed;
  if (segment <= Segment::kThorax) return kSpineSpeed;
  return segment >= Segment::kLeftClavicle ? kArmSpeed : kOtherSpeed;
}

}  // namespace

StandingFigure::StandingFigure(const manipulation::Taking& taking, Side side)
    : figure_(taking.entity.figure()), model_(taking.entity.robot()), side_(side), start_(postureOf(taking.stands)) {
  const mannequin::FigurePose pose = mannequin::forwardKinematics(*figure_, start_);
  feet_ = {pose[Segment::kLeftFoot], pose[Segment::kRightFoot]};
  support_ = mannequin::supportPolygon(*figure_, feet_, mannequin::standingFeet(*figure_, pose));
  loads_ = manipulation::loadsInHands(taking);
  for (const auto& one : mannequin::limitViolations(start_)) beyond_at_start_.push_back(one.what);
  decideOnPelvis(manipulation::hangsInTheAir(taking));
  setRanges();
}

void StandingFigure::decideOnPelvis(bool hangs) {
  const mannequin::FigurePose pose = mannequin::forwardKinematics(*figure_, start_);
  const double inside = margin(pose);
  least_margin_ = std::min(kMargin, inside);
  const bool legs_follow = offFeet(mannequin::forwardKinematics(*figure_, withLegs(start_))) < kKnotOff &&
                           limitViolations(withLegs(start_)).size() <= beyond_at_start_.size();
  pelvis_stays_ = hangs || inside < 0.0 || !legs_follow;
  if (pelvis_stays_) note_ = Text("pelvis and legs stay, because the mannequin does not stand on its feet");
}

void StandingFigure::setRanges() {
  const Numbers at = numbersOf(configurationOf(start_));
  for (std::size_t i = 0; i < kNumbers; ++i) {
    if (i < kPelvis) {
      constexpr std::array kBelow{kAround, kAround, kDown, kTurned, kTurned, kTurned};
      constexpr std::array kAbove{kAround, kAround, kUp, kTurned, kTurned, kTurned};
      lower_[i] = at[i] - (pelvis_stays_ ? 0.0 : kBelow[i]);
      upper_[i] = at[i] + (pelvis_stays_ ? 0.0 : kAbove[i]);
      continue;
    }
    const mannequin::DofInfo& info = mannequin::dofInfo(dofOf(i, side_));
    lower_[i] = std::min(at[i], info.lower);
    upper_[i] = std::max(at[i], info.upper);
  }
}

Posture StandingFigure::postureOf(const EntityConfiguration& at) const {
  return mannequin::toPosture(*figure_, {at.X_WE, at.joints});
}

EntityConfiguration StandingFigure::configurationOf(const Posture& posture) const {
  mannequin::ModelConfiguration model = mannequin::toModel(*figure_, posture);
  return {model.X_WE, std::move(model.joints)};
}

StandingFigure::Numbers StandingFigure::numbersOf(const EntityConfiguration& at) const {
  const Posture posture = postureOf(at);
  const Twist way = difference(posture.X_WR, start_.X_WR);
  Numbers numbers{};
  for (int i = 0; i < 3; ++i) {
    numbers[static_cast<std::size_t>(i)] = posture.X_WR.p[i];
    numbers[static_cast<std::size_t>(i) + 3] = way.angular[i];
  }
  for (std::size_t i = kPelvis; i < kNumbers; ++i) numbers[i] = posture[dofOf(i, side_)];
  return numbers;
}

EntityConfiguration StandingFigure::configurationOf(const Numbers& numbers) const {
  Posture posture = start_;
  if (!pelvis_stays_) {
    const dvec3 turn(numbers[3], numbers[4], numbers[5]);
    posture.X_WR = {{numbers[0], numbers[1], numbers[2]},
                    glm::normalize(quaternionFromRotationVector(turn) * start_.X_WR.q)};
  }
  for (std::size_t i = kPelvis; i < kNumbers; ++i) posture[dofOf(i, side_)] = numbers[i];
  return configurationOf(withLegs(posture));
}

bool StandingFigure::standsStill(int link) const {
  auto body = static_cast<std::size_t>(std::max(0, mannequin::bodyOfLink(*model_, std::max(0, link))));
  while (body >= mannequin::kSegmentCount) body = mannequin::parentBody(body);
  const auto segment = static_cast<Segment>(body);
  return isOfFoot(segment) || (pelvis_stays_ && (isOfLeg(segment) || segment == Segment::kPelvis));
}

/// The legs as the feet ask for; one that does not reach is left as it is.
Posture StandingFigure::withLegs(const Posture& posture) const {
  if (pelvis_stays_) return posture;
  mannequin::BodyState state = mannequin::stateOf(posture);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const auto leg = mannequin::legInverse(*figure_, side, state.root, feet_[static_cast<std::size_t>(side)]);
    if (leg.violation < kExact && leg.missing < kExact) mannequin::setLeg(state, side, leg);
  }
  return mannequin::postureOf(state, posture.gaze);
}

/// m, of the worse foot.
double StandingFigure::offFeet(const mannequin::FigurePose& pose) const {
  double off = 0.0;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const Twist way = difference(mannequin::footPose(pose, side), feet_[static_cast<std::size_t>(side)].pose());
    off = std::max(off, glm::length(way.linear) + 0.1 * glm::length(way.angular));
  }
  return off;
}

double StandingFigure::margin(const mannequin::FigurePose& pose) const {
  const dvec3 centre = mannequin::centerOfMass(*figure_, pose, loads_);
  return support_.margin({centre.x, centre.y});
}

bool StandingFigure::stands(const EntityConfiguration& at) const {
  const Posture posture = postureOf(at);
  const mannequin::FigurePose pose = mannequin::forwardKinematics(*figure_, posture);
  if (offFeet(pose) > kOnItsPlace) return false;
  if (!pelvis_stays_ && margin(pose) < least_margin_ - kExact) return false;
  const auto beyond = mannequin::limitViolations(posture);
  return std::all_of(beyond.begin(), beyond.end(), [&](const mannequin::LimitViolation& one) {
    return std::find(beyond_at_start_.begin(), beyond_at_start_.end(), one.what) != beyond_at_start_.end();
  });
}

EntityConfiguration StandingFigure::onItsFeet(const EntityConfiguration& at) const {
  return configurationOf(withLegs(onlyFree(postureOf(at))));
}

EntityConfiguration StandingFigure::between(const EntityConfiguration& from, const EntityConfiguration& to,
                                            double s) const {
  if (s <= 0.0) return from;
  if (s >= 1.0) return to;
  return configurationOf(withLegs(mannequin::interpolate(postureOf(from), postureOf(to), s)));
}

std::vector<EntityConfiguration> StandingFigure::knots(const EntityConfiguration& from,
                                                       const EntityConfiguration& to) const {
  const Posture a = postureOf(from), b = postureOf(to);
  double turned = 0.0;
  for (std::size_t i = 0; i < mannequin::kDofCount; ++i) turned = std::max(turned, std::abs(a.angles[i] - b.angles[i]));
  const double slid = glm::length(b.X_WR.p - a.X_WR.p);
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::max(turned / kStandApart, slid / kStandApartPelvis))));
  std::vector<EntityConfiguration> knots{from};
  std::vector<EntityConfiguration> places{from};
  for (int k = 1; k <= pieces; ++k) {
    places.push_back(between(from, to, static_cast<double>(k) / pieces));
    if (!stands(places.back())) return {};
  }
  if (pelvis_stays_ || slid + glm::length(difference(b.X_WR, a.X_WR).angular) < kExact) return {from, to};
  for (std::size_t k = 1; k < places.size(); ++k) {
    if (!addKnots(places[k - 1], places[k], {0.0, 1.0}, knots)) return {};
  }
  return knots;
}

/// Of the part of the motion within `span`, what follows its beginning, which is there already; false: it does not
/// stand.
bool StandingFigure::addKnots(const EntityConfiguration& from, const EntityConfiguration& to,
                              std::array<double, 2> span, std::vector<EntityConfiguration>& knots) const {
  const double middle = 0.5 * (span[0] + span[1]);
  EntityConfiguration end = between(from, to, span[1]);
  const Posture straight = mannequin::interpolate(postureOf(knots.back()), postureOf(end), 0.5);
  if (offFeet(mannequin::forwardKinematics(*figure_, straight)) > kKnotOff) {
    if (span[1] - span[0] < std::ldexp(1.0, -kMostHalvings) || !stands(between(from, to, middle))) return false;
    return addKnots(from, to, {span[0], middle}, knots) && addKnots(from, to, {middle, span[1]}, knots);
  }
  knots.push_back(std::move(end));
  return true;
}

double StandingFigure::leastTime(const EntityConfiguration& from, const EntityConfiguration& to) const {
  const Posture a = postureOf(from), b = postureOf(to);
  const Twist way = difference(b.X_WR, a.X_WR);
  double longest = std::max(glm::length(way.linear) / kPelvisSpeed, glm::length(way.angular) / kPelvisTurn);
  for (std::size_t i = 0; i < mannequin::kDofCount; ++i) {
    longest = std::max(longest, std::abs(b.angles[i] - a.angles[i]) / speedOf(static_cast<Dof>(i)));
  }
  return longest;
}

std::vector<double> StandingFigure::speeds() const {
  std::vector<double> speeds;
  for (std::size_t i = 0; i < mannequin::kModelVariables; ++i) {
    speeds.push_back(i < mannequin::kDofCount ? speedOf(static_cast<Dof>(i)) : kOtherSpeed);
  }
  return speeds;
}

/// What is free as given, the rest as at the start.
Posture StandingFigure::onlyFree(const Posture& posture) const {
  Posture only = start_;
  if (!pelvis_stays_) only.X_WR = posture.X_WR;
  for (std::size_t i = kPelvis; i < kNumbers; ++i) only[dofOf(i, side_)] = posture[dofOf(i, side_)];
  return only;
}

/// Postures with the hand H exactly at X_WH on this trunk, the elbow all around.
void StandingFigure::addWithElbows(const Posture& trunk, const Pose& X_WH,
                                   std::vector<EntityConfiguration>& found) const {
  const Posture base = withLegs(onlyFree(trunk));
  const mannequin::FigurePose pose = mannequin::forwardKinematics(*figure_, base);
  const mannequin::SegmentPlace hand{glm::mat3_cast(X_WH.q), X_WH.p};
  const mannequin::ArmProblem arm(*figure_, side_, pose[Segment::kThorax],
                                  pose[armSegment(side_, Segment::kLeftClavicle)], hand);
  const double preferred = arm.preferredSwivel();
  for (int i = 0; i < kElbows; ++i) {
    const mannequin::ArmAngles angles = arm.at(preferred + 6.283185307179586 * i / kElbows);
    if (angles.violation > kExact || angles.missing > kExact) continue;
    mannequin::BodyState state = mannequin::stateOf(base);
    mannequin::setArm(state, side_, angles);
    EntityConfiguration at = configurationOf(mannequin::postureOf(state, base.gaze));
    if (stands(at)) found.push_back(std::move(at));
  }
}

std::vector<EntityConfiguration> StandingFigure::posturesAt(const Pose& X_WM,
                                                            const std::vector<EntityConfiguration>& starts,
                                                            Shortfall* shortfall) const {
  const auto i = static_cast<std::size_t>(side_);
  const Pose X_WH{X_WM.p - X_WM.rotate(figure_->p_HandGrip[i]), X_WM.q};
  mannequin::PostureTask task;
  task.hands[i] = X_WH;
  task.feet = {feet_[0].pose(), feet_[1].pose()};
  task.pelvis_locked = pelvis_stays_;
  task.balance = !pelvis_stays_;
  task.loads = loads_;
  const mannequin::PostureSolver solver(*figure_);
  std::vector<EntityConfiguration> found;
  Shortfall least{std::numeric_limits<double>::infinity()};
  for (const EntityConfiguration& start : starts) {
    const auto result = solver.solve(task, postureOf(start));
    addWithElbows(result.posture, X_WH, found);
    EntityConfiguration own = onItsFeet(configurationOf(result.posture));
    const Pose now = mannequin::handPose(mannequin::forwardKinematics(*figure_, postureOf(own)), side_);
    const Twist off = difference(now, X_WH);
    const double missing = glm::length(off.linear) + 0.1 * glm::length(off.angular);
    if (missing >= least.missing || !stands(own)) continue;
    least = {missing, std::move(own)};
  }
  // Joints on their limits: the closed form is beyond them by a hair.
  if (found.empty() && least.missing < kWithin) found.push_back(*least.nearest);
  if (shortfall != nullptr) *shortfall = std::move(least);
  const EntityConfiguration& first = starts.front();
  std::stable_sort(found.begin(), found.end(), [&](const EntityConfiguration& a, const EntityConfiguration& b) {
    return leastTime(first, a) < leastTime(first, b);
  });
  return found;
}

}  // namespace hapticell::planning
