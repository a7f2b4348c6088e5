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

/// Both sentences in English.
std::string english(const LinkProblem& problem);

/// What a refusal tells the user; a reason that is not known here is told in the server's own sentence.
LinkProblem problemOf(const Refusal& refusal);

}  // namespace hapticell::haptic
