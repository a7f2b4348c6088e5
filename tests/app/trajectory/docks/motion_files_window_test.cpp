// SPDX-License-Identifier: Apache-2.0
// Motions into files and out of them: by the window's own dialogs, as programs, as a video.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QStandardPaths>

#include "app/shell/file_opening.h"
#include "app/trajectory/motions/play_video.h"
#include "config/configuration.h"
#include "exchange/recordings/recording_reader.h"
#include "exchange/recordings/recording_writer.h"
#include "manipulation/checks/motion_replay.h"
#include "tests/app/pages/motion_page.h"
#include "workcell/text/file_content.h"

namespace hapticell::app {
namespace {

using trajectory::Trajectory;

TEST(TrajectoryDock, ExportsAndReadsBack) {
  MotionPage page;
  ASSERT_TRUE(page.import({{0, {0.1, 0.2, 0.3}}, {1, {0.2, 0.2, 0.3}}, {2.5, {0.4, 0.1, 0.3}}}, "out"));
  auto* files = page.window().findChild<MotionExport*>();
  for (const char* format : {"csv", "json", "urscript", "val3"}) {
    const QString path = page.folder().filePath(QStringLiteral("x.") + (QString(format) == "json" ? "htraj" : format));
    std::optional<bool> done;
    const auto connection =
        QObject::connect(files, &MotionExport::finished, [&](const QString&, bool ok) { done = ok; });
    files->exportTo(path, format, {});
    ASSERT_TRUE(MotionPage::until([&] { return done.has_value(); }, MotionPage::kPatience)) << format;
    QObject::disconnect(connection);
    EXPECT_TRUE(*done) << format;
    EXPECT_TRUE(QFile::exists(path)) << format;
  }
  const auto again = trajectory::readTrajectory(page.folder().filePath("x.csv").toStdString());
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(trajectory::toCsvText(*again), trajectory::toCsvText(page.newest())) << "bit for bit";
}

TEST(TrajectoryDock, AnOpenedRecordingGivesAllItsMotions) {
  MotionPage page;
  exchange::Recording recording;
  for (const char* const entity : {"box", "wall"}) {
    Trajectory motion;
    motion.name = std::string("way of ") + entity;
    motion.entity = entity;
    for (int i = 0; i < 5; ++i) motion.addFrame({0.25 * i, Pose::translation({0.1 * i, 1.0 / 3.0, 0.0})});
    recording.motions.push_back(motion);
  }
  recording.contacts = {{0.2, 0.3, "box", "wall", 7.5}};
  const QString path = page.folder().filePath("session.mcap");
  ASSERT_TRUE(exchange::writeMcapRecording(recording, path.toStdString()));
  openAny(page.window(), path);  // As a dropped file and one of the command line.
  ASSERT_TRUE(MotionPage::until([&] { return page.motions() == 2 && page.isIdle(); }, MotionPage::kPatience));
  const auto read = exchange::readMcapMotion(path.toStdString());  // As the command line reads it.
  ASSERT_TRUE(read);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& motion = page.state().trajectories[i].motion;
    ASSERT_TRUE(motion);
    EXPECT_EQ(trajectory::toJsonText(*motion), trajectory::toJsonText(recording.motions[i])) << i;
  }
  EXPECT_EQ(trajectory::toJsonText(*page.state().trajectories[0].motion), trajectory::toJsonText(*read));
  EXPECT_EQ(page.rows().size(), 2u);
  const auto& messages = page.window().messages().messages();
  EXPECT_TRUE(std::any_of(messages.begin(), messages.end(), [](const Message& message) {
    return message.text == "session.mcap: contacts of the session, not read: 1";
  }));
}

TEST(TrajectoryDock, ADamagedRecordingIsRefused) {
  MotionPage page;
  const QString path = page.folder().filePath("broken.mcap");
  ASSERT_TRUE(workcell::writeFileAtomically(path.toStdString(), std::string("\x89MCAP0\r\nnothing")).has_value());
  std::optional<bool> done;
  auto* files = page.window().findChild<MotionExport*>();
  QObject::connect(files, &MotionExport::finished, &page.window(), [&](const QString&, bool ok) { done = ok; });
  page.answerFileDialog(path);
  page.trigger("actionOpen");
  ASSERT_TRUE(MotionPage::until([&] { return done.has_value(); }, MotionPage::kPatience));
  EXPECT_FALSE(*done);
  EXPECT_EQ(page.motions(), 0u);
  EXPECT_EQ(page.window().messages().messages().back().title, "The motion was not imported");
}

TEST(TrajectoryDock, AProgramOfManyMovesIsOfferedSimplified) {
  MotionPage page;
  std::vector<std::pair<double, dvec3>> points;
  for (int i = 0; i <= 600; ++i) points.emplace_back(0.01 * i, dvec3(0.0005 * i, 0.0, 0.0));
  ASSERT_TRUE(page.import(points, "long"));
  std::optional<bool> done;
  QObject::connect(page.window().findChild<MotionExport*>(), &MotionExport::finished, &page.window(),
                   [&](const QString&, bool ok) { done = ok; });
  QString asked;
  auto* timer = new QTimer(&page.window());
  QObject::connect(timer, &QTimer::timeout, &page.window(), [timer, &asked] {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!question) return;
    timer->deleteLater();
    asked = question->text();
    question->defaultButton()->click();
  });
  timer->start(10);
  const QString path = page.folder().filePath("long.src");
  page.answerFileDialog(path);
  page.press("buttonExport");
  ASSERT_TRUE(MotionPage::until([&] { return done.has_value(); }, MotionPage::kPatience));
  EXPECT_TRUE(*done);
  EXPECT_EQ(asked, "The program would have 601 moves.");
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const qsizetype moves = file.readAll().count("LIN ");
  EXPECT_GT(moves, 0);
  EXPECT_LT(moves, 20) << "a straight line";
  EXPECT_EQ(page.newest().size(), 601u) << "the motion itself is as it was";
}

