// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/system/text.h"
#include "haptic/protocol/messages.h"

namespace hapticell::haptic {

/// Why a client is not connected, and what the user can do about it; either may be empty. A value.
struct LinkProblem {
  Text what;
  Text fix{};

  bool empty() const { return what.empty() && fix.empty(); }
  bool operator==(const LinkProblem&) const = default;
};

/// Both sentences as one text.
Text wholeText(const LinkProblem& problem);
/// Both sentences in English.
std::string english(const LinkProblem& problem);

/// The text of a refusal for the user; for a reason not known here, the server's own sentence.
LinkProblem problemOf(const Refusal& refusal);

}  // namespace hapticell::haptic
