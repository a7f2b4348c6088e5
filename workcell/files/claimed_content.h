// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace hapticell::workcell {

/// Whether a file that another one names (a picture, a material library, a part of an assembly, a buffer) is of a kind
/// that such files name, and begins as its name claims: a picture by its format's first bytes, MTL by `newmtl`, STEP by
/// ISO-10303-21, XML by '<'. A buffer of glTF may hold anything; it counts by its extension. Unlike names: no. Only
/// regular files.
bool isWhatItClaims(const std::filesystem::path& file);

}  // namespace hapticell::workcell
