// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>
#include <atomic>
#include <memory>
#include <optional>

#include "studies/workplace/workplace_search.h"
#include "mannequin/ergonomics/report/posture_report.h"

class QCheckBox;
class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;

namespace hapticell::app {

class LiveScores;
class MannequinContext;
class ValueField;
class WorkplaceView;

/// Finds the placement of a table (and what is on it) at which the worst score of four bodies is lowest. Only the
/// ticked parts move, with what is attached to them. Options: how far, standing or sitting. Shows a map of the result,
/// and a button that moves the parts there as one undo step.
class WorkplacePanel : public QWidget {
  Q_OBJECT
 public:
  WorkplacePanel(MannequinContext& context, const LiveScores& scores, QWidget* parent = nullptr);
  ~WorkplacePanel() override;
  bool isBusy() const { return busy_; }
  const std::optional<studies::WorkplaceMap>& map() const { return map_; }
  /// What was searched and found, for the report: the placement that is chosen in the map. Empty: no search was made.
  std::optional<ergonomics::WorkplaceFinding> finding() const;

 signals:
  void findingChanged();

 private:
  void fillStation();
  void search();
  void showMap();
  void take();
  void saveStudy();
  /// Measures the cell as it now is against what the search promised for this placement, and says where it falls short.
  void checkTaken(const studies::WorkplaceCell& place);
  void showMoves();
  /// The cell with the ticked parts.
  studies::WorkplaceQuestion questionOfStation() const;
  /// With the task and the ranges of the fields.
  studies::WorkplaceQuestion questionOfFields() const;
  std::vector<workcell::EntityId> station() const;
  MannequinContext& context_;
  const LiveScores& scores_;
  QListWidget* station_;
  ValueField *rise_, *away_, *step_;
  QCheckBox* sit_;
  QPushButton *search_, *cancel_, *take_, *save_;
  QProgressBar* bar_;
  QLabel *result_, *moves_;
  WorkplaceView* view_;
  std::optional<studies::WorkplaceMap> map_;
  /// What was searched for: the request whose answer is map_.
  struct Asked {
    std::shared_ptr<const studies::WorkplaceQuestion> question;
    dvec3 ahead_W{1.0, 0.0, 0.0};
    std::vector<workcell::EntityId> station;
    std::vector<std::string> moved;  ///< Names of everything that the search moved.
  } asked_;
  struct Run {
    std::atomic<bool> cancel{false};
    std::atomic<double> progress{0.0};
  };
  std::shared_ptr<Run> run_;
  QTimer poll_;
  bool busy_ = false;
};

/// The placements as coloured squares: height upwards, distance to the right; the chosen one is framed.
class WorkplaceView : public QWidget {
  Q_OBJECT
 public:
  explicit WorkplaceView(QWidget* parent = nullptr);
  void setMap(const studies::WorkplaceMap* map);
  int chosen() const { return chosen_; }
  QSize sizeHint() const override { return {308, 240}; }
  QSize minimumSizeHint() const override { return {240, 220}; }

 signals:
  void chose(int cell);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  QRectF rectOf(std::size_t cell) const;
  const studies::WorkplaceMap* map_ = nullptr;
  int chosen_ = -1;
};

}  // namespace hapticell::app
