// SPDX-License-Identifier: Apache-2.0
#include "mannequin/body/skeleton.h"

#include <cmath>
#include <numbers>

namespace hapticell::mannequin {

namespace {

constexpr double rad(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

constexpr DofInfo dof(const char* name, const char* joint, Segment segment, int axis, double sign,
                      const std::array<double, 4>& degrees) {
  return {name, joint, segment, axis, sign, rad(degrees[0]), rad(degrees[1]), rad(degrees[2]), rad(degrees[3])};
}

constexpr int kX = 0, kY = 1, kZ = 2;
using S = Segment;

// Hard limits: the sums over the spine and the single joints are the clinical ranges of AAOS (mannequin facts, section
// 2). Comfort: about the middle third to half of the range around the working posture, our own choice.
constexpr std::array<DofInfo, kDofCount> kDofs = {{
    dof("vl5_flexion", "vl5", S::kLowerBack, kY, 1, {-12, 35, -3, 12}),
    dof("vl5_right_bend", "vl5", S::kLowerBack, kX, 1, {-12, 12, -4, 4}),
    dof("vl5_left_turn", "vl5", S::kLowerBack, kZ, 1, {-5, 5, -2, 2}),
    dof("vl1_flexion", "vl1", S::kUpperBack, kY, 1, {-8, 30, -2, 8}),
    dof("vl1_right_bend", "vl1", S::kUpperBack, kX, 1, {-13, 13, -4, 4}),
    dof("vl1_left_turn", "vl1", S::kUpperBack, kZ, 1, {-10, 10, -3, 3}),
    dof("vt6_flexion", "vt6", S::kThorax, kY, 1, {-5, 15, -2, 5}),
    dof("vt6_right_bend", "vt6", S::kThorax, kX, 1, {-10, 10, -3, 3}),
    dof("vt6_left_turn", "vt6", S::kThorax, kZ, 1, {-30, 30, -8, 8}),
    dof("vc7_flexion", "vc7", S::kLowerNeck, kY, 1, {-15, 20, -3, 8}),
    dof("vc7_right_bend", "vc7", S::kLowerNeck, kX, 1, {-15, 15, -4, 4}),
    dof("vc7_left_turn", "vc7", S::kLowerNeck, kZ, 1, {-15, 15, -5, 5}),
    dof("vc4_flexion", "vc4", S::kUpperNeck, kY, 1, {-20, 15, -3, 6}),
    dof("vc4_right_bend", "vc4", S::kUpperNeck, kX, 1, {-20, 20, -5, 5}),
    dof("vc4_left_turn", "vc4", S::kUpperNeck, kZ, 1, {-25, 25, -8, 8}),
    dof("skullbase_flexion", "skullbase", S::kHead, kY, 1, {-25, 10, -5, 6}),
    dof("skullbase_right_bend", "skullbase", S::kHead, kX, 1, {-10, 10, -3, 3}),
    dof("skullbase_left_turn", "skullbase", S::kHead, kZ, 1, {-40, 40, -12, 12}),
    dof("l_sternoclavicular_elevation", "l_sternoclavicular", S::kLeftClavicle, kX, 1, {-5, 45, 0, 12}),
    dof("l_sternoclavicular_protraction", "l_sternoclavicular", S::kLeftClavicle, kZ, -1, {-15, 15, -5, 8}),
    dof("l_shoulder_flexion", "l_shoulder", S::kLeftUpperArm, kY, -1, {-60, 180, -10, 60}),
    dof("l_shoulder_abduction", "l_shoulder", S::kLeftUpperArm, kX, 1, {-50, 180, 0, 40}),
    dof("l_shoulder_internal_rotation", "l_shoulder", S::kLeftUpperArm, kZ, -1, {-90, 70, -20, 45}),
    dof("l_elbow_flexion", "l_elbow", S::kLeftForearm, kY, -1, {0, 150, 20, 110}),
    dof("l_radioulnar_pronation", "l_radioulnar", S::kLeftWrist, kZ, -1, {-80, 80, -30, 60}),
    dof("l_wrist_flexion", "l_wrist", S::kLeftHand, kX, -1, {-70, 80, -20, 20}),
    dof("l_wrist_ulnar_deviation", "l_wrist", S::kLeftHand, kY, 1, {-20, 30, -8, 12}),
    dof("l_fingers_curl", "l_index1", S::kLeftHand, kX, -1, {0, 90, 10, 60}),
    dof("l_thumb_flexion", "l_thumb2", S::kLeftHand, kX, -1, {0, 70, 5, 45}),
    dof("l_thumb_abduction", "l_thumb1", S::kLeftHand, kY, -1, {0, 60, 5, 45}),
    dof("r_sternoclavicular_elevation", "r_sternoclavicular", S::kRightClavicle, kX, -1, {-5, 45, 0, 12}),
    dof("r_sternoclavicular_protraction", "r_sternoclavicular", S::kRightClavicle, kZ, 1, {-15, 15, -5, 8}),
    dof("r_shoulder_flexion", "r_shoulder", S::kRightUpperArm, kY, -1, {-60, 180, -10, 60}),
    dof("r_shoulder_abduction", "r_shoulder", S::kRightUpperArm, kX, -1, {-50, 180, 0, 40}),
    dof("r_shoulder_internal_rotation", "r_shoulder", S::kRightUpperArm, kZ, 1, {-90, 70, -20, 45}),
    dof("r_elbow_flexion", "r_elbow", S::kRightForearm, kY, -1, {0, 150, 20, 110}),
    dof("r_radioulnar_pronation", "r_radioulnar", S::kRightWrist, kZ, 1, {-80, 80, -30, 60}),
    dof("r_wrist_flexion", "r_wrist", S::kRightHand, kX, 1, {-70, 80, -20, 20}),
    dof("r_wrist_ulnar_deviation", "r_wrist", S::kRightHand, kY, 1, {-20, 30, -8, 12}),
    dof("r_fingers_curl", "r_index1", S::kRightHand, kX, 1, {0, 90, 10, 60}),
    dof("r_thumb_flexion", "r_thumb2", S::kRightHand, kX, 1, {0, 70, 5, 45}),
    dof("r_thumb_abduction", "r_thumb1", S::kRightHand, kY, -1, {0, 60, 5, 45}),
    dof("l_hip_flexion", "l_hip", S::kLeftThigh, kY, -1, {-30, 120, -5, 95}),
    dof("l_hip_abduction", "l_hip", S::kLeftThigh, kX, 1, {-30, 45, -5, 20}),
    dof("l_hip_internal_rotation", "l_hip", S::kLeftThigh, kZ, -1, {-45, 45, -15, 15}),
    dof("l_knee_flexion", "l_knee", S::kLeftShank, kY, 1, {0, 150, 0, 100}),
    dof("l_talocrural_plantar_flexion", "l_talocrural", S::kLeftFoot, kY, 1, {-20, 50, -10, 20}),
    dof("l_subtalar_inversion", "l_subtalar", S::kLeftFoot, kX, -1, {-20, 35, -5, 8}),
    dof("l_metatarsal_extension", "l_metatarsal", S::kLeftToes, kY, -1, {-30, 80, -5, 30}),
    dof("r_hip_flexion", "r_hip", S::kRightThigh, kY, -1, {-30, 120, -5, 95}),
    dof("r_hip_abduction", "r_hip", S::kRightThigh, kX, -1, {-30, 45, -5, 20}),
    dof("r_hip_internal_rotation", "r_hip", S::kRightThigh, kZ, 1, {-45, 45, -15, 15}),
    dof("r_knee_flexion", "r_knee", S::kRightShank, kY, 1, {0, 150, 0, 100}),
    dof("r_talocrural_plantar_flexion", "r_talocrural", S::kRightFoot, kY, 1, {-20, 50, -10, 20}),
    dof("r_subtalar_inversion", "r_subtalar", S::kRightFoot, kX, 1, {-20, 35, -5, 8}),
    dof("r_metatarsal_extension", "r_metatarsal", S::kRightToes, kY, -1, {-30, 80, -5, 30}),
}};

constexpr std::array<SegmentInfo, kSegmentCount> kSegments = {{
    {"pelvis", "humanoid_root", std::nullopt},
    {"l5", "vl5", S::kPelvis},
    {"l1", "vl1", S::kLowerBack},
    {"t6", "vt6", S::kUpperBack},
    {"c7", "vc7", S::kThorax},
    {"c4", "vc4", S::kLowerNeck},
    {"skull", "skullbase", S::kUpperNeck},
    {"l_clavicle", "l_sternoclavicular", S::kThorax},
    {"l_upperarm", "l_shoulder", S::kLeftClavicle},
    {"l_forearm", "l_elbow", S::kLeftUpperArm},
    {"l_radius", "l_radioulnar", S::kLeftForearm},
    {"l_hand", "l_wrist", S::kLeftWrist},
    {"r_clavicle", "r_sternoclavicular", S::kThorax},
    {"r_upperarm", "r_shoulder", S::kRightClavicle},
    {"r_forearm", "r_elbow", S::kRightUpperArm},
    {"r_radius", "r_radioulnar", S::kRightForearm},
    {"r_hand", "r_wrist", S::kRightWrist},
    {"l_thigh", "l_hip", S::kPelvis},
    {"l_calf", "l_knee", S::kLeftThigh},
    {"l_hindfoot", "l_talocrural", S::kLeftShank},
    {"l_forefoot", "l_metatarsal", S::kLeftFoot},
    {"r_thigh", "r_hip", S::kPelvis},
    {"r_calf", "r_knee", S::kRightThigh},
    {"r_hindfoot", "r_talocrural", S::kRightShank},
    {"r_forefoot", "r_metatarsal", S::kRightFoot},
}};

constexpr std::size_t kSpineDofs = 18, kArmDofs = 12, kLegDofs = 7;

}  // namespace

const DofInfo& dofInfo(Dof dof) {
  return kDofs[indexOf(dof)];
}

std::optional<Dof> findDof(std::string_view name) {
  for (std::size_t i = 0; i < kDofCount; ++i) {
    if (name == kDofs[i].name) return static_cast<Dof>(i);
  }
  return std::nullopt;
}

Dof mirrored(Dof dof) {
  const std::size_t i = indexOf(dof);
  if (i < kSpineDofs) return dof;
  const std::size_t arms = kSpineDofs + 2 * kArmDofs;
  const std::size_t begin = i < arms ? kSpineDofs : arms, width = i < arms ? kArmDofs : kLegDofs;
  return static_cast<Dof>(i < begin + width ? i + width : i - width);
}

bool changesSignWhenMirrored(Dof dof) {
  return indexOf(dof) < kSpineDofs && kDofs[indexOf(dof)].axis != kY;
}

const SegmentInfo& segmentInfo(Segment segment) {
  return kSegments[indexOf(segment)];
}

}  // namespace hapticell::mannequin
