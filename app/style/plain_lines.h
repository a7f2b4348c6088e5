// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace hapticell::app {

/// Text that may hold words of others (names in files, what a server or driver says), as it may be drawn: hapticell's
/// plainText() of each line, at most so many lines of at most 2000 bytes.
QString plainLines(const QString& text, int most_lines = 1);

}  // namespace hapticell::app
