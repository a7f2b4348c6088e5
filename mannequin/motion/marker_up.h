// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "mannequin/motion/marker_clip.h"

namespace hapticell::mannequin {

/// Turns the clip, whose positions are in the file's own axes, so that z is up, and gives the reason. `told` has
/// priority; `screen` is the file's POINT:Y_SCREEN, empty if it has none.
inline void turnUpright(MarkerClip& clip, std::optional<UpAxis> told, const std::string& screen);

namespace marker_up {

/// Number of frames examined for a mean direction. Half, twice: only computing time changes for motions of a person.
inline constexpr std::size_t kMostLooked = 300;

/// Height class of a marker on the body, by its usual name: 3 head, 2 shoulders and chest, 1 pelvis, 0 knees, -1 feet.
inline std::optional<int> heightOf(const std::string& name) {
  std::string word;
  for (const char c : name.substr(name.find_last_of(":|") == std::string::npos ? 0 : name.find_last_of(":|") + 1)) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  const auto has = [&](std::span<const char* const> parts) {
    return std::any_of(parts.begin(), parts.end(), [&](const char* p) { return word.find(p) != std::string::npos; });
  };
  constexpr std::array kHead = {"HEAD", "FHD", "BHD", "HDF", "HDB"};
  constexpr std::array kChest = {"SHO", "ACR", "CLAV", "STRN", "STER", "CHEST", "SAJ", "SJN", "CV7"};
  constexpr std::array kPelvis = {"ASI", "PSI", "SACR", "VSAC", "FWT", "BWT", "IAS", "IPS", "HIP"};
  constexpr std::array kFoot = {"ANK", "HEE", "HEL", "TOE", "MT5", "MT1", "FOOT", "FCC", "CAL", "MALL", "MET"};
  constexpr std::array kKnee = {"KNE", "FLE", "FME"};
  if (has(kFoot)) return -1;
  if (has(kHead)) return 3;
  if (has(kKnee)) return 0;
  if (has(kPelvis)) return 1;
  if (word == "C7" || word.ends_with("SHO") || has(kChest)) return 2;
  return std::nullopt;
}

/// From the lowest known markers to the highest, frame by frame.
inline std::vector<dvec3> upwardsOf(const MarkerClip& clip) {
  std::vector<std::optional<int>> heights;
  for (const std::string& name : clip.names) heights.push_back(heightOf(name));
  std::vector<dvec3> upwards;
  const std::size_t every = std::max<std::size_t>(1, clip.frames() / kMostLooked);
  for (std::size_t f = 0; f < clip.frames(); f += every) {
    std::array<dvec3, 5> sum{};
    std::array<double, 5> count{};
    for (std::size_t m = 0; m < clip.names.size(); ++m) {
      if (!heights[m] || !clip.at(f, m) || *clip.at(f, m) == dvec3(0.0)) continue;  // 0 0 0: not visible.
      const std::size_t at = static_cast<std::size_t>(*heights[m] + 1);
      sum[at] += *clip.at(f, m);
      count[at] += 1.0;
    }
    std::optional<std::size_t> low, high;
    for (std::size_t k = 0; k < count.size(); ++k) {
      if (count[k] == 0.0) continue;
      if (!low) low = k;
      high = k;
    }
    // Pelvis to shoulders is enough; knees to feet is not: they may be crossed.
    if (low && *high >= 2 && *high > *low) upwards.push_back(sum[*high] / count[*high] - sum[*low] / count[*low]);
  }
  return upwards;
}

/// The longest side of all markers, where it is a standing person's; up is away from the floor at 0.
inline std::optional<UpAxis> longestSide(const MarkerClip& clip) {
  dvec3 sides(0.0), middle(0.0), least(1e12);
  double count = 0.0;
  const std::size_t every = std::max<std::size_t>(1, clip.frames() / kMostLooked);
  for (std::size_t f = 0; f < clip.frames(); f += every) {
    dvec3 low(1e12), high(-1e12);
    for (std::size_t m = 0; m < clip.names.size(); ++m) {
      if (const auto& p = clip.at(f, m); p && *p != dvec3(0.0)) low = glm::min(low, *p), high = glm::max(high, *p);
    }
    if (high.x < low.x) continue;
    least = glm::min(least, high - low);
    sides += high - low;
    middle += 0.5 * (high + low);
    count += 1.0;
  }
  if (count == 0.0) return std::nullopt;
  sides /= count;
  middle /= count;
  int best = 0;
  for (int k = 1; k < 3; ++k) best = sides[k] > sides[best] ? k : best;
  double second = 0.0;
  for (int k = 0; k < 3; ++k) second = k == best ? second : std::max(second, sides[k]);
  if (sides[best] < 0.8 || sides[best] > 2.5 || sides[best] < 1.3 * second) return std::nullopt;
  if (least[best] < 0.7 * sides[best]) return std::nullopt;
  if (std::abs(middle[best]) < 0.25 * sides[best]) return std::nullopt;
  return static_cast<UpAxis>(best + (middle[best] < 0.0 ? 3 : 0));
}

inline Text axisWord(UpAxis axis) {
  return Text("the file's %1 axis", nameOf(axis));
}

inline UpAxis chosenUp(MarkerClip& clip, std::optional<UpAxis> told, const std::string& screen) {
  std::optional<UpAxis> said;
  if (const auto axis = parseUpAxis(screen)) said = *axis;
  const std::optional<UpAxis> seen = upAxisOf(upwardsOf(clip));
  const auto warn = [&](Text text) { clip.warnings.push_back(std::move(text)); };
  if (told) {
    if ((seen && *seen != *told) || (!seen && said && *said != *told))
      warn(seen ? Text("%1 is used as up, as set; the body stands along %2", axisWord(*told), axisWord(*seen))
                : Text("%1 is used as up, as set; the file states %2", axisWord(*told), axisWord(*said)));
    return *told;
  }
  if (seen && said && *seen != *said) {
    warn(
        Text("the file states that %1 is up (Y_SCREEN), but the body stands along %2, which is used; to change this, "
             "use --up",
             axisWord(*said), axisWord(*seen)));
    return *seen;
  }
  if (said) return *said;
  if (seen) {
    warn(Text("the file does not state which axis is up; the body stands along %1, which is used", axisWord(*seen)));
    return *seen;
  }
  if (const auto side = longestSide(clip)) {
    warn(
        Text("the file does not state which axis is up; the markers extend furthest along %1, which is used; to change "
             "this, use --up",
             axisWord(*side)));
    return *side;
  }
  warn(Text("neither the file nor its markers show which axis is up; z is assumed; to change this, use --up"));
  return UpAxis::kZ;
}

}  // namespace marker_up

inline void turnUpright(MarkerClip& clip, std::optional<UpAxis> told, const std::string& screen) {
  clip.up = marker_up::chosenUp(clip, told, screen);
  const dmat3 R = uprightTurn(clip.up);
  for (std::optional<dvec3>& p : clip.places) {
    if (p) *p = R * *p;
  }
}

}  // namespace hapticell::mannequin
