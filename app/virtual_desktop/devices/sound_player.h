// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <memory>

#include "app/virtual_desktop/devices/sound_synthesis.h"

class QAudioSink;

namespace hapticell::app {

/// Plays the cues on the default output; without an output it stays silent and reports it. GUI thread.
class SoundPlayer : public QObject {
  Q_OBJECT
 public:
  explicit SoundPlayer(bool on, QObject* parent = nullptr);
  ~SoundPlayer() override;
  void setOn(bool on);
  bool isOn() const { return on_; }
  bool hasOutput() const { return sink_ != nullptr; }
  void play(const SoundCue& cue);
  void strike(SoundEvent event);
  /// "Sound on", "Sound off" or "No sound output".
  QString state() const;

 signals:
  void changed();

 private:
  class Source;
  std::unique_ptr<Source> source_;
  std::unique_ptr<QAudioSink> sink_;
  bool on_;
};

}  // namespace hapticell::app
