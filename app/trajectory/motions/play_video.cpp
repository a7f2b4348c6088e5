// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/motions/play_video.h"

#include <QMainWindow>
#include <algorithm>
#include <cmath>

#include "app/host/host.h"
#include "app/kit/video_writer.h"
#include "app/style/library_text.h"
#include "app/style/theme.h"
#include "app/trajectory/motions/motion_player.h"
#include "app/viewport/drawing/picture_renderer.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

// As European television has. Half: jerks; twice: twice the time and size.
constexpr int kFramesASecond = 25;
// Of a picture: smooth edges. Half: edges flicker; twice: twice the time.
constexpr int kSamples = 4;

}  // namespace

struct PlayVideo::Work {
  PictureRenderer renderer;
  std::unique_ptr<VideoWriter> writer;
  SceneModel scene;
  Camera camera;
  QString file;
  QSize size;
  bool dark = true;
  double begin = 0.0, step = 0.0;  ///< s of the motion.
  int count = 1, done = 0;
};

PlayVideo::PlayVideo(Host& host, const MotionPlayer& player, QObject* parent)
    : QObject(parent), host_(host), player_(player) {
  connect(&timer_, &QTimer::timeout, this, &PlayVideo::step);
}

PlayVideo::~PlayVideo() = default;

Expected<void> PlayVideo::start(const QString& file, const QSize& size) {
  const auto& playback = player_.playback();
  const double length = playback.end() - playback.begin();
  if (!(length > 0.0))
    return makeError({.place = "motion",
                      .found = "no motion is switched on",
                      .expected = "at least one motion that is switched on"});
  auto renderer = PictureRenderer::make();
  HAPTICELL_TRY(renderer);
  const QSize even(size.width() & ~1, size.height() & ~1);
  auto writer = VideoWriter::open(file, even, kFramesASecond);
  HAPTICELL_TRY(writer);
  work_ = std::make_unique<Work>(Work{std::move(*renderer), std::move(*writer), host_.viewport().scene(),
                                      host_.viewport().camera(), file, even, themeOf(host_.window().palette()).dark,
                                      playback.begin()});
  const double speed = std::max(playback.speed(), 1e-3);
  work_->count = std::max(2, static_cast<int>(std::ceil(kFramesASecond * length / speed)) + 1);
  work_->step = length / (work_->count - 1);
  timer_.start(0);
  return {};
}

void PlayVideo::cancel() {
  timer_.stop();
  work_.reset();
}

double PlayVideo::share() const {
  return work_ ? static_cast<double>(work_->done) / work_->count : 0.0;
}

void PlayVideo::step() {
  Work& work = *work_;
  work.scene.setPlayed(player_.playedAt(work.begin + work.step * work.done));
  PictureRenderer::Look look;
  look.samples = kSamples;
  auto added = work.writer->add(
      work.renderer.draw(work.scene, work.camera, work.size, work.dark ? darkTheme() : lightTheme(), look));
  if (added && ++work.done == work.count) added = work.writer->finish();
  if (added && work.done < work.count) {
    emit stepped();
    return;
  }
  const QString file = work.file, problem = added ? QString() : shownText(added.error());
  cancel();
  emit ended(file, problem);
}

}  // namespace hapticell::app
