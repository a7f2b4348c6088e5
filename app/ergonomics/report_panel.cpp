// SPDX-License-Identifier: Apache-2.0
#include "app/ergonomics/report_panel.h"

#include <QComboBox>
#include <QDate>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>

#include "app/ergonomics/live_scores.h"
#include "app/ergonomics/motion_scores_model.h"
#include "app/ergonomics/report_head.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/file_dialog.h"
#include "app/kit/form.h"
#include "app/kit/thread_pool_task.h"
#include "app/mannequin/mannequin_context.h"
#include "app/mannequin/mannequin_edits.h"
#include "app/style/icon.h"
#include "app/style/segmented.h"
#include "app/viewport/widget/viewport_widget.h"
#include "mannequin/shape/figure_model.h"

namespace hapticell::app {
namespace {

// ms after the last change until the page is drawn: a typist's pause. Half: drawn between letters; twice: it seems to
// hang.
constexpr int kDrawMilliseconds = 300;
// Samples a pixel of the cell's picture: on the screen, and where it is written. Half of 8: edges are seen in print;
// twice: twice the time.
constexpr int kQuickSamples = 1, kFineSamples = 8;
constexpr QSize kSceneSize(600, 690);
constexpr double kWidthAtFull = 794.0;  // Pixels of A4's 210 mm on a screen of 96 dots an inch.
/// m of the cell about the figure in the picture. Half: a workpiece is cut off; twice: the figure is small.
constexpr double kAround = 0.35;

}  // namespace

ReportPanel::ReportPanel(MannequinContext& context, const LiveScores& scores, const MotionScoresModel& motion,
                         QWidget* parent)
    : QWidget(parent), context_(context), scores_(scores), motion_(motion) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 10);
  column->setSpacing(8);
  head_ = new ReportHead(context.host());
  column->addLayout(makeButtons());
  column->addWidget(head_);
  column->addLayout(makeChoices());
  page_ = new QLabel;
  page_->setObjectName("labelReportPage");
  page_->setAlignment(Qt::AlignTop | Qt::AlignHCenter);
  page_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // The dock may be narrower than the last page.
  scroll_ = new QScrollArea;
  scroll_->setObjectName("scrollReport");
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setWidgetResizable(true);
  scroll_->setWidget(page_);
  scroll_->setMinimumHeight(300);
  scroll_->viewport()->installEventFilter(this);
  column->addWidget(scroll_, 1);
  wait_.setSingleShot(true);
  wait_.setInterval(kDrawMilliseconds);
  connect(&wait_, &QTimer::timeout, this, &ReportPanel::draw);
  connect(head_, &ReportHead::changed, this, &ReportPanel::drawLater);
  connect(&context_.host().documentModel(), &DocumentModel::closing, this, [this] {
    scene_ = {};
    shown_page_ = 1;
    kind_->setCurrent(0);
    drawLater();
  });
  connect(&scores_, &LiveScores::changed, this, &ReportPanel::drawLater);
  const auto takeAndDraw = [this] {
    if (isSeen(*this)) takeScene(kQuickSamples);
    drawLater();
  };
  // Told once the figure rests: then the scene is worth a picture.
  connect(&scores_, &LiveScores::adviceChanged, this, takeAndDraw);
  connect(&motion_, &MotionScoresModel::changed, this, takeAndDraw);
}

QHBoxLayout* ReportPanel::makeButtons() {
  auto* line = new QHBoxLayout;
  auto* save = new QPushButton(icon("save"), tr("PDF, HTML, CSV…"));
  save->setObjectName("buttonWriteReport");
  save->setProperty("main", true);
  language_ = new QComboBox;
  language_->setObjectName("comboReportLanguage");
  language_->addItems({tr("English"), tr("French")});  // As ergonomics::Language counts them.
  language_->setAccessibleName(tr("Language of the report"));
  language_->setMinimumWidth(language_->sizeHint().width() + 12);  // Fields stand closer than the style says.
  language_->setCurrentIndex(static_cast<int>(shownLanguage()));
  zoom_ = new QComboBox;
  zoom_->setObjectName("comboReportZoom");
  zoom_->setAccessibleName(tr("Page size"));
  zoom_->setToolTip(tr("Page size. You can also use Ctrl and the wheel."));
  zoom_->addItem(tr("Width"), 0.0);
  for (const int percent : {75, 100, 150, 200, 300}) zoom_->addItem(tr("%1 %").arg(percent), percent / 100.0);
  zoom_->setMinimumWidth(zoom_->sizeHint().width() + 12);
  line->addWidget(save);
  line->addStretch(1);
  line->addWidget(zoom_);
  line->addWidget(language_);
  connect(save, &QPushButton::clicked, this, &ReportPanel::chooseFile);
  connect(language_, &QComboBox::activated, this, &ReportPanel::drawLater);
  connect(zoom_, &QComboBox::currentIndexChanged, this, [this] { draw(); });
  return line;
}

