// SPDX-License-Identifier: Apache-2.0
#include "app/panels/collisions/contact_log_page.h"

#include <QHeaderView>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/file_dialog.h"
#include "app/viewport/widget/viewport_widget.h"
#include "geometry/system/atomic_file.h"

namespace hapticell::app {

namespace {

constexpr int kTableRow = 28;
constexpr int kLastShown = 3;

}  // namespace

void setUpPairTable(QTableView& table, QAbstractItemModel& model) {
  table.setModel(&model);
  table.setFrameShape(QFrame::NoFrame);
  table.setShowGrid(false);
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.viewport()->setBackgroundRole(QPalette::Window);
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(kTableRow);
  table.horizontalHeader()->setHighlightSections(false);
  table.horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
}

ContactLogPage::ContactLogPage(Host& host, QWidget* parent) : QWidget(parent), host_(host), model_(log_) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 8);
  auto* table = new QTableView;
  table->setObjectName("tableLog");
  table->setAccessibleName(tr("Contact log"));
  setUpPairTable(*table, model_);
  QHeaderView* header = table->horizontalHeader();
  header->ensurePolished();  // Its font decides how wide a heading is.
  const int widths[ContactLogModel::kColumns]{88, 132, 160, 160, 88, 72, 72};
  for (int i = 0; i < ContactLogModel::kColumns; ++i)
    header->resizeSection(i, std::max(widths[i], header->sectionSizeHint(i)));
  header->setSectionResizeMode(ContactLogModel::kMoved, QHeaderView::Stretch);
  header->setSectionResizeMode(ContactLogModel::kAgainst, QHeaderView::Stretch);
  column->addWidget(table, 1);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(12, 0, 12, 0);
  auto* clear = new QPushButton(tr("Clear"));
  clear->setObjectName("buttonClearLog");
  auto* save_log = new QPushButton(tr("Save log…"));
  save_log->setObjectName("buttonSaveLog");
  row->addStretch(1);
  row->addWidget(clear);
  row->addWidget(save_log);
  column->addLayout(row);
  connect(clear, &QPushButton::clicked, this, &ContactLogPage::clear);
  connect(save_log, &QPushButton::clicked, this, [this] {
    const QString path = askToSave(this, tr("Save log"), QStringLiteral("contacts.csv"), tr("Table (*.csv)"));
    if (!path.isEmpty()) save(path);
  });
}

void ContactLogPage::clear() {
  log_.clear();
  model_.refresh();
  emit changed();
}

void ContactLogPage::take(const manipulation::SceneSnapshot& snapshot) {
  const std::size_t before = log_.count();
  log_.take(snapshot, [this](workcell::EntityId entity, const std::string& part) {
    return host_.viewport().scene().nameOf(entity, part);
  });
  if (log_.count() == before) return;
  model_.refresh();
  emit changed();
}

bool ContactLogPage::save(const QString& path) {
  const auto written = writeFileAtomically(path.toStdString(), log_.csv());
  if (written) {
    host_.messages().tell(Severity::kInformation, tr("The log is saved"), path);
    return true;
  }
  host_.messages().reportCause(Severity::kProblem, tr("The log was not saved"), written.error());
  return false;
}

QString ContactLogPage::lastLine() const {
  QStringList last;
  for (auto event = log_.events().rbegin(); event != log_.events().rend() && last.size() < kLastShown; ++event) {
    last << eventLine(*event);
  }
  return last.join(QStringLiteral("     "));
}

}  // namespace hapticell::app
