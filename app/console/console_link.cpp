// SPDX-License-Identifier: Apache-2.0
#include "app/console/console_link.h"

#include <signal.h>
#include <sys/prctl.h>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcessEnvironment>
#include <filesystem>
#include <utility>

#include "config/user_folders.h"

namespace hapticell::app {

namespace {

/// Of the package, where this program was not installed: beside its folder.
QString packagesOfBuild() {
  const QString folder = QDir::cleanPath(QCoreApplication::applicationDirPath() + QStringLiteral("/../python"));
  return QFileInfo::exists(folder + QStringLiteral("/hapticell/_console.py")) ? folder : QString();
}

/// $HAPTICELL_PYTHON; else the system's own, which the package python3-hapticell is for, before others in $PATH.
std::filesystem::path interpreter() {
  const std::filesystem::path chosen = qgetenv("HAPTICELL_PYTHON").toStdString();
  if (!chosen.empty()) return chosen.is_absolute() && std::filesystem::exists(chosen) ? chosen : std::filesystem::path();
  const std::filesystem::path own = "/usr/bin/python3";
  return std::filesystem::exists(own) ? own : config::systemProgram("python3");
}

QString pathText(const std::filesystem::path& path) {
  return QString::fromStdString(path.string());
}

}  // namespace

ConsoleLink::ConsoleLink(QObject* parent) : QObject(parent) {
  connect(&process_, &QProcess::readyReadStandardOutput, this, &ConsoleLink::read);
  connect(&process_, &QProcess::readyReadStandardError, this, [this] {
    const QByteArray said = process_.readAllStandardError();
    constexpr qsizetype kMost = 1 << 16;  // Bytes: enough for any traceback. Half, twice: as well.
    if (state_ == State::kStarting) errors_ = (errors_ + said).right(kMost);
    else emit printed(QString::fromUtf8(said), true);
  });
  connect(&process_, &QProcess::finished, this, &ConsoleLink::end);
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) cannotStart(tr("Python cannot be started: %1").arg(process_.errorString()));
  });
  // It ends with the window, however that ends.
  process_.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGKILL); });
}

ConsoleLink::~ConsoleLink() {
  process_.disconnect(this);
  if (process_.state() == QProcess::NotRunning) return;
  process_.kill();
  constexpr int kPatience = 1000;  // ms: a killed process ends at once.
  process_.waitForFinished(kPatience);
}

void ConsoleLink::setState(State state) {
  state_ = state;
  emit stateChanged();
}

void ConsoleLink::start() {
  if (process_.state() != QProcess::NotRunning) return;
  const std::filesystem::path python = interpreter();
  if (python.empty())
    return cannotStart(tr("Python is not installed. Install the packages python3 and python3-hapticell."));
  line_.clear();
  errors_.clear();
  interrupted_ = killed_ = false;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  if (const QString own = packagesOfBuild(); !own.isEmpty()) {
    const QString others = environment.value(QStringLiteral("PYTHONPATH"));
    environment.insert(QStringLiteral("PYTHONPATH"), others.isEmpty() ? own : own + QLatin1Char(':') + others);
  }
  environment.insert(QStringLiteral("PYTHONIOENCODING"), QStringLiteral("utf-8"));
  process_.setProcessEnvironment(environment);
  process_.setWorkingDirectory(QDir::homePath());
  setState(State::kStarting);
  // -P: nothing is imported from the working folder, which may be a stranger's.
  process_.start(pathText(python), {QStringLiteral("-P"), QStringLiteral("-m"), QStringLiteral("hapticell._console")});
}

void ConsoleLink::cannotStart(const QString& sentence) {
  setState(State::kMissing);
  emit failed(sentence);
}

void ConsoleLink::send(QJsonObject message) {
  message.insert(QStringLiteral("id"), ++number_);
  process_.write(QJsonDocument(message).toJson(QJsonDocument::Compact) + '\n');
}

