// SPDX-License-Identifier: Apache-2.0
// hapticell: the window.
#include <QApplication>
#include <QCommandLineParser>
#include <QDebug>
#include <QElapsedTimer>
#include <QScreen>
#include <QSurfaceFormat>
#include <QThreadPool>
#include <QTimer>
#include <algorithm>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/host/language.h"
#include "app/import/file_work.h"
#include "app/kit/written_file.h"
#include "app/settings/user_choices.h"
#include "app/shell/application.h"
#include "app/shell/end_signals.h"
#include "app/shell/file_opening.h"
#include "app/shell/main_window.h"
#include "app/start/recent_files.h"
#include "app/style/fonts.h"
#include "app/style/library_text.h"
#include "app/style/plain_lines.h"
#include "app/style/proxy_style.h"
#include "app/viewport/drawing/graphics_probe.h"
#include "app/views/render_command.h"
#include "config/configuration.h"
#include "config/log_level.h"
#include "config/program_version.h"
#include "config/user_folders.h"

namespace {

using hapticell::app::MainWindow;

struct Options {
  QString file, screenshot, theme, configuration;
  std::optional<hapticell::app::RenderCommand> render;
  QSize size{1600, 900};
  bool sized = false;  ///< The size was asked for.
  int delay_ms = 1500;
  QString language;
  hapticell::config::LogLevel log_level = hapticell::config::LogLevel::kInfo;
  bool exit = false, module = true, measure = false, measure_start = false, probe = false;
};

constexpr int kBadUsage = 2;
constexpr int kLargestSide = 16384;  // Pixels, of a picture.

/// "1920x1080"; nothing for anything else.
std::optional<QSize> sizeFrom(const QString& text) {
  const QStringList sides = text.split('x');
  if (sides.size() != 2) return std::nullopt;
  bool wide = false, high = false;
  const QSize size(sides[0].toInt(&wide), sides[1].toInt(&high));
  const bool fits = wide && high && !size.isEmpty() && size.width() <= kLargestSide && size.height() <= kLargestSide;
  return fits ? std::optional(size) : std::nullopt;
}

/// Options that cannot be meant end the program with a sentence.
[[noreturn]] void refuse(const QString& sentence) {
  qCritical().noquote() << sentence;
  std::exit(kBadUsage);
}

void addOptions(QCommandLineParser& parser) {
  parser.setApplicationDescription("Move solids and robots in a CAD workcell, and feel the contacts.");
  parser.addHelpOption();
  parser.addPositionalArgument(
      "file",
      "Workcell (*.hcell), exercise (*.hexercise), training results (*.htrain), study (*.hstudy), its results "
      "(*.hresults), motion (*.htraj) or recording (*.mcap) to open, or a CAD file, mesh or robot to import into a new "
      "cell. Default: the start page, or the cell opened last.",
      "[file]");
  parser.addOptions(
      {{"screenshot", "Save a picture of the window when it has finished drawing.", "file.png"},
       {"exit", "Quit after the screenshot."},
       {"delay", "Wait this long before the screenshot.", "ms", "1500"},
       {"measure-frames", "Print the median frame time at each level of detail, then quit."},
       {"measure-start",
        "Print the times to the first picture and to the loaded cell and the longest wait for a click, then quit."},
       {"theme", "Theme: dark or light.", "name"},
       {"language", "Language: en or fr.", "code"},
       {"size", "Size of the window or of the picture, in pixels.", "WIDTHxHEIGHT"},
       {"render", "Draw this cell or file to the picture or video named by -o, without a window.", "file"},
       {{"o", "output"}, "Picture or video that --render writes.", "file"},
       {"view", "For --render: front, back, right, left, top, bottom, iso or saved.", "name", "iso"},
       {"seconds", "For --render to a video (mp4, webm, mkv, gif): duration of one turn.", "s", "8"},
       {"no-floor", "For --render: do not draw the floor grid."},
       {"config", "hapticell.toml whose values override the shipped ones.", "file"},
       {"log-level", "What the log file holds: error, warning, info or debug.", "level", "info"},
       {"no-module", "Do not start Virtual Desktop automatically."},
       {"probe-graphics", "Print the OpenGL of the display as JSON, then quit (for hapticell-cli doctor)."},
       {{"v", "version"}, "Print version, commit, compiler and libraries, then quit."}});
}

/// Version, commit, compiler and libraries.
std::string programText() {
  return hapticell::config::versionText("hapticell", {{"Qt", qVersion()}});
}

/// --help and --version, which need no display. False for everything else.
bool answersWithoutDisplay(int argc, char** argv) {
  const std::vector<std::string_view> words(argv + 1, argv + argc);
  const auto given = [&](std::string_view name) { return std::find(words.begin(), words.end(), name) != words.end(); };
  const bool version = given("--version") || given("-v");
  if (!version && !given("--help") && !given("-h")) return false;
  QCoreApplication application(argc, argv);
  QCommandLineParser parser;
  addOptions(parser);
  const std::string text = version ? programText() + "\n" : parser.helpText().toStdString();
  std::fputs(text.c_str(), stdout);
  return true;
}

Options parse() {
  QCommandLineParser parser;
  addOptions(parser);
  if (!parser.parse(QCoreApplication::arguments())) refuse(parser.errorText() + ". See hapticell --help.");
  Options options;
  if (!parser.positionalArguments().isEmpty()) options.file = parser.positionalArguments().first();
  options.screenshot = parser.value("screenshot");
  options.theme = parser.value("theme");
  options.language = parser.value("language");
  options.configuration = parser.value("config");
  options.exit = parser.isSet("exit");
  options.measure = parser.isSet("measure-frames");
  options.measure_start = parser.isSet("measure-start");
  options.probe = parser.isSet("probe-graphics");
  options.module = !parser.isSet("no-module");
  options.delay_ms = qBound(0, parser.value("delay").toInt(), 600000);
  const auto level = hapticell::config::logLevelFrom(parser.value("log-level").toStdString());
  if (!level) refuse(QString::fromStdString(level.error().message()));
  options.log_level = *level;
  const auto size = sizeFrom(parser.value("size"));
  if (parser.isSet("size") && !size)
    refuse(QString("--size: '%1' is not a size. Enter WIDTHxHEIGHT, each from 1 to %2 pixels.")
               .arg(parser.value("size"))
               .arg(kLargestSide));
  if (size && size->width() >= 640 && size->height() >= 400) options.size = *size, options.sized = true;
  if (parser.isSet("render")) {
    auto& render = options.render.emplace();
    render.input = parser.value("render");
    render.output = parser.value("output");
    render.view = parser.value("view");
    if (size) render.size = *size;
    render.light = options.theme == "light";
    render.seconds = qBound(0.04, parser.value("seconds").toDouble(), 600.0);
    render.floor = !parser.isSet("no-floor");
  }
  return options;
}

int renderPicture(const hapticell::app::RenderCommand& command) {
  if (command.output.isEmpty()) {
    qCritical("--render needs an output file: hapticell --render cell.hcell -o picture.png");
    return 2;
  }
  hapticell::Diagnostics diagnostics;
  const auto done = hapticell::app::render(command, diagnostics);
  for (const hapticell::Text& warning : diagnostics.warnings)
    qWarning().noquote() << hapticell::app::plainLines(hapticell::app::shownText(warning));
  if (!done) qCritical().noquote() << hapticell::app::shownText(done.error());
  return done ? 0 : 2;
}

/// Where the screen has no room for the window and its frame, the window fills it: the status line would lie below its edge.
void showAtStart(MainWindow& window, const Options& options) {
  constexpr QSize kFrame(4, 40);  // Pixels; a title bar of the usual desktops is lower.
  const QSize room = window.screen()->availableSize() - kFrame;
  window.resize(options.size);
  if (options.sized || options.size.boundedTo(room) == options.size) return window.show();
  window.resize(options.size.boundedTo(room));  // What it has once it is no longer maximized.
  window.showMaximized();
}

void openAtStart(MainWindow& window, const QString& wanted, bool first_page) {
  if (!wanted.isEmpty()) {
    hapticell::app::openAny(window, wanted);
    return window.files().reportUnsavedCopies({});
  }
  if (first_page || !window.files().leftWork().empty()) return window.showStartPage();
  const QStringList recent = window.recentFiles().files();
  const auto demo = hapticell::config::findShippedFile("workcells/demo.hcell");
  if (!recent.isEmpty())
    window.openFile(recent.front());
  else if (demo)
    window.openFile(QString::fromStdString(*demo));
}

/// Acts once nothing is being read any more and `delay_ms` passed since.
void whenRead(MainWindow& window, int delay_ms, const std::function<void()>& act) {
  // ms between two looks whether reading ended, for pictures from the command line. Half, twice: ends at most so much
  // later.
  constexpr int kLook = 50;
  if (window.files().isBusy()) {
    QTimer::singleShot(kLook, &window, [&window, delay_ms, act] { whenRead(window, delay_ms, act); });
  } else {
    QTimer::singleShot(delay_ms, &window, act);
  }
}

/// Acts once no work beside the window is under way (skins of figures, advice, checks at rest) and what it gave is
/// drawn, or half a minute has passed.
void whenDone(MainWindow& window, const std::function<void()>& act) {
  // ms: looks; at most; without work until what it gave is drawn. Half of 600: a picture may lack a skin; twice: each
  // picture takes longer.
  constexpr int kLook = 100, kAtMost = 30000, kDrawn = 600;
  auto* look = new QTimer(&window);
  QObject::connect(look, &QTimer::timeout, &window, [look, act, waited = 0, rested = 0]() mutable {
    rested = QThreadPool::globalInstance()->activeThreadCount() > 0 ? 0 : rested + kLook;
    if (rested < kDrawn && (waited += kLook) < kAtMost) return;
    look->deleteLater();
    look->stop();
    act();
  });
  look->start(kLook);
}

void printFrameTimes(MainWindow& window) {
  const char* const names[]{"full", "no occlusion", "plain", "no edges", "half size", "coarse"};
  const std::vector<double> medians = window.viewport().measureFrames(9);
  for (std::size_t i = 0; i < medians.size(); ++i) std::printf("%-14s %7.1f ms\n", names[i], 1000.0 * medians[i]);
}

/// ms of processor time of this thread.
double threadWork() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Between two turns of the window's loop, since the last print.
class LongestWait {
 public:
  void add(qint64 now, double work) {
    if (last_ >= 0 && now - last_ > longest_) longest_ = now - last_, its_work_ = work - last_work_;
    if (last_ >= 0) work_ = std::max(work_, work - last_work_);
    last_ = now;
    last_work_ = work;
  }
  void print(const char* when) {
    std::printf("%-16s %6lld ms, %4.0f ms of it the thread's own work, of which %4.0f ms at most at a stretch%s\n",
                "longest wait", static_cast<long long>(longest_), its_work_, work_, when);
    longest_ = 0;
    work_ = 0.0;
  }
  /// Nobody waited for what was before there was a window to click at.
  void forget() { *this = {}; }

