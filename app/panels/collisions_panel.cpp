// SPDX-License-Identifier: Apache-2.0
#include "app/panels/collisions_panel.h"

#include <QAbstractButton>
#include <QFile>
#include <QFileDialog>
#include <QFrame>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSaveFile>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/panels/form.h"
#include "app/panels/pair_columns.h"
#include "app/panels/pair_delegate.h"
#include "app/panels/pair_set_editor.h"
#include "app/style/icon.h"
#include "app/style/segmented.h"
#include "app/viewport/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr int kTableRow = 28;
constexpr double kZoomRoom = 0.06;  // Metres about the nearest points of a pair that is zoomed to, at least.

void setUp(QTableView& table, QAbstractItemModel& model) {
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

}  // namespace

CollisionsPanel::CollisionsPanel(Host& host, QWidget* parent) : QWidget(parent), host_(host), log_model_(log_) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  sets_ = new PairSetEditor(host_);
  row->addWidget(sets_);
  auto* line = new QFrame;
  line->setFixedWidth(1);
  line->setBackgroundRole(QPalette::Mid);
  line->setAutoFillBackground(true);
  row->addWidget(line);
  row->addWidget(makeRight(), 1);
  connect(sets_, &PairSetEditor::chosen, columns_, &PairColumns::setSet);
  columns_->setSet(sets_->current());
  const auto refresh = [this] { showSnapshot(host_.snapshot()); };
  connect(&host_.documentModel(), &DocumentModel::changed, this, refresh);
  connect(&host_.documentModel(), &DocumentModel::opened, this, [this] {
    question_box_->hide();
    rest_.askAgain();
  });
  connect(&host_.selection(), &Selection::changed, this, refresh);
  showSnapshot({});
}

QWidget* CollisionsPanel::makeRight() {
  auto* holder = new QWidget;
  auto* column = new QVBoxLayout(holder);
  column->setContentsMargins(0, 8, 0, 0);
  column->setSpacing(6);
  addTop(*column);
  stack_ = new QStackedWidget;
  columns_ = new PairColumns(host_);
  stack_->addWidget(makePairs());
  stack_->addWidget(columns_);
  stack_->addWidget(makeLogPage());
  column->addWidget(stack_, 1);
  connect(pages_, &Segmented::chosen, this, [this](int page) {
    stack_->setCurrentIndex(page);
    filter_->setVisible(page == 0);
    show_->setVisible(page == 0);
  });
  return holder;
}

void CollisionsPanel::addTop(QBoxLayout& column) {
  auto* top = new QHBoxLayout;
  top->setContentsMargins(10, 0, 12, 0);
  pages_ = new Segmented({tr("Pairs"), tr("Columns"), tr("Log")});
  pages_->setObjectName("segmentsCollisions");
  pages_->setCurrent(0);
  pages_->setFixedWidth(pages_->sizeHint().width() + 24);
  filter_ = new QLineEdit;
  filter_->setObjectName("filterPairs");
  filter_->setPlaceholderText(tr("Filter by name"));
  filter_->setClearButtonEnabled(true);
  filter_->addAction(icon("search"), QLineEdit::LeadingPosition);
  filter_->setMinimumWidth(120);
  filter_->setMaximumWidth(220);
  show_ = new Segmented({tr("All 000"), tr("Contact 00"), tr("Near miss 00")});
  show_->setObjectName("segmentsShow");
  show_->setFixedWidth(show_->sizeHint().width() + 24);
  show_->setCurrent(0);
  top->addWidget(pages_);
  top->addStretch(1);
  top->addWidget(filter_, 2);
  top->addWidget(show_);
  column.addLayout(top);
  const auto choose = [this] {
    model_.setShow(static_cast<PairTableModel::Show>(std::max(0, show_->current())), filter_->text());
  };
  connect(filter_, &QLineEdit::textChanged, this, choose);
  connect(show_, &Segmented::chosen, this, choose);
}

