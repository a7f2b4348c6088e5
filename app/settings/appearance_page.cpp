// SPDX-License-Identifier: Apache-2.0
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

#include "app/host/host.h"
#include "app/host/user_settings.h"
#include "app/kit/form.h"
#include "app/settings/settings_pages.h"
#include "app/settings/user_choices.h"
#include "app/style/segmented.h"

namespace hapticell::app {

QWidget* makeAppearancePage(Host& host) {
  UserSettings& settings = host.userSettings();
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* section = addSection(*column, QObject::tr("Appearance"));
  auto* theme = new Segmented({QObject::tr("Dark"), QObject::tr("Light")});
  theme->setObjectName("segmentsTheme");
  const QString shipped = QString::fromStdString(host.configuration().gui.theme);
  theme->setCurrent(settings.value("theme", shipped).toString() == QLatin1String("light") ? 1 : 0);
  QObject::connect(theme, &Segmented::chosen, page,
                   [&settings](int index) { settings.setValue("theme", index == 1 ? "light" : "dark"); });
  addRow(*section, QObject::tr("Theme"), theme);
  auto* language = new QComboBox;
  language->setObjectName("comboLanguage");
  // Each in its own language: whoever looks for it reads that one.
  language->addItem(QStringLiteral("English"), "en");
  language->addItem(QStringLiteral("Français"), "fr");
  language->setCurrentIndex(language->findData(languageFrom(settings)));
  addRow(*section, QObject::tr("Language"), language);
  auto* note = makeLabel({}, TextRole::kSecond, true);
  note->setObjectName("labelLanguage");
  note->setWordWrap(true);
  note->setContentsMargins(kLabelColumn, 0, 0, 0);
  section->addWidget(note);
  note->hide();
  QObject::connect(language, &QComboBox::activated, page, [&settings, language, note](int index) {
    settings.setValue("language", language->itemData(index).toString());
    note->setText(language->itemData(index).toString() == QLatin1String("fr")
                      ? QStringLiteral("HaptiCell parlera français à son prochain démarrage.")
                      : QStringLiteral("HaptiCell will speak English from its next start."));
    note->show();
  });
  const auto addSwitch = [&](const QString& text, const char* name, const QString& key, bool otherwise) {
    auto* box = new QCheckBox(text);
    box->setMinimumHeight(26);
    box->setObjectName(QLatin1String(name));
    box->setChecked(settings.value(key, otherwise).toBool());
    QObject::connect(box, &QCheckBox::clicked, page, [&settings, key](bool on) { settings.setValue(key, on); });
    section->addWidget(box);
  };
  addSwitch(QObject::tr("Animate view changes"), "switchMotion", "motion", host.configuration().gui.motion);
  addSwitch(QObject::tr("Show parts in full colour"), "switchFullColors", "colors/full",
            host.configuration().gui.original_colors);
  addSwitch(QObject::tr("Show the start page at start-up"), "switchFirstPage", "start/page", true);
  column->addStretch(1);
  return page;
}

}  // namespace hapticell::app
