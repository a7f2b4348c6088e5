// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_desktop/devices/sound_player.h"

#include <QAudioDevice>
#include <QAudioSink>
#include <QIODevice>
#include <QMediaDevices>
#include <mutex>
#include <vector>

namespace hapticell::app {
namespace {

constexpr int kRate = 48000;
// An eighth of a second of 16-bit samples: a busy window pauses for less. Half: gaps on slow machines; twice: knocks
// come late.
constexpr int kBufferBytes = kRate / 8 * 2;

/// Where there is no sound server the multimedia library says so on stderr; the status bar tells it better.
class QuietLibrary {
 public:
  QuietLibrary() : before_(qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {})) {}
  ~QuietLibrary() { qInstallMessageHandler(before_); }
  QuietLibrary(const QuietLibrary&) = delete;
  QuietLibrary& operator=(const QuietLibrary&) = delete;

 private:
  QtMessageHandler before_;
};

}  // namespace

/// What the sink reads from, in whatever thread it likes.
class SoundPlayer::Source : public QIODevice {
 public:
  Source() : synthesis_(kRate) { open(ReadOnly); }
  void setCue(const SoundCue& cue) {
    const std::scoped_lock lock(mutex_);
    synthesis_.setCue(cue);
  }
  /// What was struck while muted is not heard late.
  void clear() {
    const std::scoped_lock lock(mutex_);
    synthesis_ = SoundSynthesis(kRate);
  }
  void strike(SoundEvent event) {
    const std::scoped_lock lock(mutex_);
    synthesis_.strike(event);
  }
  bool isSequential() const override { return true; }
  qint64 bytesAvailable() const override { return kBufferBytes + QIODevice::bytesAvailable(); }

 protected:
  qint64 readData(char* data, qint64 size) override {
    const std::scoped_lock lock(mutex_);
    const auto count = static_cast<std::size_t>(size / 2);
    samples_.resize(count);
    synthesis_.render(samples_.data(), count);
    auto* out = reinterpret_cast<qint16*>(data);
    for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<qint16>(32767.0f * samples_[i]);
    return static_cast<qint64>(count) * 2;
  }
  qint64 writeData(const char*, qint64) override { return -1; }

 private:
  std::mutex mutex_;
  SoundSynthesis synthesis_;
  std::vector<float> samples_;
};

SoundPlayer::SoundPlayer(bool on, QObject* parent) : QObject(parent), source_(std::make_unique<Source>()), on_(on) {
  const QuietLibrary quiet;
  const QAudioDevice output = QMediaDevices::defaultAudioOutput();
  QAudioFormat format;
  format.setSampleRate(kRate);
  format.setChannelCount(1);
  format.setSampleFormat(QAudioFormat::Int16);
  if (output.isNull() || !output.isFormatSupported(format)) return;
  sink_ = std::make_unique<QAudioSink>(output, format);
  sink_->setBufferSize(kBufferBytes);
  if (on_) sink_->start(source_.get());
}

SoundPlayer::~SoundPlayer() {
  if (sink_) sink_->stop();
}

void SoundPlayer::setOn(bool on) {
  if (on == on_) return;
  on_ = on;
  source_->clear();
  if (sink_) on_ ? sink_->start(source_.get()) : sink_->stop();
  emit changed();
}

void SoundPlayer::play(const SoundCue& cue) {
  source_->setCue(cue);
}

void SoundPlayer::strike(SoundEvent event) {
  source_->strike(event);
}

QString SoundPlayer::state() const {
  if (!hasOutput()) return tr("No sound output");
  return on_ ? tr("Sound on") : tr("Sound off");
}

}  // namespace hapticell::app
