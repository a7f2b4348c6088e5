// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::workcell {

// The header of the Stanford polygon format (G. Turk, "The PLY Polygon File Format", 1994).

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };
enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

/// Size of one value in bytes.
std::size_t sizeOf(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat32;
  bool is_list = false;
  PlyType count_type = PlyType::kUint8;  ///< For a list.
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  std::size_t line = 0;  ///< In the header.

  int find(std::string_view property) const;  ///< Index or -1.
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;  ///< Offset of the data.
  std::size_t lines = 0;
  std::optional<double> metres_per_unit;  ///< As stated by a comment.
};

/// Reads the header and checks that the file is long enough for the stated counts.
Expected<PlyHeader> readPlyHeader(std::string_view content);

}  // namespace hapticell::workcell
