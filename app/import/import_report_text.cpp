// SPDX-License-Identifier: Apache-2.0
#include "app/import/import_report_text.h"

#include <QObject>
#include <QStringList>

#include "app/import/import_choices.h"

namespace hapticell::app {

QString reportText(const workcell::ImportReport& report) {
  const auto count = [](std::size_t n) { return countText(static_cast<double>(n)); };
  const QString unit = unitText(report.metres_per_unit);
  QStringList sentences;
  sentences << QObject::tr("%1 %2, %3 triangles. One unit of the file is one %4%5.")
                   .arg(count(report.parts), report.parts == 1 ? QObject::tr("part") : QObject::tr("parts"),
                        count(report.triangles), unit,
                        report.unit_is_stated ? QObject::tr(", from the file") : QObject::tr("; the file states none"));
  if (report.degenerate_triangles > 0)
    sentences << QObject::tr("Removed: %1 zero-area triangles.").arg(count(report.degenerate_triangles));
  if (report.duplicate_triangles > 0)
    sentences << QObject::tr("Removed: %1 duplicate triangles.").arg(count(report.duplicate_triangles));
  return sentences.join(' ');
}

}  // namespace hapticell::app
