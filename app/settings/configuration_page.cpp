// SPDX-License-Identifier: Apache-2.0
#include "app/settings/configuration_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <cmath>

#include "app/host/host.h"
#include "app/kit/form.h"
#include "app/kit/system_open.h"
#include "app/settings/configuration_fields.h"
#include "app/settings/settings_pages.h"
#include "app/settings/toml_edit.h"
#include "app/style/library_text.h"
#include "app/style/value_field.h"
#include "config/configuration.h"
#include "config/setting_visitor.h"
#include "geometry/system/atomic_file.h"

namespace hapticell::app {
namespace {

constexpr int kNameColumn = 236;  // Of names that are short sentences.

/// As TOML writes it: numbers and true/false as they are, all else in quotes.
QString tomlText(const QString& typed, const QString& shipped) {
  const bool quoted = shipped.startsWith(QLatin1Char('"'));
  QString text = typed.trimmed();
  if (!quoted) return text;
  if (text.startsWith(QLatin1Char('"')) && text.endsWith(QLatin1Char('"')) && text.size() > 1)
    text = text.mid(1, text.size() - 2);
  return QLatin1Char('"') +
         text.replace(QLatin1Char('\\'), QLatin1String("\\\\")).replace(QLatin1Char('"'), QLatin1String("\\\"")) +
         QLatin1Char('"');
}

QString shippedText(const QString& key) {
  for (const config::Setting& setting : config::settings({}))
    if (setting.key == key.toStdString()) return QString::fromStdString(setting.value);
  return {};
}

/// The field of one setting, with its range, filled with the value in force.
struct FieldMaker {
  const ConfigurationField& field;
  QWidget* made = nullptr;

  void operator()(const std::string& key, const bool& value, const config::NumberRange&) {
    if (key != field.key) return;
    auto* box = new QCheckBox;
    box->setChecked(value);
    made = box;
  }
  template <typename Number>
  void operator()(const std::string& key, const Number& value, const config::NumberRange& range) {
    if (key != field.key) return;
    const double least = range.min * field.per_si, most = range.max * field.per_si;
    auto* number = new ValueField({field.unit, field.decimals, least, most, std::pow(10.0, -field.decimals)});
    number->setValue(static_cast<double>(value) * field.per_si);
    number->setToolTip(QObject::tr("From %1 to %2 %3").arg(least).arg(most).arg(field.unit).trimmed());
    made = number;
  }
  void operator()(const std::string& key, const std::string& value, const config::Choices& choices) {
    if (key != field.key) return;
    if (choices.empty()) {
      made = new QLineEdit(QString::fromStdString(value));
      return;
    }
    auto* combo = new QComboBox;
    for (const std::string& choice : choices) {
      const QString plain = QString::fromStdString(choice);
      combo->addItem(choiceWords(plain), plain);
    }
    combo->setCurrentIndex(combo->findData(QString::fromStdString(value)));
    made = combo;
  }
};

/// The settings of hapticell.toml as fields; what is changed is written at once, for the next start.
class ConfigurationPage : public QWidget {
 public:
  explicit ConfigurationPage(Host& host) : host_(host) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    QVBoxLayout* section = addSection(*column, tr("Feel and files"));
    note_ = makeLive(2, TextRole::kSecond, true);
    note_->setText(tr("Changes on this page take effect at the next start."));
    note_->setObjectName("labelSettingsNote");
    section->addWidget(note_);
    filter_ = new QLineEdit;
    filter_->setObjectName("fieldConfigurationFilter");
    filter_->setProperty("search", true);
    filter_->setPlaceholderText(tr("Filter by name"));
    filter_->setClearButtonEnabled(true);
    section->addWidget(filter_);
    for (const ConfigurationGroup& group : configurationGroups(host.configuration())) addGroup(*column, group);
    addFile(*column);
    column->addStretch(1);
    connect(filter_, &QLineEdit::textChanged, this, &ConfigurationPage::filter);
  }

 private:
  struct Row {
    QWidget* group;
    QWidget* row;
    QString words;
  };

  void addGroup(QVBoxLayout& column, const ConfigurationGroup& group) {
    auto* holder = new QWidget;
    auto* inside = new QVBoxLayout(holder);
    inside->setContentsMargins(0, 0, 0, 0);
    inside->setSpacing(0);
    QVBoxLayout* section = addSection(*inside, group.title);
    for (const ConfigurationField& field : group.fields) {
      FieldMaker maker{field};
      config::visitSettings(host_.configuration(), maker);
      if (!maker.made) continue;
      maker.made->setObjectName("setting." + QString::fromStdString(field.key));
      connectField(*maker.made, field);
      QWidget* row = addRow(*section, field.name, maker.made, kNameColumn);
      row->findChild<QLabel*>()->setWordWrap(true);
      rows_.push_back({holder, row, group.title + ' ' + field.name});
    }
    column.addWidget(holder);
  }

