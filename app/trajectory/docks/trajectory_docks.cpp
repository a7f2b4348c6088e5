// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/docks/trajectory_docks.h"

#include <QAction>
#include <QDateTime>
#include <QDockWidget>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QTimer>
#include <QToolBar>
#include <cmath>

#include "app/controls/refresh_timer.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/stylus_use.h"
#include "app/host/message_log.h"
#include "app/host/recording_hub.h"
#include "app/kit/action_face.h"
#include "app/kit/dock_front.h"
#include "app/kit/file_dialog.h"
#include "app/kit/top_menus.h"
#include "app/panels/cell/workcell_panel.h"
#include "app/style/dock_title_bar.h"
#include "app/style/icon.h"
#include "app/style/library_text.h"
#include "app/style/theme.h"
#include "app/trajectory/docks/frame_gizmo.h"
#include "app/trajectory/docks/motion_panel.h"
#include "app/trajectory/docks/motion_tree.h"
#include "app/trajectory/docks/trajectory_panel.h"
#include "app/trajectory/motions/motion_export.h"
#include "app/trajectory/motions/motion_list.h"
#include "app/trajectory/motions/motion_player.h"
#include "app/trajectory/motions/motion_work.h"
#include "app/trajectory/motions/play_video.h"
#include "app/trajectory/motions/trace_curves.h"
#include "app/trajectory/motions/window_recorder.h"
#include "app/trajectory/training/training_docks.h"
#include "app/trajectory/training/training_panel.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

constexpr int kDockWidth = 332, kHighDock = 460;
// Points of a drawn trace. Half: corners are seen; twice: twice the lines of each frame.
constexpr std::size_t kTracePoints = 600;

