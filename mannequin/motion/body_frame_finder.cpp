// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/body_frame_finder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/system/listed.h"
#include "mannequin/body/rotations.h"
#include "mannequin/motion/frame_vectors.h"

namespace hapticell::mannequin {

namespace {

// Moments of a motion that frames are found from. Half: one standing phase may outweigh the rest; twice: twice the time
// of reading.
constexpr std::size_t kMostSamples = 400;
/// A bone this near to the rest position's axis is the axis: rounding of files and drawn skeletons. Half: some leaning
/// frames; twice: bones that lean by 6 deg are put upright.
constexpr double kSmallTilt = 3.0 * kDegree;
/// From here on the motion decides between bone and rest position; by trial, RecordedByAnyProgram tests it. Half: rest
/// positions that lean are dropped; twice: rest positions unlike a person are believed.
constexpr double kLargeTilt = 12.0 * kDegree;
/// Of a head that leans at rest, against its neck there. Half: heads drawn along a leaning neck look down; twice: real
/// heads' ends are dropped.
constexpr double kNearNeck = 10.0 * kDegree;
/// How far the rest position's left may lie from what is seen, deg: where joints on the segment show it, where the wish
/// is only likely, where nothing tells. By trial. Half: rest positions are dropped; twice: wrong ones are believed.
constexpr double kSeen = 12.0, kNearlySeen = 25.0, kLikely = 45.0, kWithTheTrunk = 75.0, kUntold = 180.0;
/// From the ankle down to the ball of a foot that is flat, where the motion has no low foot; our choice. Half: feet
/// point upwards by 9 deg; twice: downwards by 18.
constexpr double kFootSlope = 18.0 * kDegree;
/// Between a bone and what it should point along, on the whole. Chosen by trial. Half: bones of odd skeletons are
/// dropped; twice: ends of bones along x, which some programs write, are believed.
constexpr double kNoBone = 55.0 * kDegree;
/// Sine of the flexion (20 deg) from which a hinge's plane is seen well: there a joint's error is tripled. Half: six
/// times; twice: motions with less bending fall back to a guess.
constexpr double kBent = 0.35;

/// Across the bone, to where the next one bends: `bends` +1 forwards (elbow), -1 backwards (knee).
dvec3 hinge(const dvec3& from, const dvec3& middle, const dvec3& to, double bends) {
  return bends * across(unit(to - middle), unit(middle - from));
}

}  // namespace

dvec3 neckBase(const ClipMap& map, const ClipPose& pose) {
  const auto p = [&](int joint) { return pose.p[static_cast<std::size_t>(joint)]; };
  if (map.neck >= 0) return p(map.neck);
  if (map.collar[0] >= 0 && map.collar[1] >= 0) return 0.5 * (p(map.collar[0]) + p(map.collar[1]));
  return 0.5 * (p(map.shoulder[0]) + p(map.shoulder[1]));
}

std::optional<dmat3> restFrame(const MotionClip& clip, const ClipMap& map) {
  ClipFrame rest;
  rest.turns.assign(clip.joints.size(), dquat(1.0, 0.0, 0.0, 0.0));
  ClipPose pose;
  placeJoints(clip, rest, pose);
  const auto p = [&](int joint) { return pose.p[static_cast<std::size_t>(joint)]; };
  const auto along = [](const dvec3& v, const dvec3& axis, double degrees) {
    return glm::length(v) > 1e-6 && angleBetween(v, axis) < degrees * kDegree;
  };
  dvec3 up = unit(neckBase(map, pose) - 0.5 * (p(map.hip[0]) + p(map.hip[1])));
  if (glm::length(up) < 0.5) return std::nullopt;
  if (angleBetween(up, nearestAxis(up)) < 25.0 * kDegree) up = nearestAxis(up);
  dvec3 left = unit(across(p(map.hip[0]) - p(map.hip[1]), up));
  if (glm::length(left) < 0.5) return std::nullopt;
  if (angleBetween(left, nearestAxis(left)) < 20.0 * kDegree) left = nearestAxis(left);
  if (!along(p(map.shoulder[0]) - p(map.shoulder[1]), left, 50.0)) return std::nullopt;
  if (!along(p(map.head) - neckBase(map, pose), up, 60.0) && map.neck >= 0) return std::nullopt;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!along(p(map.knee[i]) - p(map.hip[i]), -up, 60.0) || !along(p(map.ankle[i]) - p(map.knee[i]), -up, 50.0))
      return std::nullopt;
  }
  return frameOf(up, left);
}

