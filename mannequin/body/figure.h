// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "mannequin/body/anthropometry.h"
#include "mannequin/body/skeleton.h"

namespace hapticell::mannequin {

/// The sole of a foot in the foot's frame (origin at the ankle, X towards the toes), metres. The same for both feet.
struct Sole {
  double heel_x = 0.0;      ///< Of the hindmost point; negative.
  double ball_x = 0.0;      ///< Of the metatarsal joint.
  double toe_x = 0.0;       ///< Of the longest toe.
  double z = 0.0;           ///< Of the floor under the standing figure; negative.
  double heel_width = 0.0;  ///< Full widths.
  double ball_width = 0.0;
};

/// A body of one size: the positions of its joints and the masses of its segments. A value, without a posture.
///
/// Frames as in skeleton.h, world Z up with the floor at 0. Built by makeFigure() from body dimensions; joint centres
/// are placed from ANSUR II landmarks by the offsets that docs/dev/mannequin.md lists.
struct Figure {
  Sex sex = Sex::kMale;
  BodyDimensions body;
  std::array<dvec3, kSegmentCount> p_PS{};   ///< Each segment's origin in its parent's frame; the pelvis's: height of
                                             ///< the mid-hip point above the floor when standing at zero posture.
  std::array<dvec3, kSegmentCount> p_SC{};   ///< Centre of mass in the segment's frame (de Leva 1996).
  std::array<double, kSegmentCount> mass{};  ///< kg; the sum is body[kMass].
  Sole sole;
  dvec3 p_HeadEyes{0.0};                      ///< Point between the eyes, head frame.
  dvec3 p_HeadVertex{0.0};                    ///< Top of the head, head frame.
  std::array<dvec3, 2> p_ClavicleAcromion{};  ///< Landmark in the clavicle's frame; left, right.
  std::array<dvec3, 2> p_HandGrip{};          ///< Centre of the grip in the hand's frame; left, right.

  double totalMass() const { return body[Dimension::kMass]; }
  double upperArmLength() const { return glm::length(p_PS[indexOf(Segment::kLeftForearm)]); }
  double forearmLength() const {
    return glm::length(p_PS[indexOf(Segment::kLeftWrist)]) + glm::length(p_PS[indexOf(Segment::kLeftHand)]);
  }
  double thighLength() const { return glm::length(p_PS[indexOf(Segment::kLeftShank)]); }
  double shankLength() const { return glm::length(p_PS[indexOf(Segment::kLeftFoot)]); }
};

/// Builds the figure. Errors: those of bodyDimensions(); own dimensions that contradict each other (a knee above the
/// hip).
Expected<Figure> makeFigure(const BodyRequest& request);

/// The four figures that represent the range of users of a workplace: P5 and P50 women, P50 and P95 men.
struct NamedFigure {
  std::string name;  ///< "P5F", "P50F", "P50M", "P95M".
  Figure figure;
};
std::vector<NamedFigure> boundaryFigures();

/// Outer measures of the built figure, from its joints and landmarks at zero posture, metres: `stature`, `span` (arms
/// sideways, girdle raised and drawn back), `acromial_height`, `elbow_height`, `trochanter_height`, `knee_height`
/// (lateral femoral epicondyle), `tibial_height` (our estimate: 0.0165 of the stature below the knee), `eye_height`,
/// `sitting_height`, `biacromial_breadth`, `hand_length`, `foot_length` ...
std::map<std::string, double> measuresOf(const Figure& figure);

}  // namespace hapticell::mannequin
