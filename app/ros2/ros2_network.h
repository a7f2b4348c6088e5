// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>
#include <QWidget>

class QCheckBox;
class QSpinBox;

namespace hapticell::app {

/// Where in the network other programs of ROS 2 are looked for; at first as the environment has it (ROS_DOMAIN_ID,
/// ROS_LOCALHOST_ONLY).
class Ros2Network : public QWidget {
  Q_OBJECT
 public:
  explicit Ros2Network(QWidget* parent = nullptr);
  /// A job of hapticell-ros2 with the fields `domain` and `this_machine`, whose sentences come as texts.
  QJsonObject job(const QString& what) const;

 private:
  QSpinBox* domain_;
  QCheckBox* this_machine_;
};

}  // namespace hapticell::app