 private:
  qint64 last_ = -1, longest_ = 0;
  double last_work_ = 0.0, its_work_ = 0.0, work_ = 0.0;
};

/// Tells when the window was first drawn, when its cell was read and drawn, and how long it ever kept a click waiting
/// until the delay is over: by the clock, and by this process's own work, which other programs do not lengthen.
void measureStart(MainWindow& window, const QElapsedTimer& clock, int delay_ms) {
  const auto tell = [clock](const char* what) {
    std::printf("%-16s %6lld ms, %6.0f ms of work\n", what, static_cast<long long>(clock.elapsed()),
                1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC);
  };
  auto longest = std::make_shared<LongestWait>();
  auto* first = new QObject(&window);
  QObject::connect(
      &window.viewport(), &QOpenGLWidget::frameSwapped, first,
      [tell, first, longest] {
        tell("first picture");
        longest->forget();
        first->deleteLater();
      },
      Qt::SingleShotConnection);
  auto* beat = new QTimer(&window);
  QObject::connect(beat, &QTimer::timeout, beat, [clock, longest] { longest->add(clock.elapsed(), threadWork()); });
  beat->start(1);
  whenRead(window, 0, [&window, tell, longest, delay_ms] {
    tell("cell is read");
    longest->print(" while it was read");
    QTimer::singleShot(delay_ms, &window, [longest] {
      longest->print("");
      QApplication::quit();
    });
  });
}

bool hasDisplay() {
#ifdef Q_OS_LINUX
  return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
         qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
#else
  return true;
#endif
}

}  // namespace