/// A robot's motion through the panel's own dialog into each of the nine formats.
TEST(TrajectoryDock, TheExportDialogWritesEveryFormat) {
  MotionPage page;
  const auto file = config::findShippedFile("robots/hc6/robot.urdf");
  ASSERT_TRUE(file.has_value());
  ASSERT_TRUE(page.add(QString::fromStdString(*file)));
  const workcell::Entity& robot = *page.state().entities.back();
  ASSERT_TRUE(robot.robot());
  Trajectory given;
  given.entity = robot.name;
  given.moved = "tcp";
  for (const int joint : robot.robot()->moving)
    given.joint_names.push_back(robot.robot()->joints[static_cast<std::size_t>(joint)].name);
  for (int i = 0; i <= 10; ++i) {
    const std::vector<double> joints{0.05 * i, 0.3, 0.4 - 0.02 * i, 0.1, 0.9, 0.01 * i};
    ASSERT_EQ(joints.size(), given.joint_names.size());
    ASSERT_TRUE(given.addFrame({0.1 * i, {}, i == 5}, joints));
  }
  const auto posed = manipulation::posesFromJoints(robot, given);
  ASSERT_TRUE(posed.has_value()) << posed.error().message();
  const QString source = page.folder().filePath("robot.htraj");
  ASSERT_TRUE(workcell::writeFileAtomically(source.toStdString(), trajectory::toJsonText(*posed)).has_value());
  auto* files = page.window().findChild<MotionExport*>();
  files->importFrom({source}, robot.name);
  ASSERT_TRUE(MotionPage::until([&] { return page.motions() == 1 && page.isIdle(); }, MotionPage::kPatience));
  std::optional<bool> done;
  QObject::connect(files, &MotionExport::finished, &page.window(), [&](const QString&, bool ok) { done = ok; });
  auto* formats = page.find<QComboBox>("comboMotionFormat");
  ASSERT_EQ(formats->count(), 9);
  const std::map<QString, QString> written{{"krl", "out.src"},         {"rapid", "out.mod"},      {"fanuc", "out.ls"},
                                           {"urscript", "out.script"}, {"val3", "val/start.pgx"}, {"ros", "out.yaml"},
                                           {"inform", "out.jbi"},
                                           {"csv", "out.csv"},         {"json", "out.htraj"}};
  for (int i = 0; i < formats->count(); ++i) {
    formats->setCurrentIndex(i);
    const QString word = formats->currentData().toString();
    ASSERT_TRUE(written.contains(word)) << word.toStdString();
    const QString& name = written.at(word);
    done.reset();
    page.answerFileDialog(page.folder().filePath(word == "val3" ? QStringLiteral("val") : name));
    page.press("buttonExport");
    ASSERT_TRUE(MotionPage::until([&] { return done.has_value(); }, MotionPage::kPatience)) << word.toStdString();
    EXPECT_TRUE(*done) << word.toStdString();
    QFile file_written(page.folder().filePath(name));
    ASSERT_TRUE(file_written.open(QIODevice::ReadOnly)) << name.toStdString();
    const QByteArray text = file_written.readAll();
    EXPECT_GT(text.size(), 100) << name.toStdString();
    if (word != "ros" && word != "csv" && word != "json") {
      EXPECT_TRUE(text.toLower().contains("safety")) << word.toStdString();
    }
  }
  EXPECT_TRUE(QFile::exists(page.folder().filePath("out.dat")));
  const auto again = trajectory::readTrajectory(page.folder().filePath("out.htraj").toStdString());
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->size(), 11u);
  // Programs are imported by the same action as other motions.
  for (const char* program : {"out.src", "out.mod", "out.ls", "out.script"}) {
    const std::size_t before = page.motions();
    files->importFrom({page.folder().filePath(program)}, robot.name);
    ASSERT_TRUE(MotionPage::until([&] { return page.motions() == before + 1 && page.isIdle(); }, MotionPage::kPatience))
        << program;
    EXPECT_EQ(page.newest().size(), 11u) << program;
  }
}