QHBoxLayout* ReportPanel::makeChoices() {
  auto* line = new QHBoxLayout;
  kind_ = new Segmented({tr("Posture"), tr("Task")});
  kind_->setObjectName("segmentsReport");
  kind_->setCurrent(0);
  which_ = makeLabel({}, TextRole::kSecond, true);
  auto* next = new QPushButton(tr("Next page"));
  next->setObjectName("buttonNextPage");
  line->addWidget(kind_);
  line->addStretch(1);
  line->addWidget(which_);
  line->addWidget(next);
  connect(kind_, &Segmented::chosen, this, [this] {
    shown_page_ = 1;
    takeScene(kQuickSamples);
    draw();
  });
  connect(next, &QPushButton::clicked, this, [this] {
    shown_page_ = shown_page_ % pages_ + 1;
    draw();
  });
  return line;
}

int ReportPanel::pageWidth() const {
  const double zoom = zoom_->currentData().toDouble();
  return zoom > 0.0 ? static_cast<int>(zoom * kWidthAtFull) : std::max(200, scroll_->viewport()->width() - 4);
}

void ReportPanel::zoomBy(int steps) {
  if (zoom_->currentIndex() == 0 && steps > 0) {
    // From the width of the dock to the next larger one.
    int next = 1;
    while (next + 1 < zoom_->count() && kWidthAtFull * zoom_->itemData(next).toDouble() <= pageWidth()) ++next;
    return zoom_->setCurrentIndex(next);
  }
  zoom_->setCurrentIndex(std::clamp(zoom_->currentIndex() + steps, 0, zoom_->count() - 1));
}