QWidget* CollisionsPanel::makePairs() {
  auto* holder = new QWidget;
  auto* column = new QVBoxLayout(holder);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeQuestion());
  makeTable();
  column->addWidget(table_, 1);
  empty_ = makeLabel({}, TextRole::kText, true);
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  column->addWidget(empty_, 1);
  auto* foot = new QHBoxLayout;
  foot->setContentsMargins(12, 2, 12, 4);
  foot->addWidget(makeLabel(tr("Log"), TextRole::kSection, true));
  log_line_ = makeLabel(tr("No contact yet"), TextRole::kSecond, true);
  log_line_->setObjectName("labelLastEvent");
  log_line_->setMinimumWidth(40);
  log_line_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  foot->addSpacing(12);
  foot->addWidget(log_line_, 1);
  column->addLayout(foot);
  return holder;
}

QWidget* CollisionsPanel::makeQuestion() {
  question_box_ = new QFrame;
  question_box_->setObjectName("questionAtRest");
  question_box_->setBackgroundRole(QPalette::AlternateBase);
  question_box_->setAutoFillBackground(true);
  auto* row = new QHBoxLayout(question_box_);
  row->setContentsMargins(12, 6, 12, 6);
  auto* mark = new QLabel;
  mark->setPixmap(icon("info").pixmap(16, 16));
  question_text_ = makeLabel({}, TextRole::kText);
  question_text_->setWordWrap(true);
  auto* leave_out = new QPushButton(tr("Leave out"));
  leave_out->setObjectName("buttonLeaveOut");
  leave_out->setProperty("main", true);
  auto* keep = new QPushButton(tr("Keep checked"));
  keep->setObjectName("buttonKeepChecked");
  row->addWidget(mark);
  row->addWidget(question_text_, 1);
  row->addWidget(leave_out);
  row->addWidget(keep);
  question_box_->hide();
  connect(leave_out, &QPushButton::clicked, this, &CollisionsPanel::leaveOut);
  connect(keep, &QPushButton::clicked, question_box_, &QWidget::hide);
  return question_box_;
}

void CollisionsPanel::makeTable() {
  table_ = new QTableView;
  table_->setObjectName("tablePairs");
  table_->setAccessibleName(tr("Pairs"));
  setUp(*table_, model_);
  table_->setItemDelegate(new PairDelegate(table_));
  QHeaderView* header = table_->horizontalHeader();
  const int widths[PairTableModel::kColumns]{112, 160, 160, 168, 88, 88, 60};
  for (int i = 0; i < PairTableModel::kColumns; ++i) header->resizeSection(i, widths[i]);
  header->setSectionResizeMode(PairTableModel::kMoved, QHeaderView::Stretch);
  header->setSectionResizeMode(PairTableModel::kAgainst, QHeaderView::Stretch);
  connect(table_, &QTableView::clicked, this, &CollisionsPanel::clicked);
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) { zoomTo(model_.row(index.row())); });
  connect(table_, &QTableView::doubleClicked, this,
          [this](const QModelIndex& index) { host_.selection().set(model_.row(index.row()).other); });
}

QWidget* CollisionsPanel::makeLogPage() {
  auto* holder = new QWidget;
  auto* column = new QVBoxLayout(holder);
  column->setContentsMargins(0, 0, 0, 8);
  log_table_ = new QTableView;
  log_table_->setObjectName("tableLog");
  log_table_->setAccessibleName(tr("Log of contacts"));
  setUp(*log_table_, log_model_);
  QHeaderView* header = log_table_->horizontalHeader();
  const int widths[ContactLogModel::kColumns]{88, 132, 160, 160, 88, 72, 72};
  for (int i = 0; i < ContactLogModel::kColumns; ++i) header->resizeSection(i, widths[i]);
  header->setSectionResizeMode(ContactLogModel::kMoved, QHeaderView::Stretch);
  header->setSectionResizeMode(ContactLogModel::kAgainst, QHeaderView::Stretch);
  column->addWidget(log_table_, 1);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(12, 0, 12, 0);
  auto* clear = new QPushButton(tr("Clear"));
  clear->setObjectName("buttonClearLog");
  save_log_ = new QPushButton(tr("Save log…"));
  save_log_->setObjectName("buttonSaveLog");
  row->addStretch(1);
  row->addWidget(clear);
  row->addWidget(save_log_);
  column->addLayout(row);
  connect(clear, &QPushButton::clicked, this, [this] {
    log_.clear();
    log_model_.refresh();
    log_line_->setText(tr("No contact yet"));
  });
  connect(save_log_, &QPushButton::clicked, this, [this] {
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save log"), QStringLiteral("contacts.csv"), tr("Table (*.csv)"));
    if (!path.isEmpty()) saveLog(path);
  });
  return holder;
}

