// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <array>

namespace hapticell::app {

enum class Vision { kNormal, kProtan, kDeutan };

/// A colour as somebody with dichromatic vision sees it: G. M. Machado, M. M. Oliveira and L. A. F. Fernandes, "A
/// physiologically-based model for simulation of color vision deficiency", IEEE TVCG 15(6), 2009, severity 1.
std::array<double, 3> linearSeenBy(Vision vision, const QColor& color);

/// CIEDE2000 between two linear sRGB colours (G. Sharma, W. Wu and E. N. Dalal, Color Res. Appl. 30(1), 2005).
double ciede2000(const std::array<double, 3>& a, const std::array<double, 3>& b);
/// The same between CIE L*a*b* colours.
double ciede2000Lab(const std::array<double, 3>& a, const std::array<double, 3>& b);

/// Contrast ratio as WCAG 2.1 counts it.
double contrast(const QColor& a, const QColor& b);

}  // namespace hapticell::app
