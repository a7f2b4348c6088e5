// SPDX-License-Identifier: Apache-2.0
#include "app/panels/collisions/collisions_panel.h"

#include <QAbstractButton>
#include <QFrame>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QResizeEvent>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/form.h"
#include "app/panels/collisions/pair_columns.h"
#include "app/panels/collisions/pair_delegate.h"
#include "app/panels/collisions/pair_set_editor.h"
#include "app/panels/collisions/rest_question.h"
#include "app/style/icon.h"
#include "app/style/segmented.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

// m about the nearest points of a pair that is zoomed to, at least. Our choice. Half: parts are not recognised; twice:
// the place is small.
constexpr double kZoomRoom = 0.06;

/// In a narrow dock the names of a pair are worth more than what its set says: columns go, the names stay.
class NamesFirst : public QObject {
 public:
  explicit NamesFirst(QTableView& table) : QObject(&table), table_(table) {}
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::Resize) return false;
    constexpr int kWithNearMiss = 700, kWithOnContact = 610, kWithBar = 500;  // Pixels.
    const int width = static_cast<QResizeEvent*>(event)->size().width();
    table_.setColumnHidden(PairTableModel::kNearMissWithin, width < kWithNearMiss);
    table_.setColumnHidden(PairTableModel::kOnContact, width < kWithOnContact);
    // The bar goes before the names do.
    const int bar = width < kWithBar ? 0 : PairDelegate::kBarRoom;
    table_.horizontalHeader()->resizeSection(PairTableModel::kDistance, PairDelegate::kDistanceRoom + bar);
    return false;
  }

 private:
  QTableView& table_;
};

}  // namespace

CollisionsPanel::CollisionsPanel(Host& host, QWidget* parent) : QWidget(parent), host_(host) {
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
  connect(&host_.documentModel(), &DocumentModel::closing, this, [this] {
    log_page_->clear();
    filter_->clear();
    show_->setCurrent(0);
    model_.setShow(PairTableModel::Show::kAll, {});
    question_->forget();
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
  log_page_ = new ContactLogPage(host_);
  stack_->addWidget(log_page_);
  column->addWidget(stack_, 1);
  connect(log_page_, &ContactLogPage::changed, this, [this] {
    const QString last = log_page_->lastLine();
    log_line_->setText(last.isEmpty() ? tr("No contact yet") : last);
  });
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
  pages_->setMaximumWidth(pages_->sizeHint().width() + 24);
  filter_ = new QLineEdit;
  filter_->setObjectName("filterPairs");
  filter_->setProperty("search", true);
  filter_->setPlaceholderText(tr("Filter by name"));
  filter_->setClearButtonEnabled(true);
  filter_->addAction(icon("search"), QLineEdit::LeadingPosition);
  filter_->setMinimumWidth(60);
  filter_->setMaximumWidth(220);
  show_ = new Segmented({tr("All 000"), tr("Contact 00"), tr("Near miss 00")});
  show_->setObjectName("segmentsShow");
  show_->setMaximumWidth(show_->sizeHint().width() + 24);
  show_->setCurrent(0);
  top->addWidget(pages_, 3);
  top->addStretch(1);
  top->addWidget(filter_, 2);
  top->addWidget(show_, 3);
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
  question_ = new RestQuestion(host_);
  column->addWidget(question_);
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

void CollisionsPanel::makeTable() {
  table_ = new QTableView;
  table_->setObjectName("tablePairs");
  table_->setAccessibleName(tr("Pairs"));
  setUpPairTable(*table_, model_);
  table_->setItemDelegate(new PairDelegate(table_));
  QHeaderView* header = table_->horizontalHeader();
  header->ensurePolished();  // Its font decides how wide a heading is.
  const int widths[PairTableModel::kColumns]{112, 160, 160, 168, 88, 88, 60};
  for (int i = 0; i < PairTableModel::kColumns; ++i)
    header->resizeSection(i, std::max(widths[i], header->sectionSizeHint(i)));
  header->setSectionResizeMode(PairTableModel::kMoved, QHeaderView::Stretch);
  header->setSectionResizeMode(PairTableModel::kAgainst, QHeaderView::Stretch);
  table_->viewport()->installEventFilter(new NamesFirst(*table_));
  connect(table_, &QTableView::clicked, this, &CollisionsPanel::clicked);
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) { zoomTo(model_.row(index.row())); });
  connect(table_, &QTableView::doubleClicked, this,
          [this](const QModelIndex& index) { host_.selection().set(model_.row(index.row()).other); });
}

void CollisionsPanel::showPairs() {
  pages_->setCurrent(0);
  stack_->setCurrentIndex(0);
  show_->setCurrent(0);
  filter_->clear();
  for (QWidget* one : {static_cast<QWidget*>(filter_), static_cast<QWidget*>(show_)}) one->show();
  model_.setShow(PairTableModel::Show::kAll, {});
  showSnapshot(host_.snapshot());
}

workcell::EntityId CollisionsPanel::movedEntity() const {
  if (host_.snapshot() && host_.snapshot()->stylus.held) return host_.snapshot()->stylus.held;
  return host_.selection().current();
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
  if (snapshot) log_page_->take(*snapshot);
  const workcell::EntityId moved = movedEntity();
  // Parts were moved while the question is open: what it names may no longer touch.
  if (!question_->isHidden() && rest_.isOutdated(host_.preparedScene())) {
    question_->setOutdated();
    rest_.askAgain();
  }
  if (!snapshot || snapshot->stylus.held == 0) rest_.watch(host_.preparedScene(), moved);
  rest_.takeResults();
  if (auto touching = rest_.takeTouching()) question_->ask(std::move(*touching));
  if (host_.documentModel().document().state().entities.empty())
    question_->ask({});  // Nothing is there to be asked about.
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
  empty_->setText(moved == 0 ? tr("Select or hold an entity to see what it is checked against.")
                             : tr("This entity is not checked against anything. Choose pair sets on the left."));
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
  if (index.column() == PairTableModel::kCheck && !row.one_body) return switchPair(row);
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
  const QString text = row.checked ? tr("Exclude %1 – %2") : tr("Include %1 – %2");
  host_.documentModel().execute(workcell::SetPairRules{{rule}, text.arg(row.moved_name, row.other_name).toStdString()});
}

void CollisionsPanel::chooseOnContact(const PairRow& row, const QPoint& place) {
  auto* menu = new QMenu(this);
  menu->setObjectName("menuOnContact");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (int choice = -1; choice < 3; ++choice) {
    const QString name = choice < 0 ? tr("As in the set") : onContactName(static_cast<workcell::OnContact>(choice));
    QAction* action = menu->addAction(name);
    action->setCheckable(true);
    action->setChecked(row.own_on_contact ? choice == static_cast<int>(row.on_contact) : choice < 0);
    connect(action, &QAction::triggered, this, [this, row, choice] {
      workcell::PairRule rule = ruleOf(row);
      rule.on_contact = choice < 0 ? std::nullopt : std::optional(static_cast<workcell::OnContact>(choice));
      host_.documentModel().execute(workcell::SetPairRules{
          {rule}, tr("Contact mode of %1 – %2").arg(row.moved_name, row.other_name).toStdString()});
    });
  }
  menu->popup(place);
}

}  // namespace hapticell::app
