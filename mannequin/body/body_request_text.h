// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mannequin/body/anthropometry.h"

namespace hapticell::mannequin {

/// What a body is built from, as workcells keep it: "mannequin:SEX:SIZE[:MASSkg][:DIMENSION=M]...", where SIZE is a
/// percentile of stature ("5") or a stature ("1620mm"), and DIMENSION an own measure by its ANSUR II word in metres.
/// Refused: another scheme, sex or word, a number that is none. Ranges are makeFigure()'s to check.
Expected<BodyRequest> parseBodyRequest(const std::string& text);

/// The same text for a request; statures to a tenth of a millimetre, masses to 10 g.
std::string bodyRequestText(const BodyRequest& request);

}  // namespace hapticell::mannequin
