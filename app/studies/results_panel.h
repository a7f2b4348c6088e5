// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QPushButton;
class QSortFilterProxyModel;
class QStackedWidget;
class QTableView;
class QVBoxLayout;

namespace hapticell::app {

class Host;
class LiveLabel;
class ParallelChart;
class ResultTable;
class ScatterChart;
class Segmented;
class VariantView;

/// Results of a study as a table, a scatter chart and parallel coordinates. A click on a variant shows the cell so; a
/// button makes it the document's.
class ResultsPanel : public QWidget {
  Q_OBJECT
 public:
  ResultsPanel(Host& host, ResultTable& table, VariantView& view, QWidget* parent = nullptr);
  /// Asks for a results file.
  void open();
  void openFile(const QString& file);

 private:
  void addBars(QVBoxLayout& column);
  void addPages(QVBoxLayout& column);
  void choose(std::int64_t number);
  void fillColumns();
  void columnsChosen();
  void followChosen();
  void refresh();
  void exportTable();

  Host& host_;
  ResultTable& table_;
  VariantView& view_;
  QSortFilterProxyModel* sorted_;
  Segmented* kind_;
  QStackedWidget* pages_;
  QTableView* rows_;
  ScatterChart* scatter_;
  ParallelChart* parallel_;
  QComboBox *across_, *up_, *color_;
  QCheckBox* map_;
  QWidget* legend_;
  LiveLabel* says_;
  QPushButton *use_, *hide_, *cell_, *export_;
  QString study_;  ///< Text of the study whose columns are listed.
};

}  // namespace hapticell::app
