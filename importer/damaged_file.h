// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "geometry/system/error.h"

namespace hapticell::importer {

/// What is wrong with the content of a file that another program wrote.
inline Error damagedFile(std::string place, std::string found, std::string expected) {
  return {
      .place = std::move(place), .found = std::move(found), .expected = std::move(expected), .fix = "Export it again."};
}

}  // namespace hapticell::importer