BodyFrameFinder::BodyFrameFinder(const MotionClip& clip, const ClipMap& map, const dmat3& R_WC)
    : map_(map), clip_(clip), R_WC_(R_WC) {
  rest_ = restFrame(clip, map_);
  ClipFrame still;
  still.turns.assign(clip.joints.size(), dquat(1.0, 0.0, 0.0, 0.0));
  placeJoints(clip, still, rest_pose_);
  const std::size_t every = std::max<std::size_t>(1, clip.frames.size() / kMostSamples);
  for (std::size_t i = 0; i < clip.frames.size(); i += every)
    placeJoints(clip, clip.frames[i], moments_.emplace_back());
  for (int i = 0; i < 2; ++i)
    leg_ +=
        0.5 * (lengthOf(map_.knee[static_cast<std::size_t>(i)]) + lengthOf(map_.ankle[static_cast<std::size_t>(i)]));
}

SegmentFrames BodyFrameFinder::find() {
  const auto trunk = [this](const ClipPose& m) { return unit(neck(m) - middleOfHips(m)); };
  const auto upright = [trunk](const ClipPose& m) { return std::pow(std::max(0.0, trunk(m).z), 8.0) + 1e-3; };
  const auto hips = [this](const ClipPose& m) { return unit(at(m, map_.hip[0]) - at(m, map_.hip[1])); };
  const auto shoulders = [this](const ClipPose& m) {
    return unit(at(m, shoulderLine()[0]) - at(m, shoulderLine()[1]));
  };
  frames_.root = settle(
      "hips", map_.root,
      [&](const ClipPose& m) {
        return Wish{trunk(m), hips(m), upright(m)};
      },
      std::nullopt, kSeen);
  frames_.thorax = settle(
      "chest", map_.thorax,
      [&](const ClipPose& m) {
        return Wish{trunk(m), shoulders(m), upright(m)};
      },
      thoraxAxis(), shoulderLine() == map_.shoulder ? kNearlySeen : kSeen);
  frames_.head = settle(
      "head", map_.head,
      [&](const ClipPose& m) {
        return Wish{trunk(m), shoulders(m), upright(m)};
      },
      headAxis(), likely());
  for (std::size_t k = 0; k < 2; ++k) {
    const int next = k == 0 && map_.spine[1] >= 0 ? map_.spine[1] : map_.thorax;
    frames_.spine[k] = settle(
        "spine", map_.spine[k],
        [&](const ClipPose& m) {
          return Wish{trunk(m), hips(m) + shoulders(m), upright(m)};
        },
        boneTo(map_.spine[k], next), kLikely);
    const int above = k == 0 && map_.neck_joints[1] >= 0 ? map_.neck_joints[1] : map_.head;
    frames_.neck[k] = settle(
        "neck", map_.neck_joints[k],
        [&](const ClipPose& m) {
          return Wish{trunk(m), shoulders(m), upright(m)};
        },
        boneTo(map_.neck_joints[k], above), kLikely);
  }
  for (std::size_t i = 0; i < 2; ++i) findLimbs(i);
  tell();
  return std::move(frames_);
}

dmat3 BodyFrameFinder::turn(const ClipPose& m, int joint) const {
  return R_WC_ * glm::mat3_cast(m.q[static_cast<std::size_t>(joint)]);
}

/// The joints whose line is the chest's left: the collars where they lie apart in it.
std::array<int, 2> BodyFrameFinder::shoulderLine() const {
  if (map_.collar[0] < 0 || map_.collar[1] < 0 || moments_.empty()) return map_.shoulder;
  const ClipPose& m = moments_.front();
  return glm::length(at(m, map_.collar[0]) - at(m, map_.collar[1])) > 0.02 * leg_ ? map_.collar : map_.shoulder;
}

/// Mean direction, in a joint's frame, of what `world` tells at each moment; nothing where it is no direction.
std::optional<dvec3> BodyFrameFinder::meanIn(int joint, const std::function<dvec3(const ClipPose&)>& world,
                                             double least) const {
  dvec3 sum(0.0);
  for (const ClipPose& m : moments_) sum += glm::transpose(turn(m, joint)) * world(m);
  if (moments_.empty() || glm::length(sum) / static_cast<double>(moments_.size()) < least) return std::nullopt;
  return unit(sum);
}

