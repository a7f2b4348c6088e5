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

/// The report's page as it will be written, as large as wanted, and its buttons: a posture's page or a task's, English
/// or French, with the company's name and logo, to PDF, HTML, CSV or JSON. While there is a recorded motion the task's
/// page is that of its worst phase.
class ReportPanel : public QWidget {
  Q_OBJECT
 public:
  ReportPanel(MannequinContext& context, const LiveScores& scores, const MotionScoresModel& motion,
              QWidget* parent = nullptr);
  /// By the ending; false and a message where it cannot be.
  bool write(const QString& path);
  ergonomics::Report report() const;
  /// What the last search for the workplace found; empty: none was made in this cell.
  void setWorkplace(std::optional<ergonomics::WorkplaceFinding> found);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  /// All present data of the page.
  ergonomics::PostureReportInput input() const;
  bool isOfTask() const;
  bool isOfPhase() const;
  QHBoxLayout* makeButtons();
  QHBoxLayout* makeChoices();
  /// How wide the page is to be drawn, pixels of the window.
  int pageWidth() const;
  void zoomBy(int steps);
  void draw();
  /// Once nothing has changed for a moment: a page that changes while a hand is drawn is not read, and costs frames.
  void drawLater();
  void chooseFile();
  /// Renders the picture of the figure in its cell again, smooth or quick.
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
  ergonomics::ReportPicture scene_;  ///< Of the posture that the page is about.
  std::optional<ergonomics::WorkplaceFinding> workplace_;
  std::optional<PictureRenderer> renderer_;
  QTimer wait_;
};

}  // namespace hapticell::app
