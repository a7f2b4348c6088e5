// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "kinematics/model/solution_list.h"
#include "manipulation/checks/joint_motion.h"

namespace hapticell::app {

/// The list of a robot's configurations: how the arm is bent, the maker's flags, and the motion to it. GUI thread.
class ConfigurationModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kArm, kFlags, kWay, kColumns };
  enum class Way { kUnknown, kNow, kFree, kBlocked, kOutOfLimits };
  enum Role { kWayRole = Qt::UserRole };

  using QAbstractTableModel::QAbstractTableModel;

  /// Sets a new list; `maker` heads the column of flags ("KUKA"; empty: "Flags").
  void setSolutions(const kinematics::RobotModel* model, std::vector<kinematics::ListedSolution> solutions,
                    const std::vector<double>& now, const QString& maker);
  /// Sets what the check of the motion to a row found; `reason` if it is blocked.
  void setWay(int row, bool free, const QString& obstacle, const QString& reason);

  const kinematics::ListedSolution& solution(int row) const { return rows_[static_cast<std::size_t>(row)].solution; }
  Way way(int row) const { return rows_[static_cast<std::size_t>(row)].way; }
  /// Number of solutions within the limits (even if something is in the way).
  int reachable() const;
  bool hasFlags() const { return has_flags_; }
  /// The row with these joint values, or -1.
  int rowOf(const std::vector<double>& joints) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Row {
    kinematics::ListedSolution solution;
    Way way = Way::kUnknown;
    QString arm, way_text, reason;
  };
  std::vector<Row> rows_;
  QString maker_;
  bool has_flags_ = false;
};

/// "front · up · no flip" for "front, elbow up, wrist not flipped".
QString shortConfiguration(const std::string& configuration);
/// "[0,-1,0,1]", as ABB writes it, for "cf1 0, cf4 -1, cf6 0, cfx 1"; other flags unchanged.
QString shortFlags(const std::string& flags);
/// Sum of the motions of all joints: "186° in all", "186° and 12 mm in all".
QString travelText(const kinematics::RobotModel& model, const std::vector<double>& from, const std::vector<double>& to);
/// "A2 over by 11.4°" for a solution outside the limits.
QString limitText(const kinematics::RobotModel& model, const kinematics::ListedSolution& solution);

}  // namespace hapticell::app
