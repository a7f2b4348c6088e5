// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace hapticell {

/// What went wrong with something that came from outside (a file, a socket, a user), in words for the user.
///
/// The document is untouched when one of these is returned. Broken contracts are not errors but assertions.
struct Error {
  std::string file{};   ///< The file or address it is about; empty where there is none.
  std::string place{};  ///< "line 12", "triangle 408 of 2 000", "joint 'A3'"; empty where the file as a whole is meant.
  std::string found{};  ///< What stands there.
  std::string expected{};  ///< What should have stood there.
  std::string fix{};       ///< What the user can do about it; a whole sentence or empty.

  /// One line: "FILE, PLACE: FOUND; expected EXPECTED. FIX"; parts that are empty are left out.
  std::string message() const;
};

template <typename T>
using Expected = tl::expected<T, Error>;

/// Wraps an error for return from a function that returns Expected: makeError({.place = "--set", .found = "..."}).
inline tl::unexpected<Error> makeError(Error error) {
  return tl::unexpected<Error>(std::move(error));
}

/// Returns the error of an Expected from the function it stands in, where there is one: HAPTICELL_TRY(readHead(file));
/// What is given is an Expected of any type, named before where its value is used afterwards.
#define HAPTICELL_TRY(expected)                                                                             \
  do {                                                                                                      \
    if (auto&& outcome_of_try = (expected); !outcome_of_try) return tl::unexpected(outcome_of_try.error()); \
  } while (false)

/// Collects what a reader noticed but could live with: dropped triangles, an unknown tag, a guessed unit.
struct Diagnostics {
  std::vector<std::string> warnings;
  void warn(std::string text) { warnings.push_back(std::move(text)); }
};

}  // namespace hapticell