  void connectField(QWidget& made, const ConfigurationField& field) {
    if (auto* number = qobject_cast<ValueField*>(&made))
      connect(number, &ValueField::edited, this,
              [this, field](double value) { write(field, QString::number(value / field.per_si, 'g', 12)); });
    if (auto* box = qobject_cast<QCheckBox*>(&made))
      connect(box, &QCheckBox::clicked, this, [this, field](bool on) { write(field, on ? "true" : "false"); });
    if (auto* combo = qobject_cast<QComboBox*>(&made))
      connect(combo, &QComboBox::activated, this,
              [this, field, combo](int index) { write(field, combo->itemData(index).toString()); });
    if (auto* line = qobject_cast<QLineEdit*>(&made))
      connect(line, &QLineEdit::editingFinished, this, [this, field, line] {
        if (line->isModified()) write(field, line->text());
        line->setModified(false);
      });
  }

  void write(const ConfigurationField& field, const QString& text) {
    const auto written = writeSetting(userConfigurationFile(), QString::fromStdString(field.key), text);
    note_->setText(written ? tr("%1: changed, takes effect at the next start.").arg(field.name)
                           : shownText(written.error()));
  }

  void filter(const QString& typed) {
    QHash<QWidget*, bool> any;
    for (const Row& row : rows_) {
      const bool shown = row.words.contains(typed.trimmed(), Qt::CaseInsensitive);
      row.row->setVisible(shown);
      any[row.group] = any.value(row.group) || shown;
    }
    for (auto group = any.begin(); group != any.end(); ++group) group.key()->setVisible(group.value());
  }

  void addFile(QVBoxLayout& column) {
    QVBoxLayout* section = addSection(column, tr("File"));
    QLabel* words = makeLabel(tr("These settings are stored in %1. You can add materials and driver keys there.")
                                  .arg(QDir::toNativeSeparators(userConfigurationFile())),
                              TextRole::kSecond, true);
    words->setWordWrap(true);
    section->addWidget(words);
    auto* open = new QPushButton(tr("Open the file"));
    open->setObjectName("buttonOpenConfiguration");
    section->addWidget(open, 0, Qt::AlignLeft);
    connect(open, &QPushButton::clicked, this, &ConfigurationPage::openFile);
  }

  void openFile() {
    const QString path = userConfigurationFile();
    QDir().mkpath(QFileInfo(path).absolutePath());
    const bool there =
        QFileInfo::exists(path) ||
        writeFileAtomically(path.toStdString(),
                            "# HaptiCell, in SI units. The hapticell.toml that is shipped lists all keys.\n");
    if (!there || !openWithSystem(path))
      note_->setText(tr("No program on this computer opened %1. Open it in a text editor.").arg(path));
  }

  Host& host_;
  QLabel* note_;
  QLineEdit* filter_;
  std::vector<Row> rows_;
};

}  // namespace

QString userConfigurationFile() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
         QStringLiteral("/hapticell/hapticell.toml");
}

Expected<void> writeSetting(const QString& file, const QString& key, const QString& text) {
  config::Configuration trial;
  QString plain = text.trimmed();
  if (plain.size() > 1 && plain.startsWith(QLatin1Char('"')) && plain.endsWith(QLatin1Char('"')))
    plain = plain.mid(1, plain.size() - 2);
  if (auto valid = config::setValue(trial, key.toStdString(), plain.toStdString()); !valid) return valid;
  QFile old(file);
  QByteArray before;
  if (old.exists()) {
    if (!old.open(QIODevice::ReadOnly))
      return makeError({.file = file.toStdString(),
                        .found = old.errorString().toStdString(),
                        .expected = "a file that can be read"});
    before = old.readAll();
  }
  const std::string after =
      withTomlValue(before.toStdString(), key.toStdString(), tomlText(text, shippedText(key)).toStdString());
  QDir().mkpath(QFileInfo(file).absolutePath());
  return writeFileAtomically(file.toStdString(), after);
}

QWidget* makeConfigurationPage(Host& host) {
  return new ConfigurationPage(host);
}

}  // namespace hapticell::app
