// SPDX-License-Identifier: Apache-2.0
// Takes the pictures of the documents from the present program: the real window, driven as the tests drive it.
//
//   docs_pictures FOLDER [--only NAME]...        all pictures, or these
//   docs_pictures --list                         their names
//   docs_pictures FOLDER --file PICTURE NAME     checks a picture of another program and keeps it under that name
//
// HAPTICELL_PICTURE_DATA=FOLDER has the CAD files that are not shipped; without them their pictures are skipped. Ends with 1
// if a picture could not be taken. tools/take_pictures runs it on a display of its own.
#include <gtest/gtest.h>

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>

#include "app/shell/application.h"
#include "app/style/fonts.h"
#include "app/style/proxy_style.h"
#include "app/style/theme.h"
#include "tests/app/docs_pictures/picture_file.h"
#include "tests/app/docs_pictures/picture_table.h"

namespace hapticell::app {

const std::vector<WalkPicture>& walkPictures() {
  static const std::vector<WalkPicture> all{{"engineer-1-import", "EngineerWalk"},
                                            {"engineer-5-contact", "EngineerWalk"},
                                            {"engineer-7-exported", "EngineerWalk"},
                                            {"ergonomist-3-hands", "ErgonomistWalk"},
                                            {"ergonomist-4-report", "ErgonomistWalk"},
                                            {"trainer-3-exercise", "TrainerWalk"},
                                            {"trainer-5-scored", "TrainerWalk"}};
  return all;
}

namespace {

std::vector<DocsPicture> allPictures() {
  std::vector<DocsPicture> all;
  for (const auto& table :
       {contactPictures(), figurePictures(), importPictures(), motionPictures(), robotPictures()})
    all.insert(all.end(), table.begin(), table.end());
  return all;
}

QString walkName(const WalkPicture& walk) {
  return QStringLiteral("walks/") + QLatin1String(walk.name);
}

QStringList allNames() {
  QStringList names;
  for (const DocsPicture& picture : allPictures()) names << QString::fromLatin1(picture.name);
  for (const WalkPicture& walk : walkPictures()) names << walkName(walk);
  return names;
}

struct Words {
  QString folder, file, file_name;
  QStringList only;
  bool list = false, usable = true;
};

Words wordsOf(const QStringList& words) {
  Words read;
  for (qsizetype i = 0; i < words.size(); ++i) {
    if (words[i] == "--list") {
      read.list = true;
    } else if (words[i] == "--only" && i + 1 < words.size()) {
      read.only << words[++i];
    } else if (words[i] == "--file" && i + 2 < words.size()) {
      read.file = words[++i];
      read.file_name = words[++i];
    } else if (read.folder.isEmpty() && !words[i].startsWith('-')) {
      read.folder = words[i];
    } else {
      read.usable = false;
    }
  }
  read.usable = read.usable && (read.list || !read.folder.isEmpty());
  return read;
}

bool isWanted(const Words& words, const QString& name) {
  return words.only.isEmpty() || words.only.contains(name);
}

QString fileOf(const Words& words, const QString& name) {
  return words.folder + '/' + name + ".png";
}

class Taken final : public testing::Test {
 public:
  Taken(void (*take)(const PictureTask&), PictureTask task) : take_(take), task_(std::move(task)) {}
  void TestBody() override { take_(task_); }

 private:
  void (*take_)(const PictureTask&);
  PictureTask task_;
};

/// A test for each wanted picture, and the walks of those wanted: the filter.
std::string plan(const Words& words) {
  QStringList filter;
  for (const DocsPicture& picture : allPictures()) {
    const QString name = QString::fromLatin1(picture.name);
    if (!isWanted(words, name)) continue;
    const PictureTask task{name, picture.size, picture.dock, fileOf(words, name), picture.window};
    const QString test = QString(name).replace('-', '_');  // In a filter, a minus begins what is left out.
    testing::RegisterTest("Picture", qPrintable(test), nullptr, nullptr, __FILE__, __LINE__,
                          [take = picture.take, task]() -> testing::Test* { return new Taken(take, task); });
    filter << "Picture." + test;
  }
  for (const WalkPicture& walk : walkPictures())
    if (isWanted(words, walkName(walk))) filter << QLatin1String(walk.suite) + QStringLiteral(".*");
  filter.removeDuplicates();
  return filter.join(':').toStdString();
}

/// Pictures of the walks in their size; how many are missing.
int keepWalks(const Words& words, const QString& taken) {
  int missing = 0;
  for (const WalkPicture& walk : walkPictures()) {
    if (!isWanted(words, walkName(walk))) continue;
    const QImage image(taken + '/' + QLatin1String(walk.name) + ".png");
    const QImage small = image.scaled(kWalkSize, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    const QString problem = image.isNull() ? walkName(walk) + ": its walk did not come so far"
                                           : savePicture(small, kWalkSize, fileOf(words, walkName(walk)));
    if (problem.isEmpty()) continue;
    ++missing;
    std::fprintf(stderr, "%s\n", qPrintable(problem));
  }
  return missing;
}

int keepFile(const Words& words) {
  const QImage image(words.file);
  const QString problem = savePicture(image, image.size(), fileOf(words, words.file_name));
  if (!problem.isEmpty()) std::fprintf(stderr, "%s\n", qPrintable(problem));
  return problem.isEmpty() ? 0 : 1;
}

int run(int argc, char** argv) {
  QStringList given;
  for (int i = 1; i < argc; ++i) given << QString::fromLocal8Bit(argv[i]);
  const Words words = wordsOf(given);
  if (!words.usable) {
    std::fputs("usage: docs_pictures FOLDER [--only NAME]... [--file PICTURE NAME] | --list\n", stderr);
    return 2;
  }
  const QStringList names = allNames();
  if (words.list) return std::printf("%s\n", qPrintable(names.join('\n'))) < 0 ? 2 : 0;
  if (!words.file.isEmpty()) return keepFile(words);
  for (const QString& name : words.only) {
    if (names.contains(name)) continue;
    std::fprintf(stderr, "There is no picture '%s'. docs_pictures --list names all.\n", qPrintable(name));
    return 2;
  }
  QStandardPaths::setTestModeEnabled(true);
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  Application application(argc, argv);
  QApplication::setStyle(new ProxyStyle);
  QApplication::setFont(textFont(TextRole::kText));
  QApplication::setPalette(paletteOf(darkTheme()));
  QTemporaryDir walks;
  qputenv("HAPTICELL_WALK_PICTURES", walks.path().toLocal8Bit());
  testing::InitGoogleTest();
  testing::GTEST_FLAG(filter) = plan(words);
  const int failed = RUN_ALL_TESTS();
  return keepWalks(words, walks.path()) + failed > 0 ? 1 : 0;
}

}  // namespace
}  // namespace hapticell::app

int main(int argc, char** argv) {
  return hapticell::app::run(argc, argv);
}
