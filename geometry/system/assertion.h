// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace hapticell::detail {

/// Prints the broken contract, stores its text for brokenContract() and ends the process by SIGABRT. Never returns.
[[noreturn]] void contractBroken(const char* condition, const char* file, int line);

}  // namespace hapticell::detail

namespace hapticell {

/// "file.cpp:12: condition" of the first contract that was broken in this process; empty if no contract was broken. Any
/// thread; may be called in a signal handler.
const char* brokenContract();

}  // namespace hapticell

/// A contract between pieces of this program, checked in every build. Never for input from outside.
#define HAPTICELL_DEMAND(condition) \
  (static_cast<bool>(condition) ? void(0) : ::hapticell::detail::contractBroken(#condition, __builtin_FILE(), __LINE__))

/// The same, checked in debug builds only (for inner loops).
#ifdef NDEBUG
#define HAPTICELL_ASSERT(condition) static_cast<void>(sizeof(condition))
#else
#define HAPTICELL_ASSERT(condition) HAPTICELL_DEMAND(condition)
#endif
