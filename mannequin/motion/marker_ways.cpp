// SPDX-License-Identifier: Apache-2.0
#include "mannequin/motion/marker_ways.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace hapticell::mannequin {

Expected<void> MarkerWays::find() {
  findBlind();
  for (const auto& [landmark, markers] : set_.markers) {
    HAPTICELL_TRY(addWay(landmark, markers));
  }
  return {};
}

bool MarkerWays::isSeen(std::size_t f, std::size_t m) const {
  const auto& p = clip_.at(f, m);
  return p && *p != dvec3(0.0);  // Some programs write 0 0 0 for what was not seen.
}

/// Frames in which nothing of the person is seen: before it comes into the cameras' view, and after.
void MarkerWays::findBlind() {
  blind_.assign(clip_.frames(), true);
  std::size_t count = 0;
  for (std::size_t f = 0; f < blind_.size(); ++f) {
    for (const auto& [landmark, markers] : set_.markers) {
      for (const std::size_t m : markers) blind_[f] = blind_[f] && !isSeen(f, m);
    }
    count += blind_[f] ? 1 : 0;
  }
  if (count == 0) return;
  assumptions_.push_back(
      Text("in %1 of %2 frames, no marker is visible; the person is assumed to stand still or to move straight, and "
           "these frames count like others",
           count, blind_.size()));
}

Expected<void> MarkerWays::addWay(const std::string& landmark, const std::vector<std::size_t>& markers) {
  std::vector<dvec3> way(clip_.frames());
  std::vector<bool> seen(way.size(), false);
  for (std::size_t f = 0; f < way.size(); ++f) {
    bool all = true;
    for (const std::size_t m : markers) {
      if (!isSeen(f, m)) {
        all = false;
        break;
      }
      way[f] += *clip_.at(f, m) / static_cast<double>(markers.size());
    }
    seen[f] = all;
  }
  const std::size_t unseen = static_cast<std::size_t>(std::count(seen.begin(), seen.end(), false));
  if (unseen == way.size()) {
    MarkerSet rest = set_;
    rest.markers.erase(landmark);
    if (!missingLandmarks(rest).empty())
      return makeError({.place = "markers",
                        .found = Text("the marker on %1 is never visible", landmark),
                        .expected = "a visible marker"});
    assumptions_.push_back(Text("the marker on %1 is never visible; it is left out", landmark));
    return {};
  }
  if (unseen > 0) fill(landmark, way, seen);
  ways_[landmark] = std::move(way);
  return {};
}

void MarkerWays::fill(const std::string& landmark, std::vector<dvec3>& way, const std::vector<bool>& seen) {
  std::size_t longest = 0, count = 0;
  for (std::size_t f = 0; f < way.size();) {
    if (seen[f]) {
      ++f;
      continue;
    }
    std::size_t end = f;
    while (end < way.size() && !seen[end]) ++end;
    for (std::size_t k = f; k < end; ++k) {
      const double s = static_cast<double>(k - f + 1) / static_cast<double>(end - f + 1);
      if (f == 0)
        way[k] = way[end];
      else
        way[k] = end == way.size() ? way[f - 1] : (1.0 - s) * way[f - 1] + s * way[end];
    }
    const auto first = blind_.begin() + static_cast<std::ptrdiff_t>(f);
    const auto last = blind_.begin() + static_cast<std::ptrdiff_t>(end);
    const std::size_t here = static_cast<std::size_t>(std::count(first, last, false));
    longest = std::max(longest, here > 0 ? end - f : 0);
    count += here;
    f = end;
  }
  if (count == 0) return;
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.2f", static_cast<double>(longest) * clip_.frame_time);
  assumptions_.push_back(
      Text("the marker on %1 is not visible in %2 of %3 frames, for at most %4 s; its position is interpolated",
           landmark, count, way.size(), std::string(seconds)));
}

}  // namespace hapticell::mannequin
