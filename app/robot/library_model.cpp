// SPDX-License-Identifier: Apache-2.0
#include "app/robot/library_model.h"

#include "app/style/units.h"

#include <algorithm>
#include <cmath>

namespace hapticell::app {
namespace {

QString payloadText(double kilograms) {
  return QObject::tr("%1 kg").arg(kilograms, 0, 'g', 4);
}

}  // namespace

LibraryModel::LibraryModel(std::vector<workcell::LibraryRobot> robots, QObject* parent) : QAbstractListModel(parent) {
  for (workcell::LibraryRobot& robot : robots) rows_.push_back({std::move(robot), {}, 0.0, {}});
  std::stable_sort(rows_.begin(), rows_.end(), [](const Row& a, const Row& b) {
    return std::tie(a.robot.sheet.maker, a.robot.sheet.payload) < std::tie(b.robot.sheet.maker, b.robot.sheet.payload);
  });
}

const workcell::Entity* LibraryModel::entity(int row) const {
  const auto& entity = rows_[static_cast<std::size_t>(row)].entity;
  return entity ? &*entity : nullptr;
}

void LibraryModel::setEntity(int row, workcell::Entity entity, double reach) {
  Row& changed = rows_[static_cast<std::size_t>(row)];
  changed.entity = std::move(entity);
  changed.reach = changed.robot.sheet.reach > 0.0 ? changed.robot.sheet.reach : reach;
  emit dataChanged(index(row), index(row));
}

void LibraryModel::setPicture(int row, const QImage& picture) {
  rows_[static_cast<std::size_t>(row)].picture = picture;
  emit dataChanged(index(row), index(row));
}

std::vector<std::pair<QString, QString>> LibraryModel::sheet(int number) const {
  const Row& row = rows_[static_cast<std::size_t>(number)];
  const workcell::RobotSheet& sheet = row.robot.sheet;
  std::vector<std::pair<QString, QString>> lines{{tr("Manufacturer"), QString::fromStdString(sheet.maker)},
                                                 {tr("Type"), QString::fromStdString(sheet.kind)}};
  if (sheet.payload > 0.0) lines.emplace_back(tr("Payload"), payloadText(sheet.payload));
  if (row.entity) lines.emplace_back(tr("Joints"), QString::number(row.entity->robot()->dof()));
  if (row.reach > 0.0) lines.emplace_back(tr("Reach"), tr("%1 to the flange").arg(lengthText(row.reach, 0)));
  if (!sheet.source.empty()) lines.emplace_back(tr("Source"), QString::fromStdString(sheet.source));
  return lines;
}

QStringList LibraryModel::makers() const {
  QStringList makers;
  for (const Row& row : rows_) makers << QString::fromStdString(row.robot.sheet.maker);
  makers.removeDuplicates();
  makers.sort(Qt::CaseInsensitive);
  return makers;
}

int LibraryModel::rowOf(const std::string& name) const {
  const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) { return row.robot.name == name; });
  return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

int LibraryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant LibraryModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const workcell::RobotSheet& sheet = row.robot.sheet;
  const QString name = QString::fromStdString(sheet.name);
  QStringList second{QString::fromStdString(sheet.maker), QString::fromStdString(sheet.kind)};
  if (sheet.payload > 0.0) second << payloadText(sheet.payload);
  if (row.reach > 0.0) second << lengthText(row.reach, 0);
  second.removeAll(QString());
  switch (role) {
    case Qt::DisplayRole:
      return name;
    case kSecondLineRole:
      return second.join(QStringLiteral(" · "));
    case Qt::AccessibleTextRole:
      return name + QStringLiteral(", ") + second.join(QStringLiteral(", "));
    case kPictureRole:
      return row.picture;
    case kMakerRole:
      return QString::fromStdString(sheet.maker);
    case kSearchRole:
      return name + QLatin1Char(' ') + second.join(QLatin1Char(' ')) + QLatin1Char(' ') +
             QString::fromStdString(row.robot.name);
    default:
      return {};
  }
}

}  // namespace hapticell::app
