// SPDX-License-Identifier: Apache-2.0
#include <QLabel>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/host/host.h"
#include "app/host/user_settings.h"
#include "app/kit/form.h"
#include "app/settings/settings_pages.h"
#include "app/settings/user_choices.h"
#include "app/style/segmented.h"

namespace hapticell::app {
namespace {

/// Decimals that show about a tenth of a millimetre, or of a degree.
int usualDecimals(Units::Length length) {
  constexpr int kDecimals[]{1, 2, 4, 3};
  return kDecimals[static_cast<int>(length)];
}

QSpinBox* makeDecimals(const char* name, int most) {
  auto* box = new QSpinBox;
  box->setRange(0, most);
  box->setObjectName(QLatin1String(name));
  box->setButtonSymbols(QAbstractSpinBox::PlusMinus);
  return box;
}

}  // namespace

QWidget* makeUnitsPage(Host& host) {
  UserSettings& settings = host.userSettings();
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* section = addSection(*column, QObject::tr("Units and decimals"));
  auto* length = new Segmented({"mm", "cm", "m", "in"});
  length->setObjectName("segmentsLength");
  auto* angle = new Segmented({QObject::tr("Degrees"), QObject::tr("Radians")});
  angle->setObjectName("segmentsAngle");
  auto* length_decimals = makeDecimals("fieldLengthDecimals", 6);
  auto* angle_decimals = makeDecimals("fieldAngleDecimals", 6);
  auto* force_decimals = makeDecimals("fieldForceDecimals", 4);
  addRow(*section, QObject::tr("Length unit"), length);
  addRow(*section, QObject::tr("Decimals"), length_decimals);
  addRow(*section, QObject::tr("Angle unit"), angle);
  addRow(*section, QObject::tr("Decimals"), angle_decimals);
  addRow(*section, QObject::tr("Forces, N"), force_decimals);
  auto* sample = makeLabel({}, TextRole::kPanelState);
  sample->setObjectName("labelUnits");
  section->addWidget(sample);
  auto* note =
      makeLabel(QObject::tr("You can also type a number with its unit: 2 in, 0.5 m, 1.57 rad. Files are not affected."),
                TextRole::kSecond, true);
  note->setWordWrap(true);
  section->addWidget(note);
  column->addStretch(1);
  const auto show = [=, &settings] {
    const Units units = unitsFrom(settings);
    length->setCurrent(static_cast<int>(units.length));
    angle->setCurrent(static_cast<int>(units.angle));
    length_decimals->setValue(units.length_decimals);
    angle_decimals->setValue(units.angle_decimals);
    force_decimals->setValue(units.force_decimals);
    sample->setText(lengthText(0.1234567) + QStringLiteral("   ") + angleText(0.6) + QStringLiteral("   ") +
                    forceText(1.25));
  };
  const auto change = [=, &settings](auto&& edit) {
    Units units = unitsFrom(settings);
    edit(units);
    storeUnits(units, settings);
    show();
  };
  QObject::connect(length, &Segmented::chosen, page, [change](int i) {
    change([i](Units& u) { u.length = static_cast<Units::Length>(i), u.length_decimals = usualDecimals(u.length); });
  });
  QObject::connect(angle, &Segmented::chosen, page, [change](int i) {
    change([i](Units& u) { u.angle = static_cast<Units::Angle>(i), u.angle_decimals = i == 0 ? 1 : 3; });
  });
  QObject::connect(length_decimals, &QSpinBox::valueChanged, page,
                   [change](int n) { change([n](Units& u) { u.length_decimals = n; }); });
  QObject::connect(angle_decimals, &QSpinBox::valueChanged, page,
                   [change](int n) { change([n](Units& u) { u.angle_decimals = n; }); });
  QObject::connect(force_decimals, &QSpinBox::valueChanged, page,
                   [change](int n) { change([n](Units& u) { u.force_decimals = n; }); });
  show();
  return page;
}

}  // namespace hapticell::app
