// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <span>

#include "geometry/system/error.h"
#include "geometry/system/text.h"
#include "haptic/protocol/link_problem.h"

namespace hapticell::app {

/// A text of the libraries as the user reads it: in the window's language and the units that the user chose.
/// Thread-safe as tr() is.
QString shownText(const Text& text);
/// Several texts, separated by "; ".
QString shownText(std::span<const Text> texts);
/// An error in one line, like Error::message() in English.
QString shownText(const Error& error);
/// Why there is no connection to a haptic server, and what to do about it.
QString shownText(const haptic::LinkProblem& problem);

}  // namespace hapticell::app
