// SPDX-License-Identifier: Apache-2.0
#include "app/console/console_panel.h"

#include <QDateTime>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBlock>
#include <QVBoxLayout>
#include <utility>

#include "app/console/console_input.h"
#include "app/console/script_files.h"
#include "app/console/state_commands.h"
#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/selection.h"
#include "app/kit/file_dialog.h"
#include "app/kit/form.h"
#include "app/kit/system_open.h"
#include "app/kit/thread_pool_task.h"
#include "app/style/library_text.h"
#include "app/style/theme.h"
#include "config/user_folders.h"

namespace hapticell::app {

namespace {

// Lines of the output. Half: a long traceback after a long listing is lost; twice: printing in a loop takes more time.
constexpr int kMostKeptLines = 5000;
// ms that printed text is gathered: the window stays free. Half: more work; twice: it seems to come in jerks.
constexpr int kGather = 40;
constexpr int kLongestLine = 20000;       // Letters; longer ones are broken. Half, twice: as well.
constexpr std::size_t kLastActions = 20;  // Written by "Last actions". Half, twice: as well.
constexpr qsizetype kLongestStep = 60;    // Letters of a statement in the name of its step.

QString withPrompts(const QString& source) {
  QString text = source;
  while (text.endsWith(QLatin1Char('\n')) || text.endsWith(QLatin1Char(' '))) text.chop(1);
  return QStringLiteral(">>> ") + text.replace(QLatin1Char('\n'), QStringLiteral("\n... "));
}

}  // namespace

ConsolePanel::ConsolePanel(Host& host, QWidget* parent)
    : QWidget(parent), host_(host), history_(ConsoleHistory::usualFile()), recorder_(host.documentModel()) {
  setObjectName(QStringLiteral("pythonConsole"));
  output_ = new QPlainTextEdit;
  output_->setObjectName(QStringLiteral("textConsoleOutput"));
  output_->setAccessibleName(tr("What Python printed"));
  output_->setReadOnly(true);
  output_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  output_->setMaximumBlockCount(kMostKeptLines);
  output_->setUndoRedoEnabled(false);
  input_ = new ConsoleInput(history_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->addWidget(makeTools());
  column->addWidget(output_, 1);
  column->addWidget(input_);
  connect(input_, &ConsoleInput::ran, this, &ConsolePanel::enter);
  connect(input_, &ConsoleInput::completionWanted, this, [this] { link_.complete(input_->textBeforeCursor()); });
  connect(input_, &ConsoleInput::interrupted, this, [this] { link_.interrupt(); });
  flush_.setSingleShot(true);
  flush_.setInterval(kGather);
  connect(&flush_, &QTimer::timeout, this, &ConsolePanel::flush);
  connectLink();
  showState();
}

ConsolePanel::~ConsolePanel() = default;

QWidget* ConsolePanel::makeTools() {
  auto* tools = new QWidget;
  auto* row = new QHBoxLayout(tools);
  row->setContentsMargins(0, 0, 0, 0);
  auto* scripts = makeButton("buttonConsoleScripts", tr("Scripts"));
  scripts_ = new QMenu(scripts);
  scripts_->setObjectName(QStringLiteral("menuConsoleScripts"));
  scripts->setMenu(scripts_);
  connect(scripts_, &QMenu::aboutToShow, this, &ConsolePanel::fillScripts);
  record_ = makeButton("buttonConsoleRecord", tr("Record actions"));
  record_->setCheckable(true);
  record_->setToolTip(tr("Write what you do to the cell from now on as a script"));
  connect(record_, &QAbstractButton::toggled, this, &ConsolePanel::toggleRecording);
  interrupt_ = makeButton("buttonConsoleInterrupt", tr("Interrupt"));
  interrupt_->setToolTip(tr("Ends what runs (Ctrl+C in the field); a second time, ends the interpreter"));
  connect(interrupt_, &QAbstractButton::clicked, this, [this] {
    link_.interrupt();
    input_->setFocus();
  });
  state_ = makeLive(1, TextRole::kSecond, true);
  state_->setObjectName(QStringLiteral("labelConsoleState"));
  for (QWidget* one : std::initializer_list<QWidget*>{scripts, record_, interrupt_}) row->addWidget(one);
  row->addWidget(state_, 1);
  return tools;
}

void ConsolePanel::connectLink() {
  connect(&link_, &ConsoleLink::stateChanged, this, &ConsolePanel::showState);
  connect(&link_, &ConsoleLink::stateChanged, this, &ConsolePanel::runNext, Qt::QueuedConnection);
  connect(&link_, &ConsoleLink::printed, this,
          [this](const QString& text, bool is_error) { say(text, is_error ? Look::kError : Look::kPrinted); });
  connect(&link_, &ConsoleLink::begun, this, [this] {
    if (running_ && !waiting_.isEmpty() && !waiting_.front().is_script)
      sayLine(withPrompts(waiting_.front().text), Look::kTyped);
  });
  connect(&link_, &ConsoleLink::moreWanted, this, &ConsolePanel::takeMore);
  connect(&link_, &ConsoleLink::finished, this, &ConsolePanel::takeFinished);
  connect(&link_, &ConsoleLink::completed, this, &ConsolePanel::showWords);
  const auto lose = [this](const QString& sentence) {
    waiting_.clear();
    running_ = false;
    given_revision_.reset();
    sayLine(sentence, Look::kError);
  };
  connect(&link_, &ConsoleLink::ended, this, lose);
  connect(&link_, &ConsoleLink::failed, this, lose);
}

void ConsolePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (link_.state() == ConsoleLink::State::kOff) link_.start();
}

/// Printed text keeps the colour it was printed in, so it is coloured by what is readable in both themes; the next text
/// has the new theme's.
void ConsolePanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) showState();
}

