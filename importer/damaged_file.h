// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "geometry/system/error.h"

namespace hapticell::importer {

/// The error for invalid content of a file that another program wrote.
inline Error damagedFile(Text place, Text found, Text expected) {
  return {
      .place = std::move(place), .found = std::move(found), .expected = std::move(expected), .fix = "Export it again."};
}

}  // namespace hapticell::importer
