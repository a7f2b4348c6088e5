// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <vector>

#include "workcell/import/change_report.h"

namespace hapticell::app {

/// A change report for people: a page with what moved from where to where (mm, degrees), what was added and removed.
/// `cell` and `against` are named in its heading.
QString changesAsHtml(const std::vector<workcell::EntityChange>& changes, const QString& cell, const QString& against);

/// Writes the report: PDF (A4) or, by the name's ending, CSV as changesAsCsv(). Any thread, but needs a Qt application.
Expected<void> writeChanges(const std::vector<workcell::EntityChange>& changes, const QString& cell,
                            const QString& against, const QString& path);

}  // namespace hapticell::app