std::optional<dvec3> BodyFrameFinder::thoraxAxis() const {
  return meanIn(
      map_.thorax, [this](const ClipPose& m) { return neck(m) - at(m, map_.thorax); }, 0.05 * leg_);
}

/// A head that leans at rest does so because it is built so where its neck leans too; else its frame was turned.
std::optional<dvec3> BodyFrameFinder::headAxis() const {
  const std::optional<dvec3> bone = boneTo(map_.head, map_.head_end);
  if (!bone || !rest_ || map_.neck < 0 || angleBetween(*bone, (*rest_)[2]) < kSmallTilt) return bone;
  return angleBetween(*bone, atRest(map_.head) - atRest(map_.neck)) < kNearNeck ? (*rest_)[2] : *bone;
}

std::optional<dvec3> BodyFrameFinder::boneTo(int joint, int next) const {
  if (joint < 0 || next < 0) return std::nullopt;
  return meanIn(
      joint, [=, this](const ClipPose& m) { return at(m, next) - at(m, joint); }, 0.02 * leg_);
}

/// Where pelvis and chest lie as at the rest position, the others most likely do.
double BodyFrameFinder::likely() const {
  return turned_.empty() ? kWithTheTrunk : kLikely;
}

/// The segment's frame in the joint's. `bone`: which way is up, where a bone tells it. `trust`: kSeen to kUntold, of
/// the wish for the left.
dmat3 BodyFrameFinder::settle(const char* what, int joint, const std::function<Wish(const ClipPose&)>& wish,
                              const std::optional<dvec3>& bone, double trust) {
  return settle(what, joint, wish, bone, trust, rest_);
}

dmat3 BodyFrameFinder::settle(const char* what, int joint, const std::function<Wish(const ClipPose&)>& wish,
                              std::optional<dvec3> bone, double trust, const std::optional<dmat3>& rest) {
  if (joint < 0) return dmat3(1.0);
  dvec3 up(0.0), left(0.0);
  for (const ClipPose& m : moments_) {
    const Wish w = wish(m);
    const dmat3 R = glm::transpose(turn(m, joint));
    up += w.weight * (R * w.up);
    left += w.weight * (R * w.left);
  }
  if (glm::length(up) < 1e-9 || glm::length(left) < 1e-9) return rest.value_or(dmat3(1.0));
  const dmat3 mean = frameOf(up, left);
  // Some programs write an end of a bone where none is: along x, as of all other bones.
  const bool as_at_rest = bone && rest && angleBetween(*bone, (*rest)[2]) < kLargeTilt;
  if (bone && !as_at_rest && angleBetween(*bone, mean[2]) > kNoBone) bone.reset();
  const dvec3 z = joint == map_.head && bone ? *bone : upOf(mean, bone, rest);
  return frameOf(z, leftOf(what, mean, z, trust, rest));
}

dvec3 BodyFrameFinder::upOf(const dmat3& mean, const std::optional<dvec3>& bone, const std::optional<dmat3>& rest) {
  if (bone && !rest) return *bone;
  if (bone) {
    const dvec3 axis = (*rest)[2];
    const double tilt = angleBetween(axis, *bone);
    if (tilt < kSmallTilt) return *bone;
    if (tilt < kLargeTilt) return angleBetween(axis, mean[2]) < 35.0 * kDegree ? axis : *bone;
    return angleBetween(axis, mean[2]) < angleBetween(*bone, mean[2]) ? axis : *bone;
  }
  if (rest && angleBetween((*rest)[2], mean[2]) < 25.0 * kDegree) return (*rest)[2];
  const dvec3 axis = nearestAxis(mean[2]);
  return angleBetween(axis, mean[2]) < 20.0 * kDegree ? axis : mean[2];
}

dvec3 BodyFrameFinder::leftOf(const char* what, const dmat3& mean, const dvec3& z, double trust,
                              const std::optional<dmat3>& rest) {
  const dvec3 y = unit(across(mean[1], z));
  const auto near = [&](const dvec3& axis, double degrees) {
    const dvec3 level = across(axis, z);
    return glm::length(level) > 0.7 && angleBetween(level, y) < degrees * kDegree;
  };
  if (rest && near((*rest)[1], trust)) return (*rest)[1];
  if (std::find(turned_.begin(), turned_.end(), what) == turned_.end()) turned_.push_back(what);
  const bool aligned = angleBetween(z, nearestAxis(z)) < kSmallTilt;
  const dvec3 axis = nearestAxis(y);
  double within = aligned ? 30.0 : 10.0;
  if (trust == kSeen) within = 6.0;
  return near(axis, within) ? axis : y;
}

