// SPDX-License-Identifier: Apache-2.0
#include "app/studies/results_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/file_dialog.h"
#include "app/kit/form.h"
#include "app/studies/heat_legend.h"
#include "app/studies/parallel_chart.h"
#include "app/studies/result_table.h"
#include "app/studies/scatter_chart.h"
#include "app/studies/variant_view.h"
#include "app/style/segmented.h"
#include "geometry/system/atomic_file.h"
#include "studies/store/result_ranking.h"

namespace hapticell::app {

namespace {

enum Page { kTablePage, kScatterPage, kParallelPage };
constexpr int kRowHeight = 22;

QPushButton* makeResultsButton(const char* name, const QString& text) {
  auto* button = new QPushButton(text);
  button->setObjectName(QString::fromLatin1(name));
  return button;
}

QComboBox* makeColumnChoice(const char* name, const QString& what) {
  auto* choice = new QComboBox;
  choice->setObjectName(QString::fromLatin1(name));
  choice->setAccessibleName(what);
  choice->setToolTip(what);
  choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice->setMinimumContentsLength(9);
  return choice;
}

}  // namespace

ResultsPanel::ResultsPanel(Host& host, ResultTable& table, VariantView& view, QWidget* parent)
    : QWidget(parent), host_(host), table_(table), view_(view) {
  setObjectName("resultsPanel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 8, 10, 8);
  column->setSpacing(6);
  addBars(*column);
  addPages(*column);
  connect(&table_, &ResultTable::rowsChanged, this, [this] {
    fillColumns();
    refresh();
  });
  connect(&table_, &ResultTable::chosenChanged, this, [this] {
    followChosen();
    refresh();
  });
  connect(&view_, &VariantView::changed, this, &ResultsPanel::refresh);
  connect(&view_, &VariantView::cellClicked, this, &ResultsPanel::choose);
  refresh();
}

void ResultsPanel::addBars(QVBoxLayout& column) {
  auto* first = new QHBoxLayout;
  kind_ = new Segmented({tr("Table"), tr("Scatter"), tr("Parallel")});
  kind_->setObjectName("segmentsResults");
  kind_->setAccessibleName(tr("View of the results"));
  kind_->setCurrent(kTablePage);
  across_ = makeColumnChoice("choiceAcross", tr("Result on the horizontal axis"));
  up_ = makeColumnChoice("choiceUp", tr("Result on the vertical axis"));
  color_ = makeColumnChoice("choiceColor", tr("Result shown as colour in map and lines"));
  map_ = new QCheckBox(tr("Map"));
  map_->setObjectName("checkMap");
  map_->setToolTip(tr("Colour the places of the variants in the scene"));
  map_->setChecked(true);
  legend_ = new HeatLegend(view_);
  first->addWidget(kind_);
  first->addWidget(across_);
  first->addWidget(up_);
  first->addStretch(1);
  first->addWidget(map_);
  first->addWidget(color_);
  first->addWidget(legend_);
  column.addLayout(first);
  auto* second = new QHBoxLayout;
  says_ = makeLive(1, TextRole::kSecond);
  says_->setObjectName("labelResults");
  use_ = makeResultsButton("buttonUseVariant", tr("Use this variant"));
  use_->setProperty("main", true);
  hide_ = makeResultsButton("buttonHideVariant", tr("Show the cell"));
  hide_->setToolTip(tr("Show the cell as it is in the document again"));
  cell_ = makeResultsButton("buttonOpenStudyCell", tr("Open its cell"));
  QPushButton* open = makeResultsButton("buttonOpenResults", tr("Open…"));
  export_ = makeResultsButton("buttonExportStudyResults", tr("Export…"));
  second->addWidget(says_, 1);
  for (QPushButton* button : {use_, hide_, cell_, open, export_}) second->addWidget(button);
  column.addLayout(second);
  connect(kind_, &Segmented::chosen, this, [this](int page) {
    pages_->setCurrentIndex(page);
    refresh();
  });
  for (QComboBox* choice : {across_, up_, color_})
    connect(choice, &QComboBox::activated, this, &ResultsPanel::columnsChosen);
  connect(map_, &QCheckBox::toggled, &view_, [this](bool on) {
    view_.setMapShown(on);
    refresh();
  });
  connect(use_, &QPushButton::clicked, &view_, &VariantView::take);
  connect(hide_, &QPushButton::clicked, &view_, &VariantView::hide);
  connect(open, &QPushButton::clicked, this, &ResultsPanel::open);
  connect(export_, &QPushButton::clicked, this, &ResultsPanel::exportTable);
  connect(cell_, &QPushButton::clicked, this, [this] { host_.openCell(view_.otherCell(), this, [] {}); });
}

void ResultsPanel::addPages(QVBoxLayout& column) {
  sorted_ = new QSortFilterProxyModel(this);
  sorted_->setSourceModel(&table_);
  sorted_->setSortRole(ResultTable::kSortRole);
  rows_ = new QTableView;
  rows_->setObjectName("tableResults");
  rows_->setAccessibleName(tr("Variants"));
  rows_->setModel(sorted_);
  rows_->setSortingEnabled(true);
  rows_->sortByColumn(ResultTable::kNumber, Qt::AscendingOrder);
  rows_->setSelectionBehavior(QAbstractItemView::SelectRows);
  rows_->setSelectionMode(QAbstractItemView::SingleSelection);
  rows_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  rows_->setShowGrid(false);
  rows_->setTabKeyNavigation(false);
  rows_->verticalHeader()->hide();
  rows_->verticalHeader()->setDefaultSectionSize(kRowHeight);
  rows_->horizontalHeader()->setHighlightSections(false);
  scatter_ = new ScatterChart(table_);
  parallel_ = new ParallelChart(table_);
  pages_ = new QStackedWidget;
  for (QWidget* page : std::initializer_list<QWidget*>{rows_, scatter_, parallel_}) pages_->addWidget(page);
  column.addWidget(pages_, 1);
  const auto chosenIn = [this](const QModelIndex& index) {
    if (index.isValid()) choose(table_.rows()[static_cast<std::size_t>(sorted_->mapToSource(index).row())].number);
  };
  connect(rows_, &QTableView::clicked, this, chosenIn);
  connect(rows_, &QTableView::activated, this, chosenIn);
  connect(rows_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this, chosenIn](const QModelIndex& now) {
            if (rows_->hasFocus()) chosenIn(now);
          });
  connect(scatter_, &ScatterChart::chose, this, &ResultsPanel::choose);
  connect(parallel_, &ParallelChart::chose, this, &ResultsPanel::choose);
}

void ResultsPanel::choose(std::int64_t number) {
  table_.choose(number);
  view_.show();
}

void ResultsPanel::followChosen() {
  if (!table_.chosen()) return rows_->clearSelection();
  const QModelIndex there = sorted_->mapFromSource(table_.index(static_cast<int>(*table_.chosen()), 0));
  const QSignalBlocker quiet(rows_->selectionModel());
  rows_->selectionModel()->setCurrentIndex(there, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  rows_->scrollTo(there);
  rows_->viewport()->update();
}

/// The columns of numbers; at first what is wanted, else what differs.
void ResultsPanel::fillColumns() {
  const bool other = study_ != QString::fromStdString(table_.head().study);
  study_ = QString::fromStdString(table_.head().study);
  std::vector<int> columns = table_.numberColumns();
  std::vector<int> wanted;
  for (const auto& objective : table_.objectives()) wanted.push_back(table_.columnNamed(objective.value));
  for (const int column : columns)
    if (std::find(wanted.begin(), wanted.end(), column) == wanted.end()) wanted.push_back(column);
  std::erase(wanted, -1);
  const auto fill = [&](QComboBox* choice, std::size_t first) {
    const int before = other || choice->count() == 0 ? -1 : choice->currentData().toInt();
    const QSignalBlocker quiet(choice);
    choice->clear();
    for (int column = ResultTable::kObjective; column < table_.columnCount(); ++column)
      if (table_.isNumber(column)) choice->addItem(table_.columnName(column), column);
    const int now = before >= 0 || wanted.empty() ? before : wanted[std::min(first, wanted.size() - 1)];
    choice->setCurrentIndex(std::max(0, choice->findData(now)));
  };
  fill(across_, 0);
  fill(up_, 1);
  fill(color_, 0);
  columnsChosen();
  if (other) rows_->resizeColumnsToContents();
}

void ResultsPanel::columnsChosen() {
  const bool any = color_->count() > 0;
  scatter_->setColumns(any ? across_->currentData().toInt() : -1, any ? up_->currentData().toInt() : -1);
  parallel_->setColorColumn(any ? color_->currentData().toInt() : -1);
  view_.setMapColumn(any ? color_->currentData().toInt() : -1);
  legend_->update();
}

void ResultsPanel::open() {
  const QString start = QString::fromStdString(host_.documentModel().document().path().parent_path().string());
  const QString file = askToOpen(window(), tr("Open results of a study"), start, tr("Results of studies (*.hresults)"));
  if (!file.isEmpty()) openFile(file);
}

void ResultsPanel::openFile(const QString& file) {
  view_.setStudy(nullptr);
  const auto opened = table_.open(file);
  if (!opened) host_.messages().reportCause(Severity::kProblem, tr("The results could not be opened"), opened.error());
  view_.setStudy(nullptr);  // Of the new results; the map is drawn by them.
}

void ResultsPanel::exportTable() {
  const QFileInfo base(table_.file());
  const QString file = askToSave(window(), tr("Export the results"),
                                 base.absolutePath() + '/' + base.completeBaseName() + QStringLiteral(".csv"),
                                 tr("Tables (*.csv)"));
  if (file.isEmpty()) return;
  const auto store = studies::ResultStore::open(table_.file().toStdString(), false);
  const auto text = store ? studies::csvOf(*store) : Expected<std::string>(tl::unexpected<Error>(store.error()));
  const auto written = text ? writeFileAtomically(file.toStdString(), *text) : Expected<void>(tl::unexpected<Error>(text.error()));
  if (!written) host_.messages().reportCause(Severity::kProblem, tr("The results could not be exported"), written.error());
}

void ResultsPanel::refresh() {
  const bool any = !table_.isEmpty(), chosen = table_.chosen().has_value();
  across_->setVisible(pages_->currentIndex() == kScatterPage);
  up_->setVisible(pages_->currentIndex() == kScatterPage);
  export_->setEnabled(any);
  const QString obstacle = view_.obstacle();
  use_->setEnabled(chosen && obstacle.isEmpty() && !view_.isPreparing());
  hide_->setEnabled(view_.isShowing());
  cell_->setVisible(any && !view_.otherCell().isEmpty());
  legend_->update();
  if (!any) return says_->setText(tr("No results yet. Run a study, or open a results file."));
  QString text = tr("%1 of %2 variants, %3 feasible, %4 on the Pareto front.")
                     .arg(table_.rows().size())
                     .arg(table_.head().variants)
                     .arg(table_.feasible())
                     .arg(table_.front().size());
  if (view_.isPreparing()) {
    text = tr("Preparing the cell of the study…");
  } else if (chosen) {
    const auto& row = table_.rows()[*table_.chosen()];
    QStringList values;
    for (int column = ResultTable::kFirstValue;
         column < ResultTable::kFirstValue + static_cast<int>(row.values.size()); ++column)
      values << tr("%1 = %2").arg(table_.columnName(column), table_.word(*table_.chosen(), column));
    text = tr("Variant %1: %2").arg(row.number).arg(values.join(QStringLiteral(", ")));
    if (view_.isShowing()) text += tr(" (shown in the scene)");
    if (!row.note.empty()) text += QStringLiteral(". ") + QString::fromStdString(row.note);
  }
  if (!obstacle.isEmpty()) text += QLatin1Char(' ') + obstacle;
  says_->setText(text);
}

}  // namespace hapticell::app
