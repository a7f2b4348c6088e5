// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/system/text.h"

namespace hapticell {

/// An error in input from outside (a file, a socket, a user), worded for the user.
///
/// A function that returns an error has not changed the document. Broken contracts are assertions, not errors.
struct Error {
  std::string file{};  ///< The file or address; empty if the error has no file.
  Text place{};        ///< "line 12", "triangle 408 of 2 000", "joint 'A3'"; empty: the whole file.
  Text found{};        ///< What was found there.
  Text expected{};     ///< What should have been there.
  Text fix{};          ///< What the user can do about it; a whole sentence or empty.

  /// In English, in one line: "FILE, PLACE: FOUND; expected EXPECTED. FIX"; parts that are empty are left out. The
  /// window shows errors by shownText() (app/style/library_text.h).
  std::string message() const;
  /// The same as a text, for a remark or as what another error found. Foreign words in it are as they came.
  Text text() const;
};

template <typename T>
using Expected = tl::expected<T, Error>;

/// Wraps an error for return from a function that returns Expected: makeError({.place = "--set", .found = "..."}).
inline tl::unexpected<Error> makeError(Error error) {
  return tl::unexpected<Error>(std::move(error));
}

/// What the system says of an error number (errno), in the language of the system.
Text systemText(int error_number);

/// If the given Expected holds an error, returns that error from the enclosing function: HAPTICELL_TRY(readHead(file));
/// The Expected may have any type. If you need its value afterwards, store it in a variable first.
#define HAPTICELL_TRY(expected)                                                                             \
  do {                                                                                                      \
    if (auto&& outcome_of_try = (expected); !outcome_of_try) return tl::unexpected(outcome_of_try.error()); \
  } while (false)

/// Collects what a reader noticed without failing: dropped triangles, an unknown tag, a guessed unit.
struct Diagnostics {
  std::vector<Text> warnings;  ///< A sentence each.
  void warn(Text text) { warnings.push_back(std::move(text)); }
};

}  // namespace hapticell
