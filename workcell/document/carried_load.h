// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "workcell/document/document_state.h"

namespace hapticell::workcell {

/// What a robot carries at its flange: all that is attached to the body of its tip link, directly or through others.
struct CarriedLoad {
  std::vector<std::shared_ptr<const Entity>> parts;  ///< In the order of the tree.
  std::vector<std::shared_ptr<const Entity>> other;  ///< Carried by its other links: no load of the flange.
  double mass = 0.0;                                 ///< kg, of `parts`; those of `starting` count with 1 kg.
  std::vector<std::string> starting;  ///< Names of `parts` with the mass that each has before anybody enters one.
  std::string link;                   ///< The tip link, whose frame L the next is in.
  dvec3 p_LC{0.0};                    ///< Centre of mass, m; each part taken as of one density.
};

/// Empty, but for `link`, where the robot carries nothing. Linear in the triangles of what is carried. Any thread.
CarriedLoad carriedLoad(const DocumentState& state, const Entity& robot);

/// The robot's load against the payload that its maker allows (kg; 0: not known).
enum class LoadVerdict {
  kNothing,   ///< It carries nothing at its flange.
  kTooHeavy,  ///< Above the payload.
  kOpen,      ///< Payload not known, or a mass is still the one that parts start with.
  kAllowed,   ///< Not above the payload; how far from the flange that holds, the maker's load diagram says.
};
LoadVerdict verdictOn(const CarriedLoad& load, double payload);

}  // namespace hapticell::workcell