/// Docks of one window and what they share; owned by the window.
class TrajectoryDocks : public QObject {
 public:
  explicit TrajectoryDocks(Host& host)
      : QObject(&host.window()),
        host_(host),
        list_(host, this),
        player_(host, list_, this),
        work_(host, list_, this),
        files_(host, list_, this),
        recorder_(host, this),
        gizmo_(host, this),
        video_(host, player_, this),
        training_(host, list_, this) {
    panel_ = new TrajectoryPanel(host_, list_, player_);
    dock_ = makeDock("dockTrajectory", tr("Trajectory"), panel_);
    motion_ = new MotionPanel({list_, player_, work_, files_, panel_->timeBar()});
    scroll_ = new QScrollArea;
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setMinimumWidth(kDockWidth);
    scroll_->setWidget(motion_);
    motion_dock_ = makeDock("dockMotion", tr("Motion"), scroll_);
    host_.addDock(motion_dock_, Qt::RightDockWidgetArea);
    motion_dock_->hide();
    host_.viewport().installEventFilter(this);
    connectPanels();
    addActions();
    connectScene();
    connect(&refreshTimer(host), &QTimer::timeout, this, &TrajectoryDocks::showRecording);
  }
  QDockWidget* dock() { return dock_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool escape =
        event->type() == QEvent::KeyPress && static_cast<const QKeyEvent*>(event)->key() == Qt::Key_Escape;
    if (escape && gizmo_.cancel()) return true;
    if (escape && !host_.snapshot() && player_.isShown()) {
      player_.setShown(false);
      return true;
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  void connectPanels() {
    connect(panel_, &TrajectoryPanel::recordWanted, this, &TrajectoryDocks::toggleRecording);
    connect(panel_, &TrajectoryPanel::editWanted, this, [this] { openMotion({}); });
    connect(panel_, &TrajectoryPanel::smoothWanted, this, [this] { openMotion(tr("Clean")); });
    connect(panel_, &TrajectoryPanel::exportWanted, this, [this] { openMotion(tr("Export")); });
    connect(panel_, &TrajectoryPanel::checkWanted, this, [this] { work_.check(); });
    connect(panel_, &TrajectoryPanel::trimWanted, motion_, &MotionPanel::trim);
    connect(panel_, &TrajectoryPanel::frameChosen, this, [this](std::size_t frame) { motion_->setFrame(frame); });
    connect(panel_, &TrajectoryPanel::roomWanted, this, [this] {
      if (isStylusInUse(host_) || dock_->isFloating() || dock_->height() >= kHighDock) return;
      host_.window().resizeDocks({dock_}, {kHighDock}, Qt::Vertical);
    });
    connect(motion_, &MotionPanel::sectionWanted, this,
            [this](QWidget* section) { scroll_->ensureWidgetVisible(section, 0, 160); });
    const auto tell = [this](const QString& line, bool careful) {
      panel_->showLine(line, careful);
      motion_->showLine(line, careful);
    };
    connect(&work_, &MotionWork::told, this, tell);
    connect(&work_, &MotionWork::missed, this, [this] {
      panel_->markMissed();
      motion_->markMissed();
    });
    connect(&files_, &MotionExport::told, this, tell);
    connect(&training_.panel(), &TrainingPanel::told, this, tell);
    connect(&training_.panel(), &TrainingPanel::sceneWanted, this, [this] { player_.setShown(false); });
    connect(&host_.recording(), &RecordingHub::recorded, this, &TrajectoryDocks::takeRecorded);
    connect(&host_.documentModel(), &DocumentModel::closing, this, [this, tell] {
      video_.cancel();
      gizmo_.cancel();
      motion_->setFrame(std::nullopt);
      panel_->timeBar().setPart(std::nullopt);
      panel_->timeBar().showAll();
      takes_ = 0;
      tell({}, false);
    });
  }

  void connectScene() {
    connect(&list_, &MotionList::changed, this, &TrajectoryDocks::showTraces);
    connect(&list_, &MotionList::currentChanged, this, &TrajectoryDocks::showTraces);
    connect(motion_, &MotionPanel::frameChanged, this, [this] {
      panel_->setFrame(motion_->frame());
      showTraces();
      showGizmo();
    });
    connect(&gizmo_, &FrameGizmo::dropped, this, [this](const Pose& X_WT) {
      const auto frame = motion_->frame();
      if (!frame) return;
      work_.edit(tr("frame moved"),
                 [i = *frame, X_WT,
                  reach = motion_->reach()](const auto& given) -> Expected<std::vector<trajectory::Trajectory>> {
                   auto made = trajectory::withFrameAt(given, i, X_WT, reach);
                   HAPTICELL_TRY(made);
                   return std::vector<trajectory::Trajectory>{std::move(*made)};
                 });
    });
    if (auto* tree = host_.window().findChild<WorkcellPanel*>()) {
      auto* rows = new MotionTree({list_, player_, work_}, *tree, this);
      connect(rows, &MotionTree::frameChosen, this, [this](std::size_t frame) { motion_->setFrame(frame); });
      connect(rows, &MotionTree::editorWanted, this, [this] { openMotion({}); });
      connect(rows, &MotionTree::told, panel_, &TrajectoryPanel::showLine);
    }
    showTraces();
  }

  void showGizmo() {
    const Motion* motion = list_.current();
    const auto frame = motion_->frame();
    const bool any = motion && motion->trajectory && frame && *frame < motion->trajectory->size();
    gizmo_.setFrame(any ? std::optional<Pose>((*motion->trajectory)[*frame].X_WT) : std::nullopt);
  }

  void showTraces() {
    std::vector<SceneCurve> curves;
    for (const Motion& motion : list_.motions()) {
      const bool current = list_.current() && list_.current()->name == motion.name;
      if (!motion.played && !current) continue;
      auto trace = traceCurves(motion, kTracePoints, {}, 0.0);
      curves.insert(curves.end(), trace.begin(), trace.end());
    }
    host_.viewport().setCurves("motions", std::move(curves));
  }

  void addActions() {
    QMenu* menu = topMenu(host_.window(), "menuTrajectory", tr("Trajectory"));
    const auto entry = [&](const ActionFace& face, auto&& slot) {
      QAction* action = makeAction(&host_.window(), face);
      host_.window().addAction(action);
      menu->addAction(action);
      connect(action, &QAction::triggered, this, slot);
      return action;
    };
    record_ =
        entry({"actionRecord", tr("Record"), "record", QKeySequence(Qt::Key_R), {}}, [this] { toggleRecording(); });
    entry({"actionAddFrame", tr("Add a frame"), {}, QKeySequence(Qt::SHIFT | Qt::Key_R), {}}, [this] { addFrame(); });
    menu->addSeparator();
    entry({"actionPlay", tr("Play or pause"), "play", {}, {}},
          [this] { playOrPause(); });
    entry({"actionCheckMotion", tr("Check the motion"), "check", {}, {}}, [this] { work_.check(); });
    entry({"actionMotionPanel", tr("Edit and export motions…"), "trajectory", {}, {}}, [this] { openMotion({}); });
    entry({"actionTraining", tr("Train on a motion…"), "hand", {}, {}}, [this] { training_.open(); });
    film_ = entry({"actionMotionVideo", tr("Video of the motion…"), {}, {}, {}}, [this] { makeVideo(); });
    connect(&video_, &PlayVideo::stepped, this,
            [this] { film_->setText(tr("Stop the video, %1 % done").arg(static_cast<int>(100.0 * video_.share()))); });
    connect(&video_, &PlayVideo::ended, this, [this](const QString& file, const QString& problem) {
      film_->setText(tr("Video of the motion…"));
      panel_->showLine(problem.isEmpty() ? tr("%1 is saved").arg(QFileInfo(file).fileName()) : problem,
                       !problem.isEmpty());
    });
    entry({"actionImportMotion", tr("Import motions…"), "import", {}, {}}, [this] { files_.askImport(); });
    if (auto* tools = host_.window().findChild<QToolBar*>("toolMain")) {
      // With the tools, before what stands at the right end.
      QAction* right = nullptr;
      for (QAction* tool : tools->actions())
        if (QWidget* widget = tools->widgetForAction(tool); widget && widget->objectName() == "toolSpacer")
          right = tool;
      tools->insertAction(right, record_);
      // As wide as it is while it counts: its neighbours stay.
      constexpr int kMargins = 12;
      if (QWidget* button = tools->widgetForAction(record_))
        button->setMinimumWidth(tools->fontMetrics().horizontalAdvance(tr("Rec %1:%2").arg("00", "00.0")) + kMargins);
    }
  }

  void playOrPause() {
    if (player_.playback().isPlaying()) return player_.pause();
    player_.play();
    if (!player_.playback().isPlaying())
      panel_->showLine(tr("No motion is switched on. Record or import one, and switch it on in the list."), true);
  }

  void makeVideo() {
    if (video_.isBusy()) {
      video_.cancel();
      return film_->setText(tr("Video of the motion…"));
    }
    const QString file =
        askToSave(&host_.window(), tr("Video of the motion"), {}, tr("Videos, by ffmpeg (*.mp4 *.webm *.mkv *.gif)"));
    if (file.isEmpty()) return;
    const auto begun = video_.start(file, {1280, 720});
    if (!begun) panel_->showLine(shownText(begun.error()), true);
  }

  void openMotion(const QString& section) {
    if (isStylusInUse(host_)) {
      panel_->showLine(tr("Switch the forces off first. Panels stay in place while the stylus is in use."), true);
      return;
    }
    bringToFront(motion_dock_);
    if (!section.isEmpty()) QTimer::singleShot(0, motion_, [this, section] { motion_->showSection(section); });
  }

  void toggleRecording() {
    RecordingHub& hub = host_.recording();
    if (hub.isRecording()) return hub.stop();
    player_.setShown(false);
    auto wanted = motion_->recordingWanted();
    wanted.take = list_.uniqueName(tr("Take %1").arg(++takes_).toStdString());
    hub.start(wanted);
    dock_->show();
    showRecording();
  }

  void addFrame() {
    RecordingHub& hub = host_.recording();
    if (!hub.isRecording()) {
      // The first point of a recording by hand begins it.
      player_.setShown(false);
      auto wanted = motion_->recordingWanted();
      wanted.options.mode = trajectory::RecordingMode::kByHand;
      wanted.take = list_.uniqueName(tr("Take %1").arg(++takes_).toStdString());
      hub.start(wanted);
    }
    hub.mark();
  }

  void takeRecorded(const std::vector<trajectory::Trajectory>& trajectories) {
    if (training_.panel().takeRecorded(trajectories)) return showRecording();
    if (trajectories.empty()) {
      panel_->showLine(tr("Nothing moved, so nothing was recorded."), true);
      return showRecording();
    }
    std::vector<std::pair<std::string, trajectory::Trajectory>> named;
    std::size_t frames = 0;
    for (const auto& one : trajectories) {
      named.emplace_back(one.entity + ", " + one.take, one);
      frames += one.size();
    }
    list_.add(tr("Record %1").arg(QString::fromStdString(trajectories.front().take)), std::move(named));
    showRecording();
    panel_->showLine(tr("Frames recorded: %1").arg(frames), false);
  }

  /// Recording is told where it was begun too: framed and coloured like its mark.
  void showInToolBar(bool recording) {
    auto* tools = host_.window().findChild<QToolBar*>("toolMain");
    QWidget* button = tools ? tools->widgetForAction(record_) : nullptr;
    if (!button || button->property("recording").toBool() == recording) return;
    button->setProperty("recording", recording);
    const Theme& theme = themeOf(host_.window().palette());
    record_->setIcon(recording ? icon("record", theme.contact) : icon("record"));
    button->update();
  }

  void showRecording() {
    const RecordingHub& hub = host_.recording();
    std::optional<TrajectoryPanel::Recording> shown;
    const auto& snapshot = host_.snapshot();
    if (recorder_.isRecording())
      shown = TrajectoryPanel::Recording{recorder_.seconds(), recorder_.frames(), recorder_.framesByHand()};
    else if (hub.isRecording() && snapshot && snapshot->recording.on)
      shown = TrajectoryPanel::Recording{snapshot->recording.seconds, snapshot->recording.frames,
                                         snapshot->recording.by_hand};
    panel_->showRecording(shown);
    const QString word = shown ? tr("Rec %1:%2")
                                     .arg(static_cast<int>(shown->seconds) / 60, 2, 10, QChar('0'))
                                     .arg(std::fmod(shown->seconds, 60.0), 4, 'f', 1, QChar('0'))
                               : tr("Record");
    if (record_->iconText() != word) record_->setIconText(word);
    showInToolBar(shown.has_value());
  }

  Host& host_;
  MotionList list_;
  MotionPlayer player_;
  MotionWork work_;
  MotionExport files_;
  WindowRecorder recorder_;
  FrameGizmo gizmo_;
  PlayVideo video_;
  TrainingDocks training_;
  TrajectoryPanel* panel_;
  MotionPanel* motion_;
  QScrollArea* scroll_;
  QDockWidget *dock_, *motion_dock_;
  QAction *record_ = nullptr, *film_ = nullptr;
  int takes_ = 0;
};

}  // namespace

QDockWidget* addTrajectoryDocks(Host& host) {
  return (new TrajectoryDocks(host))->dock();
}

}  // namespace hapticell::app
