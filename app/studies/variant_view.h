// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <filesystem>
#include <memory>

#include "app/studies/variant_map.h"
#include "studies/runner/study.h"

namespace hapticell::app {

class Host;
class ResultTable;

/// The results in the scene: coloured cells, and the cell as it stands in the chosen variant. Makes a variant the
/// document's. GUI thread; a study is prepared in the background.
class VariantView : public QObject {
  Q_OBJECT
 public:
  VariantView(Host& host, ResultTable& table, QObject* parent = nullptr);
  ~VariantView() override;

  /// The study of the results, ready; null: it is read when it is first needed.
  void setStudy(std::shared_ptr<const studies::Study> study);
  /// Whether cells are drawn, and by which column of the table.
  void setMapShown(bool on);
  /// Nothing is drawn while the results are not in the window.
  void setDockShown(bool on);
  void setMapColumn(int column);
  const VariantMap& map() const { return map_; }

  /// Shows the cell in the chosen variant until the document changes or hide() is called. Reads the study first if it
  /// is not there, which takes seconds; changed() then comes again.
  void show();
  void hide();
  bool isShowing() const { return showing_; }
  bool isPreparing() const { return preparing_; }
  /// Whether the chosen variant can be shown in the open workcell, and why not: empty if it can.
  QString obstacle() const;
  /// Path of the study's cell if another workcell is open; empty: it is open, or not known.
  QString otherCell() const;
  /// Makes the chosen variant the document's, as one undo step, and checks in the background that it has the results of
  /// its row. False: refused, with a message.
  bool take();

 signals:
  void changed();
  /// A click on a cell of the map.
  void cellClicked(std::int64_t number);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void prepare();
  void showMap();
  void showEntities(const workcell::Document& variant);
  void endShowing();
  void check(const studies::ResultRow& row, const workcell::Document& taken);
  bool isOpen() const;
  std::filesystem::path cellFile() const;

  Host& host_;
  ResultTable& table_;
  std::shared_ptr<const studies::Study> study_;
  Error study_fault_;
  bool failed_ = false;  ///< study_fault_ says why the study of these results is not there.
  VariantMap map_;
  int column_ = -1;
  bool map_shown_ = true, dock_shown_ = false, showing_ = false, preparing_ = false, wanted_ = false, busy_ = false;
  int generation_ = 0;  ///< Of the results: what was read for earlier ones is dropped.
  QPointF pressed_;
};

}  // namespace hapticell::app
