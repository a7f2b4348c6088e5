// SPDX-License-Identifier: Apache-2.0
#include "app/views/view_pictures.h"

#include <QAction>
#include <QApplication>
#include <QCoreApplication>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QTimer>
#include <memory>

#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/kit/action_face.h"
#include "app/kit/file_dialog.h"
#include "app/style/theme.h"
#include "app/viewport/widget/viewport_widget.h"
#include "app/views/render_command.h"

namespace hapticell::app {
namespace {

struct PictureMenu {
  Q_DECLARE_TR_FUNCTIONS(PictureMenu)
};

void tell(Host& host, const QString& file, const Expected<void>& done) {
  const QString name = QFileInfo(file).fileName();
  if (done)
    host.messages().tell(Severity::kInformation, PictureMenu::tr("%1 is saved").arg(name));
  else
    host.messages().reportCause(Severity::kProblem, PictureMenu::tr("%1 was not saved").arg(name), done.error());
}

RenderCommand commandFor(Host& host, const QString& file, const QSize& size) {
  RenderCommand command;
  command.output = file;
  command.size = size;
  command.light = !themeOf(host.window().palette()).dark;
  return command;
}

/// Draws a video while the window goes on; its action then says how far it is, and ends it.
class VideoWork : public QObject {
 public:
  VideoWork(Host& host, QAction& action, QObject* owner)
      : QObject(owner), host_(host), action_(action), text_(action.text()) {
    connect(&timer_, &QTimer::timeout, this, &VideoWork::step);
  }
  bool isBusy() const { return video_ != nullptr; }
  void start(const QString& file, const QSize& size) {
    auto video = TurnVideo::begin(commandFor(host_, file, size), host_.viewport().scene(), host_.viewport().camera());
    if (!video) return tell(host_, file, makeError(video.error()));
    video_ = std::move(*video);
    file_ = file;
    timer_.start(0);
  }
  void stop() {
    timer_.stop();
    video_.reset();
    action_.setText(text_);
  }

 private:
  void step() {
    const auto stepped = video_->step();
    action_.setText(PictureMenu::tr("Stop the video, %1 % done").arg(static_cast<int>(100.0 * video_->share())));
    if (stepped && !video_->isDone()) return;
    stop();
    tell(host_, file_, stepped);
  }

  Host& host_;
  QAction& action_;
  QString text_, file_;
  QTimer timer_;
  std::unique_ptr<TurnVideo> video_;
};

}  // namespace

void addPictures(Host& host, QMenu& menu, QObject* owner) {
  QMenu* pictures = menu.addMenu(PictureMenu::tr("Picture of the view"));
  const auto add = [&](const char* name, const QString& text, const QSize& size, const QString& filter) {
    QAction* action = makeAction(&host.window(), {name, text, {}, {}, {}});
    pictures->addAction(action);
    QObject::connect(action, &QAction::triggered, owner, [&host, size, filter] {
      const QString file = askToSave(&host.window(), PictureMenu::tr("Picture of the view"), {}, filter);
      if (file.isEmpty()) return;
      const QSize wanted = size.isEmpty() ? host.viewport().size() * host.viewport().devicePixelRatioF() : size;
      QApplication::setOverrideCursor(Qt::WaitCursor);
      const auto done = renderScene(commandFor(host, file, wanted), host.viewport().scene(), host.viewport().camera());
      QApplication::restoreOverrideCursor();
      tell(host, file, done);
    });
  };
  const QString images = PictureMenu::tr("Pictures (*.png *.jpg *.tiff)");
  add("actionPictureAsIs", PictureMenu::tr("Current size…"), {}, images);
  add("actionPictureHd", QStringLiteral("1920 × 1080…"), {1920, 1080}, images);
  add("actionPicture4k", QStringLiteral("3840 × 2160…"), {3840, 2160}, images);
  add("actionPicturePrint", PictureMenu::tr("For print, 6000 × 4000…"), {6000, 4000}, images);
  QAction* video = makeAction(&host.window(), {"actionVideo", PictureMenu::tr("Turntable video…"), {}, {}, {}});
  pictures->addAction(video);
  auto* work = new VideoWork(host, *video, owner);
  QObject::connect(video, &QAction::triggered, work, [&host, work] {
    if (work->isBusy()) return work->stop();
    const QString file = askToSave(&host.window(), PictureMenu::tr("Turntable video"), {},
                                   PictureMenu::tr("Videos, by ffmpeg (*.mp4 *.webm *.mkv *.gif)"));
    if (!file.isEmpty()) work->start(file, {1280, 720});
  });
}

}  // namespace hapticell::app
