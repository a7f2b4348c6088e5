// SPDX-License-Identifier: Apache-2.0
// Pictures without a window: what `hapticell --render` does. Needs a display (xvfb-run), as the window's tests do.
#include "app/views/render_command.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QTemporaryDir>

namespace hapticell::app {
namespace {

RenderCommand boxTo(const QString& output) {
  RenderCommand command;
  command.input = "box:0.4,0.2,0.1";
  command.output = output;
  command.size = {320, 200};
  command.floor = false;
  return command;
}

/// The box of all pixels that differ from the background, which is one colour a row.
QRect drawnArea(const QImage& picture) {
  QRect area;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (qAbs(qGray(picture.pixel(x, y)) - qGray(picture.pixel(0, y))) > 12) area |= QRect(x, y, 1, 1);
  return area;
}

TEST(RenderCommand, DrawsTheSizeAskedForWithThePartFilledIn) {
  QTemporaryDir folder;
  Diagnostics diagnostics;
  RenderCommand command = boxTo(folder.filePath("front.png"));
  command.view = "front";
  ASSERT_TRUE(render(command, diagnostics));
  const QImage picture(command.output);
  ASSERT_EQ(picture.size(), command.size);
  const QRect area = drawnArea(picture);
  // From the front the box is 0.4 wide and 0.1 high; a margin of 12 % is left at the sides.
  EXPECT_NEAR(area.width(), 320 / 1.12, 6);
  EXPECT_NEAR(static_cast<double>(area.width()) / area.height(), 4.0, 0.6);
  EXPECT_NEAR(area.center().x(), 160, 3);
  EXPECT_NEAR(area.center().y(), 100, 3);
}

TEST(RenderCommand, EachViewAndThemeIsAnotherPicture) {
  QTemporaryDir folder;
  Diagnostics diagnostics;
  std::vector<QImage> pictures;
  for (const char* view : {"front", "right", "top", "iso"}) {
    RenderCommand command = boxTo(folder.filePath(QString(view) + ".png"));
    command.view = view;
    ASSERT_TRUE(render(command, diagnostics));
    pictures.emplace_back(command.output);
  }
  RenderCommand light = boxTo(folder.filePath("light.png"));
  light.light = true;
  ASSERT_TRUE(render(light, diagnostics));
  pictures.emplace_back(light.output);
  for (std::size_t i = 0; i < pictures.size(); ++i)
    for (std::size_t j = i + 1; j < pictures.size(); ++j) EXPECT_NE(pictures[i], pictures[j]) << i << " and " << j;
}

TEST(RenderCommand, TellsWhatItCannotDoAndLeavesNoFile) {
  QTemporaryDir folder;
  Diagnostics diagnostics;
  const auto refusal = [&](RenderCommand command) {
    const auto done = render(command, diagnostics);
    EXPECT_FALSE(QFile::exists(command.output)) << command.output.toStdString();
    return done ? std::string("nothing") : done.error().message();
  };
  RenderCommand sideways = boxTo(folder.filePath("a.png"));
  sideways.view = "sideways";
  EXPECT_NE(refusal(sideways).find("'sideways'"), std::string::npos);
  EXPECT_NE(refusal(boxTo(folder.filePath("a.docx"))).find("a.docx"), std::string::npos);
  EXPECT_NE(refusal(boxTo(folder.filePath("no/such/folder/a.png"))).find("folder"), std::string::npos);
  RenderCommand missing = boxTo(folder.filePath("a.png"));
  missing.input = "nowhere.hcell";
  EXPECT_NE(refusal(missing).find("nowhere.hcell"), std::string::npos);
}

/// A program that stands in for ffmpeg: it writes how many bytes of pictures came into its last argument.
void writeFakeFfmpeg(const QString& folder, const QString& script) {
  QFile program(folder + "/ffmpeg");
  ASSERT_TRUE(program.open(QIODevice::WriteOnly));
  program.write(script.toUtf8());
  program.close();
  ASSERT_TRUE(program.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
}

TEST(RenderCommand, AVideoIsEveryPictureOfATurn) {
  QTemporaryDir folder;
  const QByteArray path = qgetenv("PATH");
  writeFakeFfmpeg(folder.path(), "#!/bin/sh\nfor last; do :; done\nwc -c > \"$last\"\n");
  qputenv("PATH", folder.path().toUtf8() + ":" + path);
  Diagnostics diagnostics;
  RenderCommand command = boxTo(folder.filePath("turn.mp4"));
  command.size = {65, 41};
  command.seconds = 0.4;
  const auto done = render(command, diagnostics);
  qputenv("PATH", path);
  ASSERT_TRUE(done) << done.error().message();
  QFile video(command.output);
  ASSERT_TRUE(video.open(QIODevice::ReadOnly));
  EXPECT_EQ(video.readAll().trimmed().toInt(), 10 * 64 * 40 * 3) << "ten pictures with even sides";
}

TEST(RenderCommand, AVideoThatCannotBeWrittenLeavesNoFileAndSaysWhy) {
  QTemporaryDir folder;
  const QByteArray path = qgetenv("PATH");
  Diagnostics diagnostics;
  RenderCommand command = boxTo(folder.filePath("turn.mp4"));
  command.size = {64, 40};
  command.seconds = 0.08;
  qputenv("PATH", folder.path().toUtf8());
  const auto missing = render(command, diagnostics);
  writeFakeFfmpeg(folder.path(), "#!/bin/sh\nwhile read -r line; do :; done\necho 'Unknown encoder' >&2\nexit 1\n");
  const auto refused = render(command, diagnostics);
  qputenv("PATH", path);
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message().find("ffmpeg"), std::string::npos);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("Unknown encoder"), std::string::npos) << refused.error().message();
  EXPECT_FALSE(QFile::exists(command.output));
}

}  // namespace
}  // namespace hapticell::app
