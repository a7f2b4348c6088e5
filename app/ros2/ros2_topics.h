// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <QJsonArray>
#include <QWidget>

#include "app/ros2/ros2_process.h"

class QPlainTextEdit;
class QPushButton;

namespace hapticell::app {

class LiveLabel;
class Ros2Network;

/// The topics of other programs: found on request, and by a link while it is on. GUI thread.
class Ros2Topics : public QWidget {
  Q_OBJECT
 public:
  explicit Ros2Topics(const Ros2Network& network, QWidget* parent = nullptr);
  /// Takes the topics that a job of hapticell-ros2 reports.
  void take(const QJsonArray& topics);
  /// Names of published topics of a type, as DDS names it.
  QStringList publishedOf(const QString& type) const;

 signals:
  void changed();  ///< Other topics than before.

 private:
  void find();
  void show();

  const Ros2Network& network_;
  Ros2Process process_;
  QPushButton* find_;
  LiveLabel* line_;
  QPlainTextEdit* list_;
  QJsonArray topics_;
  QString problem_;
  bool asked_ = false;
};

/// Chooses a topic among the found ones of a type, or a typed name.
class TopicChoice : public QComboBox {
  Q_OBJECT
 public:
  /// `usual` is the topic at first.
  TopicChoice(const char* name, const Ros2Topics& topics, QString type, const QString& usual, QWidget* parent = nullptr);
  /// With a slash in front; the usual one if nothing is typed.
  QString topic() const;

 private:
  void offer();

  const Ros2Topics& topics_;
  QString type_, usual_;
};

}  // namespace hapticell::app