void ConsolePanel::focusInput() {
  input_->setFocus();
}

bool ConsolePanel::isBusy() const {
  return running_ || link_.state() == ConsoleLink::State::kRunning;
}

void ConsolePanel::enter() {
  const bool ahead = isBusy() || !waiting_.isEmpty();
  if (!ahead && input_->toPlainText().trimmed().isEmpty()) return;
  waiting_.append({input_->take(), false});
  link_.start();
  runNext();
}

void ConsolePanel::runScript(const QString& file) {
  if (const auto own = config::checkUserFile(file.toStdString()); !own)
    return sayLine(shownText(own.error()), Look::kError);
  waiting_.append({file, true});
  link_.start();
  runNext();
}

/// The cell goes along where it is another than at the last time; its text is made in another thread.
void ConsolePanel::runNext() {
  if (running_ || waiting_.isEmpty() || link_.state() != ConsoleLink::State::kReady) return;
  running_ = true;
  const workcell::Document& document = host_.documentModel().document();
  if (given_revision_ == document.revision()) return send(std::nullopt);
  given_revision_ = document.revision();
  given_ = document.state();
  runInThreadPool(
      this, [state = given_, path = document.path()] { return cellTextOf(state, path); },
      [this](const CellText& cell) {
        if (running_ && link_.state() == ConsoleLink::State::kReady) send(cell);
      });
}

void ConsolePanel::send(const std::optional<CellText>& cell) {
  const Work& work = waiting_.front();
  if (work.is_script) {
    sayLine(tr("Script %1").arg(QDir::toNativeSeparators(work.text)), Look::kTyped);
    link_.runScript(work.text, cell, selection());
  } else {
    QString source = work.text;
    const qsizetype last = source.lastIndexOf(QLatin1Char('\n')) + 1;
    if (last > 0 && source.mid(last).trimmed().isEmpty()) source.truncate(last);
    link_.run(source, cell, selection());
  }
}

QStringList ConsolePanel::selection() const {
  QStringList names;
  for (const workcell::EntityId id : host_.selection().all())
    if (const auto* entity = host_.documentModel().document().find(id)) names << QString::fromStdString(entity->name);
  return names;
}

/// Not complete: what was typed ahead belongs to it, else it returns into the field with the next line begun.
void ConsolePanel::takeMore() {
  running_ = false;
  // Such a text was sent with the cell before it was looked at, and not taken.
  given_revision_.reset();
  const QString begun = waiting_.takeFirst().text;
  if (!waiting_.isEmpty() && !waiting_.front().is_script) {
    waiting_.front().text.prepend(begun + QLatin1Char('\n'));
    return runNext();
  }
  const QString since = input_->toPlainText();
  input_->setPlainText(begun);
  input_->moveCursor(QTextCursor::End);
  input_->continueLine();
  input_->insertPlainText(since);
}

void ConsolePanel::takeFinished(const std::optional<std::string>& text, const QString& step) {
  if (!running_ || waiting_.isEmpty()) return;
  if (!text) {
    waiting_.removeFirst();
    running_ = false;
    return runNext();
  }
  const Work work = waiting_.takeFirst();
  QString name = work.is_script ? QFileInfo(work.text).fileName() : work.text.trimmed().section(QLatin1Char('\n'), 0, 0);
  if (!step.isEmpty()) name = step;
  if (name.size() > kLongestStep) name = name.left(kLongestStep) + QStringLiteral("…");
  const auto& path = host_.documentModel().document().path();
  const std::filesystem::path folder = path.empty() ? std::filesystem::path("/") : path.parent_path();
  runInThreadPool(
      this, [text = *text, folder, given = given_] { return commandsFromText(text, folder, given); },
      [this, name](const Expected<std::vector<workcell::Command>>& commands) {
        applyChange(commands, tr("Python: %1").arg(name));
      });
}

void ConsolePanel::applyChange(const Expected<std::vector<workcell::Command>>& commands, const QString& step) {
  DocumentModel& model = host_.documentModel();
  running_ = false;
  const bool same = given_revision_ == model.document().revision() && (!model.document().inCompound() || model.inTrial());
  given_revision_.reset();
  if (!commands) {
    sayLine(tr("What Python changed is not taken into the cell: %1").arg(shownText(commands.error())), Look::kError);
  } else if (!same) {
    sayLine(tr("The cell was changed in the window while Python ran, so what Python changed is not taken. Run it again."),
            Look::kError);
  } else if (const auto done = executeCommands(model, step, *commands); !done) {
    sayLine(tr("What Python changed is not taken into the cell: %1").arg(shownText(done.error())), Look::kError);
  } else {
    given_ = model.document().state();
    given_revision_ = model.document().revision();
  }
  runNext();
}

