// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mannequin/body/anthropometry.h"

namespace hapticell::mannequin {

/// The parameters of a body, as workcells store them: "mannequin:SEX:SIZE[:MASSkg][:DIMENSION=M]...", where SIZE is a
/// percentile of stature ("5") or a stature ("1620mm"), and DIMENSION a measure by its ANSUR II name, in metres.
/// Errors: another scheme, sex or word, an invalid number. makeFigure() checks the ranges.
Expected<BodyRequest> parseBodyRequest(const std::string& text);

/// The text of a request; statures to a tenth of a millimetre, masses to 10 g.
std::string bodyRequestText(const BodyRequest& request);

}  // namespace hapticell::mannequin
