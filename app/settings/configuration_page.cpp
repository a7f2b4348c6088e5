// SPDX-License-Identifier: Apache-2.0
#include "app/settings/configuration_page.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSaveFile>
#include <QStandardPaths>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/host/host.h"
#include "app/panels/form.h"
#include "app/settings/settings_pages.h"
#include "app/settings/toml_edit.h"
#include "app/style/theme.h"
#include "config/configuration.h"

namespace hapticell::app {
namespace {

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

/// Everything that stands in hapticell.toml; a double click changes it for the next start.
class ConfigurationPage : public QWidget {
 public:
  explicit ConfigurationPage(Host& host) : configuration_(host.configuration()) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    QVBoxLayout* section = addSection(*column, tr("Feel and files"));
    note_ = makeLive(4, TextRole::kSecond, true);
    note_->setText(
        tr("What stands in hapticell.toml, in SI units. A double click or F2 changes a value; it holds "
           "from the next start."));
    note_->setObjectName("labelConfiguration");
    section->addWidget(note_);
    filter_ = new QLineEdit;
    filter_->setObjectName("fieldConfigurationFilter");
    filter_->setProperty("search", true);
    filter_->setPlaceholderText(tr("Filter by name"));
    filter_->setClearButtonEnabled(true);
    section->addWidget(filter_);
    table_ = new QTableWidget(0, 3);
    table_->setObjectName("tableConfiguration");
    table_->setAccessibleName(tr("Configuration"));
    table_->setHorizontalHeaderLabels({tr("Setting"), tr("Value"), tr("From … to")});
    table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table_->verticalHeader()->hide();
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setShowGrid(false);
    table_->setMinimumHeight(260);
    table_->setColumnWidth(1, 110);
    table_->setColumnWidth(2, 140);
    column->addWidget(table_, 1);
    fill();
    connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
      for (int row = 0; row < table_->rowCount(); ++row)
        table_->setRowHidden(row, !table_->item(row, 0)->text().contains(text, Qt::CaseInsensitive));
    });
    connect(table_, &QTableWidget::itemChanged, this, &ConfigurationPage::take);
  }

 private:
  void fill() {
    for (const config::Setting& setting : config::settings(configuration_)) {
      const int row = table_->rowCount();
      table_->insertRow(row);
      const auto cell = [&](int column, const std::string& text, bool editable) {
        auto* item = new QTableWidgetItem(QString::fromStdString(text));
        if (!editable) item->setFlags(item->flags() & ~Qt::ItemIsEditable);
        table_->setItem(row, column, item);
      };
      cell(0, setting.key, false);
      cell(1, setting.value, true);
      cell(2, setting.range, false);
    }
  }

  void take(QTableWidgetItem* item) {
    if (item->column() != 1 || taking_) return;
    taking_ = true;
    const QString key = table_->item(item->row(), 0)->text();
    const auto written = writeSetting(userConfigurationFile(), key, item->text());
    if (written) {
      note_->setText(tr("%1 is %2 from the next start.").arg(key, item->text()));
      before_[item->row()] = item->text();
    } else {
      note_->setText(QString::fromStdString(written.error().message()));
      for (const config::Setting& setting : config::settings(configuration_))
        if (key.toStdString() == setting.key)
          item->setText(before_.value(item->row(), QString::fromStdString(setting.value)));
    }
    taking_ = false;
  }

  const config::Configuration& configuration_;
  QLabel* note_;
  QLineEdit* filter_;
  QTableWidget* table_;
  QHash<int, QString> before_;  // What was written, by row.
  bool taking_ = false;
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
      return makeError({file.toStdString(), "", old.errorString().toStdString(), "a file that can be read", ""});
    before = old.readAll();
  }
  const std::string after =
      withTomlValue(before.toStdString(), key.toStdString(), tomlText(text, shippedText(key)).toStdString());
  QDir().mkpath(QFileInfo(file).absolutePath());
  QSaveFile out(file);
  const bool done =
      out.open(QIODevice::WriteOnly) && out.write(after.data(), static_cast<qint64>(after.size())) >= 0 && out.commit();
  if (!done)
    return makeError({file.toStdString(), "", out.errorString().toStdString(), "a file that can be written",
                      "Look whether its folder is writable."});
  return {};
}

QWidget* makeConfigurationPage(Host& host) {
  return new ConfigurationPage(host);
}

}  // namespace hapticell::app