void BodyFrameFinder::findLimbs(std::size_t i) {
  const auto knee = [=, this](const ClipPose& m) {
    return hinge(at(m, map_.hip[i]), at(m, map_.knee[i]), at(m, map_.ankle[i]), -1.0);
  };
  const auto elbow = [=, this](const ClipPose& m) {
    return hinge(at(m, map_.shoulder[i]), at(m, map_.elbow[i]), at(m, map_.hand[i]), 1.0);
  };
  const auto ahead = [this](const std::array<int, 2>& line) {
    return [=, this](const ClipPose& m) {
      return glm::cross(unit(at(m, line[0]) - at(m, line[1])), unit(neck(m) - middleOfHips(m)));
    };
  };
  frames_.thigh_forward[i] = forwardIn(map_.hip[i], map_.knee[i], knee, ahead(map_.hip));
  frames_.arm_forward[i] = forwardIn(map_.shoulder[i], map_.elbow[i], elbow, ahead(map_.shoulder));
  frames_.hand[i] = handFrame(i, elbow);
  frames_.foot[i] = footFrame(i, knee);
}

/// Where a limb's upper bone has its forward, in its joint's frame.
dvec3 BodyFrameFinder::forwardIn(int joint, int next, const std::function<dvec3(const ClipPose&)>& bend,
                                 const std::function<dvec3(const ClipPose&)>& otherwise) const {
  dvec3 sum(0.0);
  for (const ClipPose& m : moments_) {
    const dvec3 x = bend(m);
    if (glm::length(x) > kBent) sum += glm::transpose(turn(m, joint)) * x;
  }
  if (glm::length(sum) < 1e-6) sum = meanIn(joint, otherwise, 1e-6).value_or(dvec3(1, 0, 0));
  sum = unit(sum);
  const std::optional<dvec3> bone = boneTo(joint, next);
  const auto near = [&](const dvec3& axis, double degrees) {
    return angleBetween(axis, sum) < degrees * kDegree && (!bone || std::abs(glm::dot(axis, *bone)) < 0.7);
  };
  if (rest_ && near((*rest_)[0], 60.0)) return (*rest_)[0];
  return near(nearestAxis(sum), 30.0) ? nearestAxis(sum) : sum;
}

/// The hand at rest: turned with the arm in the frontal plane, palm down at a T-pose, to the thigh where it hangs.
std::optional<dmat3> BodyFrameFinder::handAtRest(std::size_t i) const {
  if (!rest_) return std::nullopt;
  const double out = i == 0 ? 1.0 : -1.0;
  const dvec3 d = glm::transpose(*rest_) * unit(atRest(map_.hand[i]) - atRest(map_.elbow[i]));
  if (std::abs(d.x) > 0.8 || out * d.y < -0.3) return std::nullopt;  // Ahead, or across the body.
  const double rise = std::atan2(out * d.y, -d.z);
  const dvec3 back(0.0, out * std::cos(rise), std::sin(rise));
  const dvec3 z = -d;
  return *rest_ * frameOf(z, out * back);
}

/// The thumb's root beside the hand tells how that is turned; its tip, where the root is the wrist itself, turns too
/// much by itself (and is hardly recorded in CMU's clips).
bool BodyFrameFinder::thumbStandsOff(std::size_t i) const {
  if (map_.thumb[i] < 0 || map_.hand[i] < 0 || moments_.empty()) return false;
  const ClipPose& m = moments_.front();
  const dvec3 fore = unit(at(m, map_.hand[i]) - at(m, map_.elbow[i]));
  return glm::length(across(at(m, map_.thumb[i]) - at(m, map_.hand[i]), fore)) > 0.012 * leg_;
}

