// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mannequin/body/skeleton.h"

namespace hapticell::mannequin {

/// A joint's name without the additions of the program that wrote it.
struct JointName {
  enum class Of { kMiddle, kLeft, kRight };
  Of side = Of::kMiddle;
  std::string part;  ///< Small letters without blanks, underscores and closing digits: "upleg", "spine", "head".
};

/// Splits names: removes a namespace ("mixamorig:", "Actor|") or a word that nearly all names begin with ("Bip01 ",
/// "Skeleton_"), and finds the side ("LeftArm", "l_shoulder", "upperarm_l", "LThigh", "lfemur"). One result per name,
/// in their order.
std::vector<JointName> jointNames(const std::vector<std::string>& names);

/// True for words of limbs that show that "lfemur" and "RUArm" have a side.
bool isLimbWord(std::string_view part);

}  // namespace hapticell::mannequin
