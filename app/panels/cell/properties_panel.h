// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "app/controls/joint_row.h"
#include "workcell/entity/entity.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QVBoxLayout;

namespace hapticell::kinematics {
class InverseModel;
}

namespace hapticell::app {

class EntityChoices;
class Host;
class FrameFields;
class ReferenceChoice;
class Segmented;
class SwatchRow;
class ValueField;

/// Pose, joints and choices of the selected entity; poses in the world or in a chosen frame. Typed values become
/// commands of the document. The panel shows where the entity is now, even while it is held.
class PropertiesPanel : public QWidget {
  Q_OBJECT
 public:
  explicit PropertiesPanel(Host& host, QWidget* parent = nullptr);
  ~PropertiesPanel() override;
  /// Shows the newest numbers; called a few times a second.
  void showNow();

 private:
  /// The six fields of one pose.
  struct PoseBlock {
    QWidget* holder = nullptr;
    QLabel* heading = nullptr;
    std::array<ValueField*, 6> fields{};
  };
  PoseBlock addPose(QVBoxLayout& column, const char* name);
  void rebuild();
  void rebuildJoints();
  void showConfiguration(const workcell::Entity& robot, const Pose& X_WE, const std::vector<double>& q);
  void showReference();
  Pose reference_W() const;
  Pose placeReference_W() const;
  void show(const PoseBlock& block, const Pose& X);
  Pose typed(const PoseBlock& block) const;
  void placeEntity(const Pose& X_WE);
  void placeTool(const Pose& X_WT);
  void moveJoint(std::size_t variable, double value);
  const workcell::Entity* entity() const;
  std::vector<double> joints() const;
  bool isHeld() const;

  Host& host_;
  QLabel* nothing_;
  QWidget* content_;
  ReferenceChoice* reference_;  ///< The reference that both poses are given in.
  QWidget* reference_row_;
  PoseBlock tool_, place_;
  FrameFields* frame_;
  EntityChoices* choices_;
  QWidget* joints_holder_;
  QVBoxLayout* joints_column_;
  std::vector<JointRow*> rows_;
  QLabel* configuration_ = nullptr;                    ///< "front · up · no flip".
  std::unique_ptr<kinematics::InverseModel> inverse_;  ///< For the tip link; null for long chains.
  std::string shown_tip_;
  std::vector<double> shown_joints_;  ///< The joint values whose configuration is shown.
  const void* shown_model_ = nullptr;
};

}  // namespace hapticell::app
