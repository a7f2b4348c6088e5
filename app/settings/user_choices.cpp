// SPDX-License-Identifier: Apache-2.0
#include "app/settings/user_choices.h"

#include <QLocale>
#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/user_settings.h"
#include "app/viewport/scene/part_colors.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {

Units unitsFrom(const UserSettings& settings) {
  const auto number = [&](const char* key, int otherwise, int most) {
    return std::clamp(settings.value(QLatin1String(key), otherwise).toInt(), 0, most);
  };
  Units units;
  units.length = static_cast<Units::Length>(number("units/length", 0, 3));
  units.angle = static_cast<Units::Angle>(number("units/angle", 0, 1));
  units.length_decimals = number("units/length_decimals", units.length_decimals, 6);
  units.angle_decimals = number("units/angle_decimals", units.angle_decimals, 6);
  units.force_decimals = number("units/force_decimals", units.force_decimals, 4);
  return units;
}

void storeUnits(const Units& units, UserSettings& settings) {
  settings.setValue("units/length", static_cast<int>(units.length));
  settings.setValue("units/angle", static_cast<int>(units.angle));
  settings.setValue("units/length_decimals", units.length_decimals);
  settings.setValue("units/angle_decimals", units.angle_decimals);
  settings.setValue("units/force_decimals", units.force_decimals);
}

Navigation navigationFrom(const UserSettings& settings) {
  const QString preset = settings.value("navigation/preset", "hapticell").toString();
  if (preset == QLatin1String("own"))
    if (const auto own = navigationFromText(settings.value("navigation/own").toString())) return *own;
  return navigationPreset(preset);
}

QString languageFrom(const UserSettings& settings) {
  const QString chosen = settings.value("language").toString();
  if (chosen == QLatin1String("en") || chosen == QLatin1String("fr")) return chosen;
  return QLocale::system().language() == QLocale::French ? QStringLiteral("fr") : QStringLiteral("en");
}

void followSettings(Host& host, const std::function<void(bool dark)>& set_theme) {
  UserSettings& settings = host.userSettings();
  const auto follow = [&host, &settings, set_theme](const QString& key) {
    const auto is = [&](const char* group) { return key.isEmpty() || key.startsWith(QLatin1String(group)); };
    if (is("units")) setUnitsNow(unitsFrom(settings));
    if (is("navigation")) host.viewport().setNavigation(navigationFrom(settings));
    if (is("motion")) host.viewport().setMotion(settings.value("motion", host.configuration().gui.motion).toBool());
    if (is("colors")) {
      setFullColorsNow(settings.value("colors/full", host.configuration().gui.original_colors).toBool());
      host.viewport().scene().setEntities(host.documentModel().document().snapshotEntities());
      host.viewport().refresh();
    }
    if (is("theme"))
      set_theme(settings.value("theme", QString::fromStdString(host.configuration().gui.theme)).toString() !=
                QLatin1String("light"));
  };
  QObject::connect(&settings, &UserSettings::changed, &host.window(), follow);
  follow({});
}

}  // namespace hapticell::app
