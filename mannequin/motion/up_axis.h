// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "geometry/shapes/vector.h"
#include "geometry/system/error.h"
#include "geometry/system/text_case.h"

namespace hapticell::mannequin {

/// The axis of a file that points up.
enum class UpAxis { kX, kY, kZ, kMinusX, kMinusY, kMinusZ };

/// "x", "y", "z", with "-" before it if it points down; "+" and capitals are allowed. Otherwise an error for --up.
inline Expected<UpAxis> parseUpAxis(std::string_view text);
/// "x", "-z" ...
inline const char* nameOf(UpAxis axis);
/// The axis as a unit vector in the file's axes.
inline dvec3 directionOf(UpAxis axis);
/// Turns the file's axes so that `up` becomes Z; +Z leaves everything as it is, +Y becomes Z and Z becomes -Y.
inline dmat3 uprightTurn(UpAxis up);

/// The axis along which `upwards` (vectors from low to high parts of a body, frame by frame) point on average; empty if
/// they do not clearly follow an axis (a person who lies, or turns upside down).
inline std::optional<UpAxis> upAxisOf(std::span<const dvec3> upwards);

namespace up_axis {

inline constexpr std::array<const char*, 6> kUpNames = {"x", "y", "z", "-x", "-y", "-z"};
/// Required component of the mean direction along the axis: within 53 deg of it. Half: also if two axes are alike;
/// twice: never. If it is not clear, an assumption is reported.
inline constexpr double kClearlyUp = 0.6;
/// Required ratio to the second axis. Half: always; twice: people that bend much of the time count as unclear.
inline constexpr double kClearlyMore = 1.3;

}  // namespace up_axis

inline Expected<UpAxis> parseUpAxis(std::string_view text) {
  std::string word = lowerCase(text);
  if (word.starts_with('+')) word.erase(0, 1);
  for (std::size_t i = 0; i < up_axis::kUpNames.size(); ++i) {
    if (word == up_axis::kUpNames[i]) return static_cast<UpAxis>(i);
  }
  return makeError({.place = Text::plain("--up"), .found = Text("'%1'", text), .expected = "x, y, z, -x, -y or -z"});
}

inline const char* nameOf(UpAxis axis) {
  return up_axis::kUpNames[static_cast<std::size_t>(axis)];
}

inline dvec3 directionOf(UpAxis axis) {
  const int i = static_cast<int>(axis);
  dvec3 direction(0.0);
  direction[i % 3] = i < 3 ? 1.0 : -1.0;
  return direction;
}

inline dmat3 uprightTurn(UpAxis up) {
  // By rows: what becomes x, y and z.
  const auto rows = [](const dvec3& x, const dvec3& y, const dvec3& z) { return glm::transpose(dmat3(x, y, z)); };
  switch (up) {
    case UpAxis::kX:
      return rows({0, 1, 0}, {0, 0, 1}, {1, 0, 0});
    case UpAxis::kY:
      return rows({1, 0, 0}, {0, 0, -1}, {0, 1, 0});
    case UpAxis::kZ:
      return dmat3(1.0);
    case UpAxis::kMinusX:
      return rows({0, 1, 0}, {0, 0, -1}, {-1, 0, 0});
    case UpAxis::kMinusY:
      return rows({1, 0, 0}, {0, 0, 1}, {0, -1, 0});
    case UpAxis::kMinusZ:
      return rows({1, 0, 0}, {0, -1, 0}, {0, 0, -1});
  }
  return dmat3(1.0);
}

inline std::optional<UpAxis> upAxisOf(std::span<const dvec3> upwards) {
  dvec3 mean(0.0);
  double count = 0.0;
  for (const dvec3& v : upwards) {
    const double length = glm::length(v);
    if (!(length > 1e-9)) continue;
    mean += v / length;
    count += 1.0;
  }
  if (count == 0.0) return std::nullopt;
  mean /= count;
  int best = 0;
  for (int k = 1; k < 3; ++k) best = std::abs(mean[k]) > std::abs(mean[best]) ? k : best;
  double second = 0.0;
  for (int k = 0; k < 3; ++k) second = k == best ? second : std::max(second, std::abs(mean[k]));
  if (std::abs(mean[best]) < up_axis::kClearlyUp || std::abs(mean[best]) < up_axis::kClearlyMore * second)
    return std::nullopt;
  return static_cast<UpAxis>(best + (mean[best] < 0.0 ? 3 : 0));
}

}  // namespace hapticell::mannequin