void ConsoleLink::sendWork(QJsonObject message, const std::optional<CellText>& cell, const QStringList& selection) {
  message.insert(QStringLiteral("selection"), QJsonArray::fromStringList(selection));
  if (cell) {
    message.insert(QStringLiteral("cell"), QJsonObject{{QStringLiteral("text"), QString::fromStdString(cell->text)},
                                                       {QStringLiteral("folder"), pathText(cell->folder)},
                                                       {QStringLiteral("path"), pathText(cell->document)}});
  }
  interrupted_ = false;
  setState(State::kRunning);
  send(std::move(message));
}

void ConsoleLink::run(const QString& source, const std::optional<CellText>& cell, const QStringList& selection) {
  sendWork({{QStringLiteral("do"), QStringLiteral("run")}, {QStringLiteral("source"), source}}, cell, selection);
}

void ConsoleLink::runScript(const QString& file, const std::optional<CellText>& cell, const QStringList& selection) {
  sendWork({{QStringLiteral("do"), QStringLiteral("script")}, {QStringLiteral("file"), file}}, cell, selection);
}

void ConsoleLink::complete(const QString& text) {
  if (state_ != State::kReady) return;
  completing_ = text;
  send({{QStringLiteral("do"), QStringLiteral("complete")}, {QStringLiteral("text"), text}});
}

void ConsoleLink::interrupt() {
  if (state_ != State::kRunning) return;
  if (std::exchange(interrupted_, true)) {
    killed_ = true;
    process_.kill();
    return;
  }
  ::kill(static_cast<pid_t>(process_.processId()), SIGINT);
}

void ConsoleLink::read() {
  line_ += process_.readAllStandardOutput();
  qsizetype begin = 0;
  for (qsizetype end = line_.indexOf('\n'); end >= 0; begin = end + 1, end = line_.indexOf('\n', begin))
    hear(QJsonDocument::fromJson(line_.mid(begin, end - begin)).object());
  line_.remove(0, begin);
}

void ConsoleLink::hear(const QJsonObject& message) {
  const QString say = message.value(QStringLiteral("say")).toString();
  const QString text = message.value(QStringLiteral("text")).toString();
  if (say == QLatin1String("out") || say == QLatin1String("err")) {
    emit printed(text, say == QLatin1String("err"));
  } else if (say == QLatin1String("ready")) {
    version_ = message.value(QStringLiteral("version")).toString();
    setState(State::kReady);
  } else if (say == QLatin1String("words")) {
    QStringList words;
    for (const QJsonValue& word : message.value(QStringLiteral("words")).toArray()) words << word.toString();
    emit completed(completing_, message.value(QStringLiteral("start")).toInt(), words);
  } else if (say == QLatin1String("begin")) {
    emit begun();
  } else if (say == QLatin1String("more")) {
    setState(State::kReady);
    emit moreWanted();
  } else if (say == QLatin1String("done")) {
    const QJsonObject cell = message.value(QStringLiteral("cell")).toObject();
    std::optional<std::string> changed;
    if (!cell.isEmpty()) changed = cell.value(QStringLiteral("text")).toString().toStdString();
    setState(State::kReady);
    emit finished(changed, cell.value(QStringLiteral("step")).toString());
  }
}

void ConsoleLink::end(int code, QProcess::ExitStatus status) {
  read();
  if (state_ == State::kMissing) return;
  if (state_ == State::kStarting) {
    const QString said = QString::fromUtf8(errors_).trimmed().section(QLatin1Char('\n'), -1);
    return cannotStart(tr("The Python package of HaptiCell cannot be used: %1. Install the package python3-hapticell.")
                           .arg(said.isEmpty() ? tr("exit status %1").arg(code) : said));
  }
  QString why = tr("The interpreter ended (exit status %1).").arg(code);
  if (killed_) why = tr("The interpreter was ended, because what ran did not heed the interrupt.");
  else if (status == QProcess::CrashExit) why = tr("The interpreter crashed.");
  setState(State::kOff);
  emit ended(why + QLatin1Char(' ') + tr("The cell is as it was; names that you had set are gone. A new one starts."));
  start();
}

}  // namespace hapticell::app
