// SPDX-License-Identifier: Apache-2.0
#include "app/robot/configuration_model.h"

#include <QHash>
#include <algorithm>
#include <cmath>

#include "app/controls/joint_row.h"
#include "app/style/library_text.h"
#include "app/style/units.h"

namespace hapticell::app {

QString shortConfiguration(const std::string& configuration) {
  const QHash<QString, QString> words{
      {"front", QObject::tr("front")},        {"back", QObject::tr("back")},
      {"elbow up", QObject::tr("up")},        {"elbow down", QObject::tr("down")},
      {"wrist flipped", QObject::tr("flip")}, {"wrist not flipped", QObject::tr("no flip")}};
  QStringList shown;
  for (const QString& part : QString::fromStdString(configuration).split(QStringLiteral(", ")))
    shown << words.value(part, part);
  return shown.join(QStringLiteral(" · "));
}

QString shortFlags(const std::string& flags) {
  QString text = QString::fromStdString(flags);
  if (!text.startsWith(QStringLiteral("cf1 "))) return text;
  for (const char* name : {"cf1 ", "cf4 ", "cf6 ", "cfx "}) text.remove(QLatin1String(name));
  return QLatin1Char('[') + text.remove(QLatin1Char(' ')) + QLatin1Char(']');
}

QString travelText(const kinematics::RobotModel& model, const std::vector<double>& from,
                   const std::vector<double>& to) {
  double degrees = 0.0, millimetres = 0.0;
  for (std::size_t i = 0; i < std::min({model.dof(), from.size(), to.size()}); ++i) {
    const auto& joint = model.joints[static_cast<std::size_t>(model.moving[i])];
    (joint.type == kinematics::JointType::kPrismatic ? millimetres : degrees) +=
        std::abs(to[i] - from[i]) / unitOf(joint);
  }
  const QString turn = QStringLiteral("%1°").arg(std::lround(degrees));
  const QString slide = lengthText(0.001 * millimetres, 0);
  if (millimetres < 0.5) return QObject::tr("%1 in total").arg(turn);
  return degrees < 0.5 ? QObject::tr("%1 in total").arg(slide) : QObject::tr("%1 and %2 in total").arg(turn, slide);
}

QString limitText(const kinematics::RobotModel& model, const kinematics::ListedSolution& solution) {
  const auto number = static_cast<std::size_t>(solution.limiting_joint);
  if (solution.limiting_joint < 0 || number >= model.joints.size()) return shownText(solution.reason);
  const auto& joint = model.joints[number];
  const auto variable = static_cast<std::size_t>(std::max(joint.variable, 0));
  if (joint.variable < 0 || variable >= solution.q.size()) return shownText(solution.reason);
  const double q = solution.q[variable];
  const double over = std::max(joint.lower - q, q - joint.upper) / unitOf(joint);
  const JointRow::Scale scale = scaleOf(joint, variable);
  const QString unit = scale.unit == QStringLiteral("°") ? scale.unit : QStringLiteral(" ") + scale.unit;
  return QObject::tr("%1 over limit by %2").arg(scale.name, QString::number(over, 'f', 1) + unit);
}

void ConfigurationModel::setSolutions(const kinematics::RobotModel* model,
                                      std::vector<kinematics::ListedSolution> solutions, const std::vector<double>& now,
                                      const QString& maker) {
  beginResetModel();
  rows_.clear();
  has_flags_ = false;
  maker_ = maker;
  for (kinematics::ListedSolution& solution : solutions) {
    Row row;
    row.arm = shortConfiguration(solution.configuration);
    if (row.arm.isEmpty()) row.arm = tr("Solution %1").arg(rows_.size() + 1);
    if (solution.is_now) {
      row.way = Way::kNow;
      row.way_text = tr("current");
    } else if (solution.within_limits) {
      row.way = Way::kUnknown;
      row.way_text = travelText(*model, now, solution.q);
    } else {
      row.way = Way::kOutOfLimits;
      row.way_text = limitText(*model, solution);
    }
    row.reason = shownText(solution.reason);
    has_flags_ = has_flags_ || !solution.maker_flags.empty();
    row.solution = std::move(solution);
    rows_.push_back(std::move(row));
  }
  endResetModel();
}

void ConfigurationModel::setWay(int row, bool free, const QString& obstacle, const QString& reason) {
  if (row < 0 || row >= rowCount()) return;
  Row& changed = rows_[static_cast<std::size_t>(row)];
  changed.way = free ? Way::kFree : Way::kBlocked;
  if (!free) {
    changed.way_text = obstacle.isEmpty() ? reason : tr("touches %1").arg(obstacle);
    changed.reason = reason;
  }
  emit dataChanged(index(row, 0), index(row, kColumns - 1));
}

int ConfigurationModel::reachable() const {
  return static_cast<int>(
      std::count_if(rows_.begin(), rows_.end(), [](const Row& row) { return row.solution.within_limits; }));
}

int ConfigurationModel::rowOf(const std::vector<double>& joints) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto& q = rows_[i].solution.q;
    if (std::equal(q.begin(), q.end(), joints.begin(), joints.end(),
                   [](double a, double b) { return std::abs(a - b) < 1e-6; }))
      return static_cast<int>(i);
  }
  return -1;
}

int ConfigurationModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ConfigurationModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QVariant ConfigurationModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  if (role == kWayRole) return static_cast<int>(row.way);
  if (role == Qt::ToolTipRole) return row.reason.isEmpty() ? row.arm : row.arm + "\n" + row.reason;
  if (role == Qt::AccessibleTextRole)
    return row.arm + ", " + QString::fromStdString(row.solution.maker_flags) + ", " + row.way_text;
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kArm:
      return row.arm;
    case kFlags:
      return shortFlags(row.solution.maker_flags);
    default:
      return row.way_text;
  }
}

QVariant ConfigurationModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  if (section == kFlags) return maker_.isEmpty() ? tr("Flags") : maker_;
  return section == kArm ? tr("Arm") : tr("Path");
}

}  // namespace hapticell::app
