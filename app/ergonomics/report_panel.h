// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QHBoxLayout>
#include <QImage>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "app/viewport/drawing/picture_renderer.h"
#include "mannequin/ergonomics/report/posture_report.h"

class QComboBox;
class QLabel;
class QScrollArea;

namespace hapticell::app {

class LiveScores;
class MannequinContext;
class MotionScoresModel;
class ReportHead;
class Segmented;

/// The report's page as it will be written, at the chosen size, and its buttons: the page of a posture or of a task, in
/// English or French, with the company's name and logo, to PDF, HTML, CSV or JSON. If there is a recorded motion, the
/// task's page shows its worst phase.
class ReportPanel : public QWidget {
  Q_OBJECT
 public:
  ReportPanel(MannequinContext& context, const LiveScores& scores, const MotionScoresModel& motion,
              QWidget* parent = nullptr);
  /// Writes the format that the file's ending says; on failure returns false and shows a message.
  bool write(const QString& path);
  ergonomics::Report report() const;
  /// The result of the last workplace search; empty: none was made in this cell.
  void setWorkplace(std::optional<ergonomics::WorkplaceFinding> found);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  /// All data that the page shows at present.
  ergonomics::PostureReportInput input() const;
  bool isOfTask() const;
  bool isOfPhase() const;
  QHBoxLayout* makeButtons();
  QHBoxLayout* makeChoices();
  /// The width at which to draw the page, in pixels of the window.
  int pageWidth() const;
  void zoomBy(int steps);
  void draw();
  /// Draws after a moment without changes: a page that changes during a drag cannot be read, and costs frames.
  void drawLater();
  void chooseFile();
  /// Renders the picture of the mannequin in its cell again; `samples`: smooth or quick.
  void takeScene(int samples);
  MannequinContext& context_;
  const LiveScores& scores_;
  const MotionScoresModel& motion_;
  Segmented* kind_;
  QComboBox *language_, *zoom_;
  ReportHead* head_;
  QScrollArea* scroll_;
  QLabel *page_, *which_;
  int shown_page_ = 1, pages_ = 1;
  bool drawing_ = false, again_ = false;
  ergonomics::ReportPicture scene_;  ///< Of the posture that the page shows.
  std::optional<ergonomics::WorkplaceFinding> workplace_;
  std::optional<PictureRenderer> renderer_;
  QTimer wait_;
};

}  // namespace hapticell::app
