// SPDX-License-Identifier: Apache-2.0
#include "app/import/change_page.h"

#include <QDateTime>
#include <QObject>
#include <QPageLayout>
#include <QPdfWriter>
#include <QTextDocument>
#include <cmath>
#include <numbers>

#include "app/kit/written_file.h"
#include "workcell/text/file_content.h"

namespace hapticell::app {
namespace {

using Kind = workcell::EntityChange::Kind;

QString fixed(double value, int decimals) {
  const QString text = QString::number(value, 'f', decimals);
  return text.toDouble() == 0.0 && text.startsWith('-') ? text.mid(1) : text;  // A minus zero is never shown.
}

/// "X Y Z" in mm and "A B C" in degrees (about z, y, x in turn).
QString placeText(const Pose& X) {
  const dmat3 r = glm::mat3_cast(X.q);
  const double degrees = 180.0 / std::numbers::pi;
  const double b = std::atan2(-r[0][2], std::hypot(r[0][0], r[0][1]));
  const double a = std::atan2(r[0][1], r[0][0]), c = std::atan2(r[1][2], r[2][2]);
  return QStringLiteral("%1 &nbsp; %2 &nbsp; %3<br>%4 &nbsp; %5 &nbsp; %6")
      .arg(fixed(1000.0 * X.p.x, 3), fixed(1000.0 * X.p.y, 3), fixed(1000.0 * X.p.z, 3), fixed(a * degrees, 3),
           fixed(b * degrees, 3), fixed(c * degrees, 3));
}

QString row(const workcell::EntityChange& change) {
  const QString name = QString::fromStdString(change.name).toHtmlEscaped();
  const QString kind = QString::fromStdString(change.entity_kind);
  const bool before = change.kind != Kind::kAdded, after = change.kind != Kind::kRemoved;
  QString by = QString::fromLatin1(workcell::wordOf(change.kind));
  if (change.kind == Kind::kMoved) {
    by = QObject::tr("%1 mm<br>%2°")
             .arg(fixed(1000.0 * change.distance, 3), fixed(change.angle * 180.0 / std::numbers::pi, 3));
    if (!change.joints.empty()) by += "<br>" + QString::fromStdString(change.joints).toHtmlEscaped();
  }
  return QStringLiteral("<tr><td><b>%1</b><br>%2</td><td>%3</td><td>%4</td><td>%5</td></tr>")
      .arg(name, kind, before ? placeText(change.X_WBefore) : QStringLiteral("–"),
           after ? placeText(change.X_WAfter) : QStringLiteral("–"), by);
}

}  // namespace

QString changesAsHtml(const std::vector<workcell::EntityChange>& changes, const QString& cell, const QString& against) {
  QString rows;
  int moved = 0, added = 0, removed = 0;
  for (const workcell::EntityChange& change : changes) {
    moved += change.kind == Kind::kMoved;
    added += change.kind == Kind::kAdded;
    removed += change.kind == Kind::kRemoved;
    if (change.kind != Kind::kUnchanged) rows += row(change);
  }
  return QStringLiteral(
             "<html><body style='font-family:Roboto,Noto Sans,sans-serif; "
             "font-size:9pt'><h2>%1</h2><p>%2<br>%3<br>%4</p>"
             "<table border='1' cellspacing='0' cellpadding='4' width='100%'><tr><th align='left'>%5</th>"
             "<th align='left'>%6</th><th align='left'>%7</th><th align='left'>%8</th></tr>%9</table></body></html>")
      .arg(QObject::tr("Changes of %1").arg(cell.toHtmlEscaped()),
           QObject::tr("Compared with %1").arg(against.toHtmlEscaped()),
           QDateTime::currentDateTime().toString(Qt::ISODate),
           QObject::tr("%1 moved, %2 added, %3 removed. Placements: X Y Z in mm, A B C in degrees about z, y, x.")
               .arg(moved)
               .arg(added)
               .arg(removed),
           QObject::tr("Entity"), QObject::tr("From"), QObject::tr("To"), QObject::tr("Difference"), rows);
}

Expected<void> writeChanges(const std::vector<workcell::EntityChange>& changes, const QString& cell,
                            const QString& against, const QString& path) {
  if (!path.endsWith(".pdf", Qt::CaseInsensitive))
    return workcell::writeFileAtomically(path.toStdString(), workcell::changesAsCsv(changes, false));
  return writePdf(path, [&](QPdfWriter& writer) {
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(16, 16, 16, 16), QPageLayout::Millimeter);
    writer.setTitle(QObject::tr("Changes of %1").arg(cell));
    QTextDocument page;
    page.setHtml(changesAsHtml(changes, cell, against));
    page.print(&writer);
  });
}

}  // namespace hapticell::app
