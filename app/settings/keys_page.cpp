// SPDX-License-Identifier: Apache-2.0
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/kit/form.h"
#include "app/settings/key_map.h"
#include "app/settings/settings_pages.h"

namespace hapticell::app {
namespace {

/// All actions with their keys; the chosen one's can be pressed again.
class KeysPage : public QWidget {
 public:
  explicit KeysPage(KeyMap& keys) : keys_(keys) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    addTop(*column);
    addTable(*column);
    addEditor(*column);
    connect(&keys_, &KeyMap::changed, this, &KeysPage::fill);
    fill();
  }

 private:
  void addTop(QVBoxLayout& column) {
    QVBoxLayout* section = addSection(column, tr("Keys"));
    auto* board = new QComboBox;
    board->setObjectName("comboKeyboard");
    for (const char* name : {"qwerty", "qwertz", "azerty"})
      board->addItem(QString::fromLatin1(name).toUpper(), QLatin1String(name));
    board->setCurrentIndex(board->findData(keys_.keyboard()));
    addRow(*section, tr("Keyboard"), board);
    connect(board, &QComboBox::activated, this,
            [this, board](int i) { keys_.setKeyboard(board->itemData(i).toString()); });
    auto* letters = new QCheckBox(tr("Use single keys without Ctrl"));
    letters->setMinimumHeight(26);
    letters->setObjectName("switchLetters");
    letters->setChecked(keys_.lettersOn());
    connect(letters, &QCheckBox::clicked, this, [this](bool on) { keys_.setLettersOn(on); });
    section->addWidget(letters);
    filter_ = new QLineEdit;
    filter_->setObjectName("fieldKeyFilter");
    filter_->setProperty("search", true);
    filter_->setPlaceholderText(tr("Filter by command or key"));
    filter_->setClearButtonEnabled(true);
    connect(filter_, &QLineEdit::textChanged, this, &KeysPage::fill);
    auto* row = new QHBoxLayout;
    row->addWidget(filter_, 1);
    auto* all = new QPushButton(tr("Reset all"));
    all->setObjectName("buttonKeysShipped");
    row->addWidget(all);
    connect(all, &QPushButton::clicked, this, [this] { keys_.resetAll(); });
    section->addLayout(row);
  }

  void addTable(QVBoxLayout& column) {
    table_ = new QTableWidget(0, 2);
    table_->setObjectName("tableKeys");
    table_->setAccessibleName(tr("Keys"));
    table_->setHorizontalHeaderLabels({tr("Command"), tr("Key")});
    table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    table_->verticalHeader()->hide();
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setShowGrid(false);
    table_->setMinimumHeight(150);
    column.addWidget(table_, 1);
    connect(table_, &QTableWidget::currentCellChanged, this, &KeysPage::showRow);
  }

  void addEditor(QVBoxLayout& column) {
    QVBoxLayout* section = addSection(column, {});
    edit_ = new QKeySequenceEdit;
    edit_->setObjectName("fieldKey");
    addRow(*section, tr("New key"), edit_);
    note_ = makeLive(2, TextRole::kSecond, true);
    note_->setObjectName("labelKey");
    section->addWidget(note_);
    auto* row = new QHBoxLayout;
    const auto add = [&](const QString& text, const char* name, auto&& slot) {
      auto* button = new QPushButton(text);
      button->setObjectName(QLatin1String(name));
      row->addWidget(button);
      connect(button, &QPushButton::clicked, this, slot);
      return button;
    };
    row->addStretch(1);
    add(tr("No key"), "buttonKeyNone", [this] { take(QKeySequence()); });
    add(tr("Reset"), "buttonKeyShipped", [this] {
      if (!chosen().isEmpty()) keys_.reset(chosen());
    });
    set_ = add(tr("Assign"), "buttonKeySet", [this] { take(edit_->keySequence()); });
    set_->setProperty("main", true);
    section->addLayout(row);
    connect(edit_, &QKeySequenceEdit::keySequenceChanged, this, &KeysPage::showUse);
  }

  QString chosen() const {
    const auto* item = table_->item(table_->currentRow(), 0);
    return item ? item->data(Qt::UserRole).toString() : QString();
  }

  void take(const QKeySequence& key) {
    if (!chosen().isEmpty()) keys_.set(chosen(), key.isEmpty() ? key : QKeySequence(key[0]));
  }

  void fill() {
    const QString before = chosen();
    std::vector<KeyMap::Row> rows = keys_.rows();
    std::sort(rows.begin(), rows.end(),
              [](const auto& a, const auto& b) { return QString::localeAwareCompare(a.text, b.text) < 0; });
    table_->setRowCount(0);
    for (const KeyMap::Row& row : rows) {
      const QString key = row.now.toString(QKeySequence::NativeText);
      const QString typed = filter_->text();
      if (!row.text.contains(typed, Qt::CaseInsensitive) && !key.contains(typed, Qt::CaseInsensitive)) continue;
      const int at = table_->rowCount();
      table_->insertRow(at);
      auto* does = new QTableWidgetItem(row.text);
      does->setData(Qt::UserRole, row.id);
      table_->setItem(at, 0, does);
      auto* shown = new QTableWidgetItem(key);
      if (row.now != KeyMap::movedTo(keys_.keyboard(), row.shipped)) shown->setText(key + tr("  (custom)"));
      table_->setItem(at, 1, shown);
      if (row.id == before) table_->setCurrentCell(at, 0);
    }
    showRow();
  }

  void showRow() {
    for (const KeyMap::Row& row : keys_.rows())
      if (row.id == chosen()) edit_->setKeySequence(row.now);
    showUse();
  }

  void showUse() {
    set_->setEnabled(!chosen().isEmpty());
    const QString use = keys_.useOf(edit_->keySequence(), chosen());
    if (chosen().isEmpty())
      note_->setText(tr("Select a row, then press its new key."));
    else if (use.isEmpty())
      note_->setText(tr("Esc, Space and B are reserved: forces off, clutch, stylus button."));
    else
      note_->setText(tr("\"%1\" uses this key and would lose it.").arg(use));
  }

  KeyMap& keys_;
  QLineEdit* filter_ = nullptr;
  QTableWidget* table_ = nullptr;
  QKeySequenceEdit* edit_ = nullptr;
  QLabel* note_ = nullptr;
  QPushButton* set_ = nullptr;
};

}  // namespace

QWidget* makeKeysPage(KeyMap& keys) {
  return new KeysPage(keys);
}

}  // namespace hapticell::app
