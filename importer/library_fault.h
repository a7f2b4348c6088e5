// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/system/error.h"

namespace hapticell::importer {

/// The meaning of a library's own word for a fault ("std::bad_alloc", "stoi", "Standard_NullObject") for the file, and
/// the remedy; the word itself is added in brackets only if nothing more is known. Without file and place.
Error libraryFault(const std::string& words);

}  // namespace hapticell::importer