bool ReportPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Wheel) {
    const auto* wheel = static_cast<const QWheelEvent*>(event);
    if (wheel->modifiers() & Qt::ControlModifier && wheel->angleDelta().y() != 0) {
      zoomBy(wheel->angleDelta().y() > 0 ? 1 : -1);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

ergonomics::PostureReportInput ReportPanel::input() const {
  ergonomics::PostureReportInput input;
  const workcell::Entity* entity = context_.entity();
  if (scores_.isEmpty() || !entity) return input;
  input.language = static_cast<ergonomics::Language>(std::max(0, language_->currentIndex()));
  const std::string code(ergonomics::codeOf(input.language));
  const QLocale locale(QString::fromStdString(code));
  input.subtitle = (context_.host().documentModel().title() + ", " + shown(entity->name)).toStdString();
  input.date = locale.toString(QDate::currentDate(), "d MMM yyyy").toStdString();
  input.figure = *scores_.figure();
  input.posture = scores_.posture();
  input.task = scores_.task();
  input.bodies = scores_.bodies();
  if (scores_.advice()) input.places = scores_.advice()->better;
  input.own_limits = scores_.ownLimits();
  input.scene = scene_;
  input.workplace = workplace_;
  input.history = motion_.strips();
  input.history_seconds = motion_.seconds();
  input.phase = motion_.phase();
  input.company = head_->company();
  input.logo = head_->logo();
  if (isOfPhase()) {
    input.is_of_phase = true;
    input.posture = motion_.posture(motion_.worstFrame());
    input.bodies = motion_.bodiesAtPhase();
    input.places = motion_.placesAtPhase();
  }
  return input;
}

bool ReportPanel::isOfPhase() const {
  return isOfTask() && !motion_.isEmpty();
}

void ReportPanel::setWorkplace(std::optional<ergonomics::WorkplaceFinding> found) {
  workplace_ = std::move(found);
  drawLater();
}

bool ReportPanel::isOfTask() const {
  return kind_->current() == 1;
}

ergonomics::Report ReportPanel::report() const {
  if (scores_.isEmpty() || !context_.entity()) return {};
  return isOfTask() ? ergonomics::taskReport(input()) : ergonomics::postureReport(input());
}

bool ReportPanel::write(const QString& path) {
  if (scores_.isEmpty()) return false;
  if (path.endsWith(".pdf") || path.endsWith(".html") || path.endsWith(".htm")) takeScene(kFineSamples);
  const auto written = ergonomics::writeReport(report(), path.toStdString());
  if (written) {
    context_.host().messages().tell(Severity::kInformation, tr("The report is saved"), path);
  } else {
    context_.host().messages().reportCause(Severity::kProblem, tr("The report was not saved"), written.error());
  }
  return written.has_value();
}

void ReportPanel::takeScene(int samples) {
  const workcell::Entity* entity = context_.entity();
  scene_ = {};
  if (!entity || scores_.isEmpty()) return;
  if (!renderer_) {
    auto made = PictureRenderer::make();
    if (!made) return;  // No OpenGL: the report has its outline only.
    renderer_.emplace(std::move(*made));
  }
  SceneModel scene = context_.host().viewport().scene();
  mannequin::Posture posture = scores_.posture();
  if (isOfPhase()) {
    posture = placedHere(*entity, motion_.posture(motion_.worstFrame()));
    const auto stands = mannequin::toModel(*entity->figure(), posture);
    scene.setPlayed({{entity->id, stands.X_WE, stands.joints}});
    scene.setLinkLooks(entity->id, {});  // They are of the posture in which it stands.
  } else {
    scene.setPlayed({});
  }
  geometry::Bounds about;
  const auto pose = mannequin::forwardKinematics(*scores_.figure(), posture);
  for (const auto& segment : pose.segments) {
    about.add(segment.p_WS - dvec3(kAround));
    about.add(segment.p_WS + dvec3(kAround));
  }
  const Camera camera =
      context_.host().viewport().camera().fitted(about, {kSceneSize.width() * 1.0, kSceneSize.height() * 1.0});
  PictureRenderer::Look look;
  look.samples = samples;
  const QImage drawn = renderer_->draw(scene, camera, kSceneSize, lightTheme(), look)
                           .convertToFormat(QImage::Format_ARGB32_Premultiplied);
  scene_.width = drawn.width();
  scene_.height = drawn.height();
  for (int y = 0; y < drawn.height(); ++y) {
    const auto* line = static_cast<const QRgb*>(static_cast<const void*>(drawn.constScanLine(y)));
    scene_.pixels.insert(scene_.pixels.end(), line, line + drawn.width());
  }
}

void ReportPanel::chooseFile() {
  const QString path = askToSave(this, tr("Save the report"), "report.pdf",
                                 tr("PDF (*.pdf);;HTML (*.html);;Comma-separated values (*.csv);;JSON (*.json)"));
  if (!path.isEmpty()) write(path);
}

void ReportPanel::drawLater() {
  if (isSeen(*this)) wait_.start();
}

void ReportPanel::draw() {
  if (scores_.isEmpty() || !context_.entity()) {
    page_->setText(tr("No mannequin to report on. Add one first."));
    return;
  }
  if (drawing_) {
    again_ = true;
    return;
  }
  drawing_ = true;
  const double ratio = devicePixelRatioF();
  struct Drawn {
    ergonomics::ReportPicture picture;
    int pages = 1;
  };
  runInThreadPool(
      this,
      [input = input(), of_task = isOfTask(), page = shown_page_, width = static_cast<int>(ratio * pageWidth())] {
        const ergonomics::Report report = of_task ? ergonomics::taskReport(input) : ergonomics::postureReport(input);
        Drawn drawn;
        drawn.pages = ergonomics::reportPages(report);
        drawn.picture = ergonomics::drawReportPage(report, std::min(page, drawn.pages), width);
        return drawn;
      },
      [this, ratio](Drawn drawn) {
        drawing_ = false;
        pages_ = drawn.pages;
        shown_page_ = std::min(shown_page_, pages_);
        which_->setText(tr("Page %1 of %2").arg(shown_page_).arg(pages_));
        const auto* bytes = static_cast<const uchar*>(static_cast<const void*>(drawn.picture.pixels.data()));
        QImage image = QImage(bytes, drawn.picture.width, drawn.picture.height, QImage::Format_RGB32).copy();
        image.setDevicePixelRatio(ratio);
        page_->setPixmap(QPixmap::fromImage(image));
        page_->setMinimumWidth(zoom_->currentIndex() == 0 ? 0 : pageWidth());
        if (again_) {
          again_ = false;
          draw();
        }
      });
}

void ReportPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  drawLater();
}

void ReportPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  takeScene(kQuickSamples);
  wait_.start();
}

}  // namespace hapticell::app
