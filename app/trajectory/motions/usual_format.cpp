// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/motions/usual_format.h"

#include <QRegularExpression>

#include "kinematics/model/configuration_flags.h"

namespace hapticell::app {

QString usualFormat(const kinematics::RobotModel& model) {
  switch (kinematics::makerOf(model)) {
    case kinematics::Maker::kKuka: return "krl";
    case kinematics::Maker::kAbb: return "rapid";
    case kinematics::Maker::kFanuc: return "fanuc";
    case kinematics::Maker::kUnknown: break;
  }
  const QString name = QString::fromStdString(model.name).toLower();
  // ur5, ur10e, ur_20: not "turntable".
  static const QRegularExpression kUniversal("(^|[^a-z])ur[ _]?(3|5|7|8|10|12|15|16|18|20|30)e?($|[^a-z0-9])");
  if (kUniversal.match(name).hasMatch()) return "urscript";
  if (name.contains("staubli") || name.contains("stäubli")) return "val3";
  if (name.contains("motoman") || name.contains("yaskawa")) return "inform";
  return "ros";
}

}  // namespace hapticell::app