dmat3 BodyFrameFinder::handFrame(std::size_t i, const std::function<dvec3(const ClipPose&)>& elbow) {
  const int hand = map_.hand[i];
  std::optional<dvec3> bone = boneTo(hand, map_.fingers[i]);
  if (bone) *bone = -*bone;
  const bool knuckles = map_.index[i] >= 0 && map_.little[i] >= 0, thumb = !knuckles && thumbStandsOff(i);
  const auto wish = [&, knuckles, thumb, i](const ClipPose& m) {
    const dvec3 fore = unit(at(m, map_.hand[i]) - at(m, map_.elbow[i]));
    dvec3 x = across(unit(elbow(m)), fore);
    double weight = glm::length(elbow(m)) > kBent ? 1.0 : 1e-3;
    if (knuckles) {
      x = at(m, map_.index[i]) - at(m, map_.little[i]);
    } else if (thumb) {
      x = at(m, map_.thumb[i]) - at(m, map_.hand[i]);
    }
    if (knuckles || thumb) weight = 1.0;
    return Wish{-fore, glm::cross(-fore, unit(across(x, fore))), weight};
  };
  if (!knuckles && !thumb && !rest_) guessed_hands_ = true;
  return settle("hands", hand, wish, bone, knuckles || thumb ? likely() : kUntold, handAtRest(i));
}

dmat3 BodyFrameFinder::footFrame(std::size_t i, const std::function<dvec3(const ClipPose&)>& knee) {
  const int foot = map_.ankle[i], toe = map_.toe[i];
  const std::optional<dvec3> bone = boneTo(foot, toe);
  const auto wish = [&, i](const ClipPose& m) {
    const dvec3 shank = unit(at(m, map_.ankle[i]) - at(m, map_.knee[i]));
    if (!bone) {
      const dvec3 ahead = glm::length(knee(m)) > kBent ? knee(m) : turn(m, map_.hip[i]) * frames_.thigh_forward[i];
      return Wish{-shank, glm::cross(-shank, ahead), 1.0};
    }
    const dvec3 x = unit(at(m, toe) - at(m, foot)), z = unit(across(-shank, x));
    return Wish{z, glm::cross(z, x), 1.0};
  };
  if (!bone) return settle("feet", foot, wish, std::nullopt, kLikely);
  if (rest_) {
    const dvec3 toes = glm::transpose(*rest_) * *bone;
    if (angleBetween(toes, {1, 0, 0}) < 50.0 * kDegree) return *rest_;
  }
  const dmat3 seen = settle("feet", foot, wish, std::nullopt, kLikely);
  const dvec3 left = unit(across(seen[1], *bone)), over = glm::cross(*bone, left);
  const double slope = footSlope(foot, toe);
  const dvec3 x = std::cos(slope) * *bone + std::sin(slope) * over;
  return {x, left, glm::cross(x, left)};
}

/// From the ankle down to the ball of the foot where the ankle is lowest: there the foot stands.
double BodyFrameFinder::footSlope(int foot, int toe) const {
  std::vector<std::pair<double, double>> slopes;
  for (const ClipPose& m : moments_) {
    const dvec3 x = unit(at(m, toe) - at(m, foot));
    slopes.emplace_back(at(m, foot).z, std::asin(std::clamp(-x.z, -1.0, 1.0)));
  }
  std::sort(slopes.begin(), slopes.end());
  const std::size_t low = slopes.size() / 4;
  return low > 2 ? std::clamp(slopes[low / 2].second, 0.0, 40.0 * kDegree) : kFootSlope;
}

void BodyFrameFinder::tell() {
  std::vector<Text>& said = frames_.assumptions;
  if (!rest_) {
    said.push_back(
        Text("the file has no rest pose of a standing person; the joint frames are derived from the joint positions "
             "in the motion"));
  } else if (!turned_.empty()) {
    said.push_back(Text("the frames of %1 do not match the rest pose; they are derived from the joint positions",
                        listed(turned_)));
  }
  if (map_.neck < 0) {
    said.push_back(map_.collar[0] >= 0 && map_.collar[1] >= 0
                       ? Text("there is no joint for the neck; its base is assumed midway between the collars")
                       : Text("there is no joint for the neck; its base is assumed midway between the shoulders"));
  }
  if (map_.thorax == map_.root) said.push_back(Text("there is no joint for the spine; the trunk moves as one piece"));
  if (map_.toe[0] < 0 || map_.toe[1] < 0)
    said.push_back(Text("there are no joints for the toes; the feet follow the ankles"));
  if (map_.head_end < 0)
    said.push_back(Text("the file does not state the top of the head; the frame of the head is used"));
  if (guessed_hands_) {
    said.push_back(
        Text("the file does not state how the hands are turned about the forearms (no fingers, no rest pose); on "
             "average, neither pronation nor supination is assumed"));
  }
}

}  // namespace hapticell::mannequin