int main(int argc, char** argv) {
  QElapsedTimer since_start;
  since_start.start();
  for (const hapticell::Text& sentence : hapticell::config::cleanEnvironment())
    qWarning().noquote() << QString::fromStdString(hapticell::english(sentence));
  if (answersWithoutDisplay(argc, argv)) return 0;
  if (!hasDisplay()) {
    qCritical("No display found. Start hapticell on a desktop, or under xvfb-run.");
    return 2;
  }
  hapticell::app::Application application(argc, argv);
  // Qt has taken the user's locale for the C library too: "%g" would write 0,5 for 0.5, also into files.
  std::setlocale(LC_NUMERIC, "C");
  QApplication::setApplicationName("hapticell");
  QApplication::setApplicationDisplayName("HaptiCell");
  QApplication::setApplicationVersion(HAPTICELL_VERSION);
  QApplication::setDesktopFileName("hapticell");  // By which a desktop finds name and icon of the window.
  const Options options = parse();
  if (options.probe) return std::puts(hapticell::app::probeGraphics().constData()) < 0 ? 2 : 0;
  if (options.render) return renderPicture(*options.render);
  QApplication::setStyle(new hapticell::app::ProxyStyle);
  QApplication::setFont(hapticell::app::textFont(hapticell::app::TextRole::kText));
  auto configuration = hapticell::config::loadConfiguration(options.configuration.toStdString());
  if (!configuration) {
    qCritical().noquote() << hapticell::app::shownText(configuration.error());
    return 2;
  }
  if (!options.theme.isEmpty()) configuration->gui.theme = options.theme == "light" ? "light" : "dark";
  // Pictures show the program as it is shipped.
  const bool remembers = options.screenshot.isEmpty() && !options.measure && !options.measure_start;
  const QString settings = remembers ? hapticell::app::UserSettings::defaultFile() : QString();
  if (const auto own = hapticell::config::checkUserFile(settings.toStdString()); remembers && !own) {
    qCritical().noquote() << hapticell::app::shownText(own.error());
    return 2;
  }
  if (remembers || !options.language.isEmpty())
    hapticell::app::installLanguage(options.language.isEmpty()
                                        ? hapticell::app::languageFrom(hapticell::app::UserSettings(settings))
                                        : options.language);
  const hapticell::app::EndSignals end;  // Before anything is started that must not be left behind.
  MainWindow window(*configuration, settings);
  if (!options.theme.isEmpty()) window.setTheme(options.theme != "light");
  if (remembers) {
    window.keepLog(options.log_level, programText());
    window.guardAgainstCrash(programText());
  }
  showAtStart(window, options);
  openAtStart(window, options.file, remembers && window.userSettings().value("start/page", true).toBool());
  window.loadModules(hapticell::app::ModuleLoader::defaultFolders());
  if (options.module) window.startModule("Virtual Desktop");
  window.restoreLayout();
  QObject::connect(&end, &hapticell::app::EndSignals::asked, &window, &MainWindow::endNow);
  QObject::connect(&application, &hapticell::app::Application::outOfMemory, &window,
                   [&window] { hapticell::app::reportOutOfMemory(window); });
  int status = 0;
  if (!options.screenshot.isEmpty()) {
    const auto save = [&] {
      if (const auto written = hapticell::app::writePicture(window.picture().toImage(), options.screenshot); !written) {
        qCritical().noquote() << hapticell::app::shownText(written.error());
        status = 2;
      }
      if (options.exit) QApplication::exit(status);
    };
    whenRead(window, options.delay_ms, [&window, save] { whenDone(window, save); });
  }
  if (options.measure) {
    whenRead(window, options.delay_ms, [&window] {
      printFrameTimes(window);
      QApplication::quit();
    });
  }
  if (options.measure_start) measureStart(window, since_start, options.delay_ms);
  const int ended = QApplication::exec();
  return status != 0 ? status : ended;
}
