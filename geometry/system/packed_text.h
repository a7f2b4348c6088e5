// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "geometry/system/error.h"
#include "geometry/system/text.h"

namespace hapticell {

/// A text as one line of bytes for another process of the program: its id and arguments, so that the receiver can still
/// translate it. Control characters in arguments become blanks.
std::string packed(const Text& text);
/// The text that packed() made; empty if `line` is something else.
std::optional<Text> unpackedText(std::string_view line);

/// An error without its file, on one line.
std::string packed(const Error& error);
/// The error that packed() made; empty if `line` is something else.
std::optional<Error> unpackedError(std::string_view line);

}  // namespace hapticell
