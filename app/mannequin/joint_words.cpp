// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/joint_words.h"

#include <QObject>
#include <utility>

namespace hapticell::app {

QString jointName(const QString& h_anim_name) {
  QString name = h_anim_name;
  if (name.startsWith("l_") || name.startsWith("r_")) name.remove(0, 2);
  for (const auto& [long_name, short_name] : {std::pair{"sternoclavicular", "girdle"},
                                              {"radioulnar", "forearm"},
                                              {"talocrural", "ankle"},
                                              {"subtalar", "foot"},
                                              {"metatarsal", "toe"},
                                              {"skullbase", "head"}})
    name.replace(QLatin1String(long_name), QLatin1String(short_name));
  return name.replace('_', ' ');
}

QString jointNameWithSide(const QString& h_anim_name) {
  const QString name = jointName(h_anim_name);
  if (h_anim_name.startsWith("l_")) return QObject::tr("left %1").arg(name);
  if (h_anim_name.startsWith("r_")) return QObject::tr("right %1").arg(name);
  return name;
}

}  // namespace hapticell::app
