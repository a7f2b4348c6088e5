// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>

namespace hapticell::app {

/// The OpenGL that this display offers, as a line of JSON: "version", "renderer", "vendor" and "software" (true: the
/// processor draws), or "problem". `hapticell --probe-graphics` prints it for `hapticell-cli doctor`. GUI thread.
QByteArray probeGraphics();

}  // namespace hapticell::app
