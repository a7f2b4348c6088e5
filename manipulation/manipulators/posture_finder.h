// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "geometry/shapes/pose.h"

namespace hapticell::manipulation {

struct EntityConfiguration;

/// Finds postures of a standing mannequin by solving again, not by following the hand: the stations of a detour. See
/// Manipulator::postureFinder(). Used by one thread at a time.
class PostureFinder {
 public:
  /// Start of a search for a posture: the present posture, or upright on the same feet with hanging arms.
  enum class StartFrom { kPresent, kUpright };
  /// Postures with the moved frame at `p_WM` (within a millimetre), solved again, the nearest to `from` first. The
  /// hands' orientation is free, so that the arms may come from another side; from upright, also to either side. The
  /// feet stay. Empty if `interrupted` (may be empty) returns true during the search.
  virtual std::vector<EntityConfiguration> solvedFrom(const EntityConfiguration& from, const dvec3& p_WM,
                                                      StartFrom anew,
                                                      const std::function<bool()>& interrupted) const = 0;
  /// Upright postures on the same feet: with hanging arms, and with the arms in front of the body.
  virtual std::vector<EntityConfiguration> upright(const EntityConfiguration& from) const = 0;
  /// The same, moved and turned on the floor so that a hand works at `p_WM` comfortably: facing it from there, or
  /// facing as before.
  virtual std::vector<EntityConfiguration> uprightBefore(const EntityConfiguration& from, const dvec3& p_WM) const = 0;
  /// Unit, horizontal: the direction of the feet.
  virtual dvec3 facing_W(const EntityConfiguration& configuration) const = 0;

 protected:
  ~PostureFinder() = default;
};

}  // namespace hapticell::manipulation
