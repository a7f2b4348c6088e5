// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mannequin/ergonomics/scores/method_score.h"
#include "mannequin/ergonomics/scores/score_words.h"

namespace hapticell::ergonomics {

enum class BodyPart { kUpperArm, kLowerArm, kWrist, kNeck, kTrunk, kLegs };

/// A part of the body that determines a method's score, labelled at its joint.
struct DrivingPart {
  BodyPart part = BodyPart::kUpperArm;
  mannequin::Side side = mannequin::Side::kRight;  ///< For arms; for legs: of the more bent knee.
  double angle = 0.0;                              ///< As the method measures it, degrees.
  int band = 0;                                    ///< 0 to 3, as the part is coloured.
  bool lowers = false;                             ///< The score decreases if this part alone is at its best.
};

/// At most `most` parts, those that lower the score most first, then those with the worst band; parts at their best are
/// omitted. Takes some microseconds: for each frame.
std::vector<DrivingPart> drivingParts(const PostureScores& scores, PostureMethod method, std::size_t most = 2);

/// "right shoulder"; trunk and neck have no side.
std::string jointWords(const DrivingPart& part, Language language);
/// "raised, drives RULA 6".
std::string drivingWords(const PostureScores& scores, PostureMethod method, const DrivingPart& part, Language language);

/// The angle of a part for drawing: at a joint, from the direction that counts as 0 to the limb.
struct JointAngle {
  dvec3 p_W{0.0};
  dvec3 from_W{0.0}, to_W{0.0};  ///< Unit.
  double length = 0.0;           ///< Of the limb, m.
};
JointAngle jointAngle(const mannequin::FigurePose& pose, const DrivingPart& part);

}  // namespace hapticell::ergonomics
