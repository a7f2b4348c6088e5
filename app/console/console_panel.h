// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <QTimer>
#include <QWidget>
#include <cstdint>
#include <optional>

#include "app/console/action_recorder.h"
#include "app/console/console_history.h"
#include "app/console/console_link.h"

class QAbstractButton;
class QMenu;
class QPlainTextEdit;

namespace hapticell::app {

class ConsoleInput;
class Host;
class LiveLabel;

/// The Python console: what was printed, the field to type in, scripts and recorded actions. What a statement or a script
/// changes of the cell is one step of undo. GUI thread.
class ConsolePanel : public QWidget {
  Q_OBJECT
 public:
  explicit ConsolePanel(Host& host, QWidget* parent = nullptr);
  ~ConsolePanel() override;
  /// Runs a script (*.py) that only this user can have written.
  void runScript(const QString& file);
  void focusInput();

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  enum class Look { kTyped, kPrinted, kError };
  /// What is to run: statements, or a script.
  struct Work {
    QString text;
    bool is_script = false;
  };
  QWidget* makeTools();
  void connectLink();
  void enter();
  void runNext();
  void send(const std::optional<CellText>& cell);
  void takeMore();
  void takeFinished(const std::optional<std::string>& text, const QString& step);
  void applyChange(const Expected<std::vector<workcell::Command>>& commands, const QString& step);
  void showWords(const QString& before, int start, const QStringList& words);
  void showState();
  void fillScripts();
  void toggleRecording(bool on);
  void keepScript(std::size_t mark);
  void chooseScript();
  void say(const QString& text, Look look);
  void sayLine(const QString& text, Look look);
  void flush();
  bool isBusy() const;
  QStringList selection() const;

  Host& host_;
  ConsoleHistory history_;
  ConsoleLink link_;
  ActionRecorder recorder_;
  QPlainTextEdit* output_;
  ConsoleInput* input_;
  LiveLabel* state_;
  QMenu* scripts_;
  QAbstractButton *record_, *interrupt_;
  QList<Work> waiting_;            ///< Typed ahead; the first one runs if `running_`.
  bool running_ = false;           ///< From sending until its change is in the cell.
  workcell::DocumentState given_;  ///< The cell as the interpreter has it.
  std::optional<std::uint64_t> given_revision_;
  std::optional<std::size_t> recording_;  ///< Mark of its begin.
  QList<std::pair<QString, Look>> unshown_;
  QTimer flush_;
};

}  // namespace hapticell::app
