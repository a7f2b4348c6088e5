// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "mannequin/posture/forward_kinematics.h"

namespace hapticell::mannequin {

enum class Digit : std::uint8_t { kThumb, kIndex, kMiddle, kRing, kPinky };
inline constexpr std::size_t kDigits = 5, kPhalanges = 3;

/// One bone of a finger: its joint in the frame of the bone before it (the hand's for the first), and its direction.
/// Frames are parallel to the hand's at zero posture.
struct Phalanx {
  dvec3 p_Joint{0.0};
  dvec3 along{0.0, 0.0, -1.0};  ///< Unit.
  double length = 0.0;
  double radius = 0.0;
};

/// Bones of a hand of that size: shares of ANSUR's hand length and breadth (our own choice).
std::array<std::array<Phalanx, kPhalanges>, kDigits> phalangesOf(const Figure& figure, Side side);

/// How each phalanx turns in the one before: curl for all three of a finger; for the thumb abduction, flexion, flexion.
std::array<std::array<dmat3, kPhalanges>, kDigits> phalanxRotations(const Posture& posture, Side side);

/// Poses (frame at the joint, in the world) of all phalanges of a hand at `hand`.
std::array<std::array<SegmentPlace, kPhalanges>, kDigits> phalanxPlaces(const Figure& figure, const Posture& posture,
                                                                        Side side, const SegmentPlace& hand);

/// H-Anim name of a phalanx's joint, "l_index2".
const char* phalanxName(Side side, Digit digit, std::size_t phalanx);

/// Fingers and thumb for a grasp: "open", "flat", "power", "pinch", "pointing". False: no such grasp, nothing changed.
bool setGrasp(Posture& posture, Side side, std::string_view grasp);

}  // namespace hapticell::mannequin