void ConsolePanel::showWords(const QString& before, int start, const QStringList& words) {
  if (input_->textBeforeCursor() != before) return;  // Typed on.
  input_->complete(start, words);
  if (words.size() > 1) sayLine(words.join(QStringLiteral("  ")), Look::kPrinted);
}

void ConsolePanel::showState() {
  using State = ConsoleLink::State;
  QString text;
  switch (link_.state()) {
    case State::kOff:
      break;
    case State::kStarting:
      text = tr("Python starts…");
      break;
    case State::kReady:
      text = tr("Python %1, ready").arg(link_.version());
      break;
    case State::kRunning:
      text = tr("Running…");
      break;
    case State::kMissing:
      text = tr("No Python");
      break;
  }
  state_->setText(text);
  interrupt_->setEnabled(link_.state() == State::kRunning);
}

void ConsolePanel::fillScripts() {
  scripts_->clear();
  const QDir folder(scriptFolder());
  for (const QString& name : scriptNames())
    connect(scripts_->addAction(name), &QAction::triggered, this, [this, file = folder.filePath(name)] { runScript(file); });
  if (!scripts_->isEmpty()) scripts_->addSeparator();
  connect(scripts_->addAction(tr("Run a script…")), &QAction::triggered, this, &ConsolePanel::chooseScript);
  QAction* last = scripts_->addAction(tr("Last actions as a script"));
  last->setObjectName(QStringLiteral("actionConsoleLastActions"));
  last->setEnabled(recorder_.count() > 0);
  connect(last, &QAction::triggered, this, [this] {
    keepScript(recorder_.mark() - std::min(recorder_.count(), kLastActions));
  });
  connect(scripts_->addAction(tr("Open the folder of scripts")), &QAction::triggered, this, [this] {
    const auto made = config::makeOwnFolder(scriptFolder().toStdString());
    if (!made) return sayLine(shownText(made.error()), Look::kError);
    if (!openWithSystem(scriptFolder())) sayLine(tr("The scripts are in %1.").arg(scriptFolder()), Look::kPrinted);
  });
}

void ConsolePanel::toggleRecording(bool on) {
  record_->setText(on ? tr("Stop recording") : tr("Record actions"));
  if (on) {
    recording_ = recorder_.mark();
  } else if (recording_) {
    keepScript(*std::exchange(recording_, std::nullopt));
  }
}

void ConsolePanel::keepScript(std::size_t mark) {
  const std::size_t count = recorder_.countSince(mark);
  if (count == 0) return sayLine(tr("Nothing was changed in the cell, so there is no script."), Look::kPrinted);
  const QString name = QStringLiteral("actions-") + QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd-HHmm"));
  const auto written = writeScript(name, recorder_.scriptSince(mark));
  if (!written) return sayLine(shownText(written.error()), Look::kError);
  sayLine(tr("%n action(s) written as a script: %1", nullptr, static_cast<int>(count)).arg(*written), Look::kPrinted);
}

void ConsolePanel::chooseScript() {
  const QString file = askToOpen(this, tr("Run a script"), scriptFolder(), tr("Python (*.py);;All files (*)"));
  if (!file.isEmpty()) runScript(file);
}

void ConsolePanel::sayLine(const QString& text, Look look) {
  say(text + QLatin1Char('\n'), look);
}

void ConsolePanel::say(const QString& text, Look look) {
  if (!unshown_.isEmpty() && unshown_.back().second == look) {
    unshown_.back().first += text;
  } else {
    unshown_.append({text, look});
  }
  if (!flush_.isActive()) flush_.start();
}

/// In one go; of much more than is kept only the end.
void ConsolePanel::flush() {
  const Theme& theme = themeOf(palette());
  QScrollBar* bar = output_->verticalScrollBar();
  const bool at_end = bar->value() >= bar->maximum();
  QTextCursor cursor(output_->document());
  cursor.movePosition(QTextCursor::End);
  cursor.beginEditBlock();
  for (auto& [text, look] : unshown_) {
    constexpr qsizetype kMost = 100 * kMostKeptLines;
    QTextCharFormat format;
    if (look == Look::kError) format.setForeground(theme.words.contact.isValid() ? theme.contact : theme.text1);
    if (look == Look::kTyped) format.setForeground(theme.text2);
    if (look == Look::kPrinted) format.setForeground(theme.text1);
    // One endless line would be laid out again and again.
    if (cursor.block().length() > kLongestLine) cursor.insertText(QStringLiteral("\n"));
    cursor.insertText(text.right(kMost), format);
  }
  cursor.endEditBlock();
  unshown_.clear();
  if (at_end) bar->setValue(bar->maximum());
}

}  // namespace hapticell::app