bool CollisionsPanel::saveLog(const QString& path) {
  QSaveFile file(path);
  const QByteArray text = QByteArray::fromStdString(log_.csv());
  if (file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit()) {
    host_.messages().tell(Severity::kInformation, tr("The log is saved"), path);
    return true;
  }
  host_.messages().tell(Severity::kProblem, tr("The log was not saved"),
                        tr("%1: %2. Choose another place.").arg(path, file.errorString()));
  return false;
}

workcell::EntityId CollisionsPanel::movedEntity() const {
  if (host_.snapshot() && host_.snapshot()->held) return host_.snapshot()->held;
  return host_.selection().current();
}

void CollisionsPanel::takeLog(const std::optional<manipulation::SceneSnapshot>& snapshot) {
  if (!snapshot) return;
  const std::size_t before = log_.count();
  log_.take(*snapshot, [this](workcell::EntityId entity, const std::string& part) {
    return host_.viewport().scene().nameOf(entity, part);
  });
  if (log_.count() == before) return;
  log_model_.refresh();
  QStringList last;
  for (auto event = log_.events().rbegin(); event != log_.events().rend() && last.size() < 3; ++event)
    last << eventLine(*event);
  log_line_->setText(last.join(QStringLiteral("     ")));
}

void CollisionsPanel::showRows(std::vector<PairRow> rows) {
  const QModelIndex current = table_->currentIndex();
  const std::optional<PairRow> chosen = current.isValid() ? std::optional(model_.row(current.row())) : std::nullopt;
  model_.setRows(std::move(rows));
  if (!chosen) return;
  // The selection stays on its pair while rows change places.
  const int row = model_.find(*chosen);
  if (row < 0)
    table_->clearSelection();
  else if (row != table_->currentIndex().row())
    table_->setCurrentIndex(model_.index(row, 0));
}

void CollisionsPanel::showSnapshot(const std::optional<manipulation::SceneSnapshot>& snapshot) {
  takeLog(snapshot);
  const workcell::EntityId moved = movedEntity();
  if (!snapshot || snapshot->held == 0) rest_.watch(host_.preparedScene(), moved);
  rest_.takeResults();
  if (auto touching = rest_.takeTouching()) ask(std::move(*touching));
  const auto& settings = host_.configuration().manipulation;
  const auto& rest = rest_.distances();
  const PairSources sources{snapshot ? &*snapshot : nullptr, rest.empty() ? nullptr : &rest};
  showRows(pairRows(host_.documentModel().document().state(), sources, moved,
                    {settings.safety_distance, settings.near_miss}));
  using Show = PairTableModel::Show;
  const auto name = [this](int button, const QString& text) { show_->button(button)->setText(text); };
  name(0, tr("All %1").arg(model_.count(Show::kAll)));
  name(1, tr("Contact %1").arg(model_.count(Show::kContact)));
  name(2, tr("Near miss %1").arg(model_.count(Show::kNearMiss)));
  empty_->setVisible(model_.rows().empty());
  table_->setVisible(!model_.rows().empty());
  empty_->setText(moved == 0 ? tr("Select or hold an entity: what it is checked against stands here.")
                             : tr("Nothing is checked against this entity. Choose sets at the left."));
  std::map<QString, int> by_set;
  for (const PairRow& row : model_.rows())
    if (row.checked && row.mark != Mark::kNone) ++by_set[row.set];
  sets_->setAlerts(by_set);
  const int alerts = model_.count(Show::kContact) + model_.count(Show::kNearMiss);
  if (alerts == alerts_) return;
  alerts_ = alerts;
  emit alertsChanged(alerts);
}

void CollisionsPanel::clicked(const QModelIndex& index) {
  const PairRow row = model_.row(index.row());
  if (index.column() == PairTableModel::kCheck) return switchPair(row);
  if (index.column() == PairTableModel::kOnContact && row.checked)
    return chooseOnContact(row, table_->viewport()->mapToGlobal(table_->visualRect(index).bottomLeft()));
  zoomTo(row);
}

