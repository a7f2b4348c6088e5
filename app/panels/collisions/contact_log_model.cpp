// SPDX-License-Identifier: Apache-2.0
#include "app/panels/collisions/contact_log_model.h"

#include "app/viewport/scene/strip_text.h"

namespace hapticell::app {
namespace {

QString seconds(double value) {
  return QObject::tr("%1 s").arg(value, 0, 'f', 2);
}

bool isNumber(int column) {
  return column == ContactLogModel::kTime || column >= ContactLogModel::kDistance;
}

}  // namespace

QString eventLine(const ContactEvent& event) {
  const QString name = QString::fromStdString(eventName(event.kind)).toLower();
  QString line =
      QObject::tr("%1 %2, %3 – %4")
          .arg(seconds(event.time_s), name, QString::fromStdString(event.moved), QString::fromStdString(event.other));
  if (event.kind == ContactEvent::Kind::kContactEnded && event.force_n > 0.0)
    line += QObject::tr(", at most %1").arg(QString::fromStdString(newtons(event.force_n)));
  return line;
}

void ContactLogModel::refresh() {
  if (log_.count() == count_ && static_cast<int>(log_.events().size()) == shown_) return;
  const int fresh = static_cast<int>(log_.events().size());
  const bool only_more = fresh > shown_ && log_.count() - count_ == static_cast<std::size_t>(fresh - shown_);
  if (only_more) {
    beginInsertRows({}, 0, fresh - shown_ - 1);
    shown_ = fresh;
    count_ = log_.count();
    endInsertRows();
    return;
  }
  beginResetModel();
  shown_ = fresh;
  count_ = log_.count();
  endResetModel();
}

QVariant ContactLogModel::data(const QModelIndex& index, int role) const {
  const auto& events = log_.events();
  const int row = static_cast<int>(events.size()) - 1 - index.row();
  if (!index.isValid() || row < 0) return {};
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>((isNumber(index.column()) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  const ContactEvent& event = events[static_cast<std::size_t>(row)];
  const bool ended =
      event.kind == ContactEvent::Kind::kContactEnded || event.kind == ContactEvent::Kind::kNearMissEnded;
  switch (index.column()) {
    case kTime:
      return seconds(event.time_s);
    case kEvent:
      return QString::fromStdString(eventName(event.kind));
    case kMoved:
      return QString::fromStdString(event.moved);
    case kAgainst:
      return QString::fromStdString(event.other);
    case kDistance:
      return QString::fromStdString(millimetres(event.distance));
    case kForce:
      return QString::fromStdString(newtons(event.force_n));
    case kDuration:
      return ended ? seconds(event.duration_s) : QString();
    default:
      return {};
  }
}

QVariant ContactLogModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>((isNumber(section) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  const QString names[kColumns]{tr("Time"),     tr("Event"), tr("Moved"),   tr("Against"),
                                tr("Distance"), tr("Force"), tr("Duration")};
  return names[section];
}

}  // namespace hapticell::app
