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
  std::vector<std::shared_ptr<const Entity>> other;  ///< Carried by its other links, so not a load of the flange.
  double mass = 0.0;                                 ///< kg, of `parts`; those of `starting` count as 1 kg.
  std::vector<std::string> starting;                 ///< Names of `parts` whose initial mass nobody has changed.
  std::string link;                                  ///< The tip link; L is its frame.
  dvec3 p_LC{0.0};  ///< Centre of mass, m; each part is assumed to have uniform density.
};

/// Empty, except for `link`, if the robot carries nothing. Linear in the number of triangles carried. Any thread.
CarriedLoad carriedLoad(const DocumentState& state, const Entity& robot);

/// The robot's load compared with its payload (kg; 0: unknown).
enum class LoadVerdict {
  kNothing,   ///< It carries nothing at its flange.
  kTooHeavy,  ///< Above the payload.
  kOpen,      ///< The payload is unknown, or a part still has the initial mass.
  kAllowed,   ///< Not above the payload; the maker's load diagram says up to which distance from the flange.
};
LoadVerdict verdictOn(const CarriedLoad& load, double payload);

}  // namespace hapticell::workcell
