// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "mannequin/motion/marker_clip.h"
#include "mannequin/motion/marker_set.h"

namespace hapticell::mannequin {

/// The landmarks of a person through a whole recording of markers, without gaps: where a marker is not visible it is
/// interpolated on a straight line.
class MarkerWays {
 public:
  /// Clip and set must outlive this.
  MarkerWays(const MarkerClip& clip, const MarkerSet& set) : clip_(clip), set_(set) {}

  /// Finds all; call it first. Error: a required landmark that is never visible.
  Expected<void> find();

  bool has(const std::string& landmark) const { return ways_.contains(landmark); }
  /// In the world, m. @pre has(landmark), frame < clip.frames()
  const dvec3& at(const std::string& landmark, std::size_t frame) const { return ways_.at(landmark)[frame]; }
  /// What was interpolated, and for how long; one sentence each.
  const std::vector<Text>& assumptions() const { return assumptions_; }

 private:
  bool isSeen(std::size_t f, std::size_t m) const;
  void findBlind();
  Expected<void> addWay(const std::string& landmark, const std::vector<std::size_t>& markers);
  void fill(const std::string& landmark, std::vector<dvec3>& way, const std::vector<bool>& seen);

  const MarkerClip& clip_;
  const MarkerSet& set_;
  std::map<std::string, std::vector<dvec3>> ways_;
  std::vector<bool> blind_;  // Frames in which nothing of the person is seen.
  std::vector<Text> assumptions_;
};

}  // namespace hapticell::mannequin
