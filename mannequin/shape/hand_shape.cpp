// SPDX-License-Identifier: Apache-2.0
#include "mannequin/shape/hand_shape.h"

#include "mannequin/body/rotations.h"

namespace hapticell::mannequin {

namespace {

/// A finger as shares of the hand's breadth (across, x) and length (along, down; bones).
struct FingerShares {
  double across, down, length, thick;
};
constexpr std::array<FingerShares, 4> kFingers = {{{0.31, 0.455, 0.475, 0.098},
                                                   {0.09, 0.470, 0.520, 0.100},
                                                   {-0.135, 0.455, 0.485, 0.096},
                                                   {-0.345, 0.420, 0.385, 0.086}}};
constexpr std::array<double, 3> kBones = {0.47, 0.29, 0.24};

}  // namespace

std::array<std::array<Phalanx, kPhalanges>, kDigits> phalangesOf(const Figure& figure, Side side) {
  const double length = figure.body[Dimension::kHandLength], breadth = figure.body[Dimension::kHandBreadth];
  const double out = outwardSign(side);
  std::array<std::array<Phalanx, kPhalanges>, kDigits> hand;
  for (std::size_t f = 0; f < 4; ++f) {
    const FingerShares& share = kFingers[f];
    dvec3 joint(share.across * breadth, 0.0, -share.down * length);
    for (std::size_t k = 0; k < kPhalanges; ++k) {
      Phalanx& bone = hand[f + 1][k];
      bone.p_Joint = joint;
      bone.length = kBones[k] * share.length * length;
      bone.radius = share.thick * breadth * (1.0 - 0.09 * static_cast<double>(k));
      joint = bone.length * bone.along;
    }
  }
  constexpr std::array<double, 3> kThumb = {0.235, 0.185, 0.150};
  constexpr std::array<double, 3> kThumbThick = {0.150, 0.118, 0.105};
  dvec3 joint(0.20 * breadth, -out * 0.10 * breadth, -0.13 * length);
  for (std::size_t k = 0; k < kPhalanges; ++k) {
    Phalanx& bone = hand[0][k];
    bone.p_Joint = joint;
    bone.along = glm::normalize(dvec3(0.50, -0.28 * out, -0.82));
    bone.length = kThumb[k] * length;
    bone.radius = kThumbThick[k] * breadth;
    joint = bone.length * bone.along;
  }
  return hand;
}

std::array<std::array<dmat3, kPhalanges>, kDigits> phalanxRotations(const Posture& posture, Side side) {
  const double out = outwardSign(side);
  const dmat3 curl = aboutX(-out * posture[armDof(side, Dof::kLeftFingersCurl)]);
  const dmat3 flexion = aboutX(-out * posture[armDof(side, Dof::kLeftThumbFlexion)]);
  const dmat3 abduction = aboutY(-posture[armDof(side, Dof::kLeftThumbAbduction)]);
  std::array<std::array<dmat3, kPhalanges>, kDigits> turns;
  for (auto& finger : turns) finger = {curl, curl, curl};
  turns[0] = {abduction, flexion, flexion};
  return turns;
}

std::array<std::array<SegmentPlace, kPhalanges>, kDigits> phalanxPlaces(const Figure& figure, const Posture& posture,
                                                                        Side side, const SegmentPlace& hand) {
  const auto bones = phalangesOf(figure, side);
  const auto turns = phalanxRotations(posture, side);
  std::array<std::array<SegmentPlace, kPhalanges>, kDigits> places;
  for (std::size_t d = 0; d < kDigits; ++d) {
    SegmentPlace at = hand;
    for (std::size_t k = 0; k < kPhalanges; ++k) {
      at = {at.R_WS * turns[d][k], at.point(bones[d][k].p_Joint)};
      places[d][k] = at;
    }
  }
  return places;
}

const char* phalanxName(Side side, Digit digit, std::size_t phalanx) {
  static constexpr const char* kNames[2][kDigits][kPhalanges] = {{{"l_thumb1", "l_thumb2", "l_thumb3"},
                                                                  {"l_index1", "l_index2", "l_index3"},
                                                                  {"l_middle1", "l_middle2", "l_middle3"},
                                                                  {"l_ring1", "l_ring2", "l_ring3"},
                                                                  {"l_pinky1", "l_pinky2", "l_pinky3"}},
                                                                 {{"r_thumb1", "r_thumb2", "r_thumb3"},
                                                                  {"r_index1", "r_index2", "r_index3"},
                                                                  {"r_middle1", "r_middle2", "r_middle3"},
                                                                  {"r_ring1", "r_ring2", "r_ring3"},
                                                                  {"r_pinky1", "r_pinky2", "r_pinky3"}}};
  return kNames[static_cast<std::size_t>(side)][static_cast<std::size_t>(digit)][phalanx];
}

bool setGrasp(Posture& posture, Side side, std::string_view grasp) {
  struct Preset {
    std::string_view name;
    double curl, flexion, abduction;
  };
  constexpr std::array<Preset, 5> kPresets = {
      {{"open", 12, 8, 30}, {"flat", 0, 0, 5}, {"power", 72, 45, 30}, {"pinch", 42, 38, 45}, {"pointing", 80, 50, 15}}};
  for (const Preset& preset : kPresets) {
    if (preset.name != grasp) continue;
    posture[armDof(side, Dof::kLeftFingersCurl)] = preset.curl * kDegree;
    posture[armDof(side, Dof::kLeftThumbFlexion)] = preset.flexion * kDegree;
    posture[armDof(side, Dof::kLeftThumbAbduction)] = preset.abduction * kDegree;
    return true;
  }
  return false;
}

}  // namespace hapticell::mannequin