void CollisionsPanel::zoomTo(const PairRow& row) {
  geometry::Bounds bounds;
  if (row.distance) {
    const double room = std::max(kZoomRoom, *row.distance);
    for (const dvec3& p : row.p_W) {
      bounds.add(p - dvec3(room));
      bounds.add(p + dvec3(room));
    }
  } else {
    bounds.add(host_.viewport().scene().boundsOf_W(row.other));
  }
  host_.viewport().fit(bounds);
}

workcell::PairRule CollisionsPanel::ruleOf(const PairRow& row) const {
  const workcell::DocumentState& state = host_.documentModel().document().state();
  workcell::PairRule rule{state.find(row.moved)->name, row.moved_part, state.find(row.other)->name, row.other_part};
  const auto& rules = state.pair_rules;
  const auto known =
      std::find_if(rules.begin(), rules.end(), [&](const auto& other) { return workcell::samePair(other, rule); });
  if (known != rules.end()) return *known;
  // It may be left out by a rule for all of the entity.
  const workcell::PairRule* wider =
      workcell::ruleFor(rules, {rule.first, rule.first_part}, {rule.second, rule.second_part});
  return wider ? *wider : rule;
}

void CollisionsPanel::switchPair(const PairRow& row) {
  workcell::PairRule rule = ruleOf(row);
  rule.checked = !row.checked;
  const QString text = row.checked ? tr("Leave out %1 – %2") : tr("Check %1 – %2 again");
  host_.documentModel().execute(workcell::SetPairRules{{rule}, text.arg(row.moved_name, row.other_name).toStdString()});
}

void CollisionsPanel::chooseOnContact(const PairRow& row, const QPoint& place) {
  auto* menu = new QMenu(this);
  menu->setObjectName("menuOnContact");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (int choice = -1; choice < 3; ++choice) {
    const QString name = choice < 0 ? tr("As the set") : onContactName(static_cast<workcell::OnContact>(choice));
    QAction* action = menu->addAction(name);
    action->setCheckable(true);
    action->setChecked(row.own_on_contact ? choice == static_cast<int>(row.on_contact) : choice < 0);
    connect(action, &QAction::triggered, this, [this, row, choice] {
      workcell::PairRule rule = ruleOf(row);
      rule.on_contact = choice < 0 ? std::nullopt : std::optional(static_cast<workcell::OnContact>(choice));
      host_.documentModel().execute(workcell::SetPairRules{
          {rule}, tr("On contact of %1 – %2").arg(row.moved_name, row.other_name).toStdString()});
    });
  }
  menu->popup(place);
}

void CollisionsPanel::ask(std::vector<workcell::PairRule> touching) {
  question_ = std::move(touching);
  question_box_->setVisible(!question_.empty());
  if (question_.empty()) return;
  QStringList names;
  for (const workcell::PairRule& rule : question_) {
    const auto side = [](const std::string& entity, const std::string& part) {
      return QString::fromStdString(part.empty() ? entity : entity + " · " + part);
    };
    names << side(rule.first, rule.first_part) + QStringLiteral(" – ") + side(rule.second, rule.second_part);
  }
  const int count = static_cast<int>(names.size());
  question_text_->setToolTip(names.join('\n'));
  QString list = QStringList(names.mid(0, 2)).join(QStringLiteral(", "));
  if (count > 2) list += tr(" and %1 more").arg(count - 2);
  question_text_->setText(
      count == 1 ? tr("One pair touches as the cell stands: %1. Leave it out of the check?").arg(list)
                 : tr("%1 pairs touch as the cell stands: %2. Leave them out of the check?").arg(count).arg(list));
}

void CollisionsPanel::leaveOut() {
  question_box_->hide();
  const int count = static_cast<int>(question_.size());
  const QString text =
      count == 1 ? tr("Leave out a pair that touches at rest") : tr("Leave out %1 pairs that touch at rest").arg(count);
  host_.documentModel().execute(workcell::SetPairRules{std::move(question_), text.toStdString()});
  question_.clear();
}

}  // namespace hapticell::app
