// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "geometry/shapes/pose.h"

namespace hapticell::manipulation {

struct EntityConfiguration;

/// Postures of a standing figure that are found anew, not by following the hand: the stations of a way round. See
/// Manipulator::postureFinder(). Used by one thread at a time.
class PostureFinder {
 public:
  /// Where a search for a posture begins: how the figure stands, or upright on the same feet with hanging arms.
  enum class Anew { kAsItStands, kUpright };
  /// Postures with the moved frame at `p_WM` (within a millimetre), found anew and not by following, the nearest to
  /// `from` first: how the hands turn is left open, so that arms may come from another side; from upright, to either
  /// side as well. Feet stand where they are. None where `interrupted` (may be empty) says so on the way.
  virtual std::vector<EntityConfiguration> solvedAnew(const EntityConfiguration& from, const dvec3& p_WM, Anew anew,
                                                      const std::function<bool()>& interrupted) const = 0;
  /// Upright on the same feet: the arms hanging, and before the body.
  virtual std::vector<EntityConfiguration> upright(const EntityConfiguration& from) const = 0;
  /// The same, moved and turned on the floor to where a hand works at `p_WM` with ease: facing it from there, facing on.
  virtual std::vector<EntityConfiguration> uprightBefore(const EntityConfiguration& from, const dvec3& p_WM) const = 0;
  /// Unit, level: where the feet head.
  virtual dvec3 facing_W(const EntityConfiguration& configuration) const = 0;

 protected:
  ~PostureFinder() = default;
};

}  // namespace hapticell::manipulation
