// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <span>

#include "geometry/system/error.h"
#include "geometry/system/text.h"
#include "haptic/protocol/link_problem.h"

namespace hapticell::app {

/// A sentence of the libraries under the window as the user reads it: in the window's language and the units in force.
/// Thread-safe as tr() is.
QString shownText(const Text& text);
/// Several, with "; " between them.
QString shownText(std::span<const Text> texts);
/// An error in one line, as Error::message() in English.
QString shownText(const Error& error);
/// Why there is no connection to a haptic server, and what to do about it.
QString shownText(const haptic::LinkProblem& problem);

}  // namespace hapticell::app