TEST(TrajectoryDock, AVideoOfThePlayIsWritten) {
  if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) GTEST_SKIP() << "no ffmpeg here";
  MotionPage page;
  ASSERT_TRUE(page.import({{0.0, {0, 0, 0}}, {0.4, {0.2, 0, 0.1}}}, "short"));
  auto* video = page.window().findChild<PlayVideo*>();
  ASSERT_NE(video, nullptr);
  const QString file = page.folder().filePath("play.mkv");
  std::optional<QString> problem;
  QObject::connect(video, &PlayVideo::ended, &page.window(),
                   [&problem](const QString&, const QString& what) { problem = what; });
  const auto begun = video->start(file, {320, 180});
  ASSERT_TRUE(begun) << begun.error().message();
  EXPECT_TRUE(video->isBusy());
  ASSERT_TRUE(MotionPage::until([&] { return problem.has_value(); }, 120000));
  EXPECT_EQ(*problem, "");
  // Read back by ffmpeg itself: as many pictures as the motion is long, of that size, and the box moves in them.
  QProcess reader;
  reader.start("ffmpeg", {"-v", "error", "-i", file, "-f", "rawvideo", "-pix_fmt", "gray", "-"});
  ASSERT_TRUE(reader.waitForFinished(120000));
  const QByteArray pictures = reader.readAllStandardOutput();
  constexpr qsizetype kPicture = 320 * 180;
  EXPECT_EQ(pictures.size(), 11 * kPicture) << reader.readAllStandardError().toStdString();
  ASSERT_GE(pictures.size(), 2 * kPicture);
  EXPECT_NE(pictures.first(kPicture), pictures.last(kPicture));
  EXPECT_FALSE(page.shownBox().p.x > 0.3) << "the window's own scene goes on";
}

}  // namespace
}  // namespace hapticell::app
