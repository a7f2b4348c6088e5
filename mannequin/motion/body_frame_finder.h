// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/system/text.h"
#include "mannequin/motion/clip_map.h"
#include "mannequin/motion/motion_clip.h"

namespace hapticell::mannequin {

/// The segments' frames in those of the clip's joints that carry them; the identity for joints that the clip lacks.
struct SegmentFrames {
  dmat3 root{1.0}, thorax{1.0}, head{1.0};
  std::array<dmat3, 2> spine{dmat3(1.0), dmat3(1.0)}, neck{dmat3(1.0), dmat3(1.0)}, hand{dmat3(1.0), dmat3(1.0)},
      foot{dmat3(1.0), dmat3(1.0)};
  /// Directions in the frames of hips and shoulders: ahead, across the limb's upper bone.
  std::array<dvec3, 2> thigh_forward{}, arm_forward{};
  std::vector<Text> assumptions;  ///< One sentence each.
};

/// The base of the neck at one frame: the lowest neck joint, else midway between the collars, else between the
/// shoulders.
dvec3 neckBase(const ClipMap& map, const ClipPose& pose);

/// The clip's body frame at rest (all rotations zero) by columns forward, left, up, in the file's axes; empty if the
/// bones are not placed as those of a standing person.
std::optional<dmat3> restFrame(const MotionClip& clip, const ClipMap& map);

/// Finds the frames of a clip's segments by looking at the motion once, at some hundreds of moments. See BodyFrames for
/// what decides. Used once.
class BodyFrameFinder {
 public:
  /// `R_WC` turns the clip's axes into the world (Z up). Clip and map must outlive this.
  BodyFrameFinder(const MotionClip& clip, const ClipMap& map, const dmat3& R_WC);

  SegmentFrames find();

 private:
  /// A segment's wished frame at a moment, in the world.
  struct Wish {
    dvec3 up, left;
    double weight;
  };
  dvec3 at(const ClipPose& m, int joint) const { return R_WC_ * m.p[static_cast<std::size_t>(joint)]; }
  dmat3 turn(const ClipPose& m, int joint) const;
  dvec3 atRest(int joint) const { return rest_pose_.p[static_cast<std::size_t>(joint)]; }
  dvec3 neck(const ClipPose& m) const { return R_WC_ * neckBase(map_, m); }
  dvec3 middleOfHips(const ClipPose& m) const { return 0.5 * (at(m, map_.hip[0]) + at(m, map_.hip[1])); }
  double lengthOf(int joint) const { return glm::length(clip_.joints[static_cast<std::size_t>(joint)].p_Parent); }

  std::array<int, 2> shoulderLine() const;
  std::optional<dvec3> meanIn(int joint, const std::function<dvec3(const ClipPose&)>& world, double least) const;
  std::optional<dvec3> thoraxAxis() const;
  std::optional<dvec3> headAxis() const;
  std::optional<dvec3> boneTo(int joint, int next) const;
  double likely() const;
  dmat3 settle(const char* what, int joint, const std::function<Wish(const ClipPose&)>& wish,
               const std::optional<dvec3>& bone, double trust);
  dmat3 settle(const char* what, int joint, const std::function<Wish(const ClipPose&)>& wish, std::optional<dvec3> bone,
               double trust, const std::optional<dmat3>& rest);
  static dvec3 upOf(const dmat3& mean, const std::optional<dvec3>& bone, const std::optional<dmat3>& rest);
  dvec3 leftOf(const char* what, const dmat3& mean, const dvec3& z, double trust, const std::optional<dmat3>& rest);
  void findLimbs(std::size_t i);
  dvec3 forwardIn(int joint, int next, const std::function<dvec3(const ClipPose&)>& bend,
                  const std::function<dvec3(const ClipPose&)>& otherwise) const;
  std::optional<dmat3> handAtRest(std::size_t i) const;
  bool thumbStandsOff(std::size_t i) const;
  dmat3 handFrame(std::size_t i, const std::function<dvec3(const ClipPose&)>& elbow);
  dmat3 footFrame(std::size_t i, const std::function<dvec3(const ClipPose&)>& knee);
  double footSlope(int foot, int toe) const;
  void tell();

  const ClipMap& map_;
  const MotionClip& clip_;
  dmat3 R_WC_;
  SegmentFrames frames_;
  std::optional<dmat3> rest_;
  ClipPose rest_pose_;
  std::vector<ClipPose> moments_;
  double leg_ = 0.0;
  std::vector<const char*> turned_;
  bool guessed_hands_ = false;
};

}  // namespace hapticell::mannequin
