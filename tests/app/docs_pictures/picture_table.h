// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSize>
#include <QString>
#include <vector>

namespace hapticell::app {

/// A picture to take: how it is named, how large it is, where it goes.
struct PictureTask {
  QString name;  ///< Below docs/pictures, without ending.
  QSize size;
  const char* dock;  ///< Must be visible in the picture; null: no dock.
  QString file;      ///< Where it goes.
  QSize window{};    ///< Of the window, if the picture shows it smaller.
};

/// A picture of the documents and the function that takes it. The function reports with gtest: it fails if what it shows
/// did not come, and skips if its data is absent.
struct DocsPicture {
  const char* name;
  QSize size;
  const char* dock;
  void (*take)(const PictureTask& task);
  QSize window{};
};

// A table for each kind.
std::vector<DocsPicture> contactPictures();
std::vector<DocsPicture> figurePictures();
std::vector<DocsPicture> importPictures();
std::vector<DocsPicture> motionPictures();
std::vector<DocsPicture> robotPictures();

/// A picture that a walk of a user (app_walk_test) takes on its way, and the suite of that walk.
struct WalkPicture {
  const char* name;
  const char* suite;
};
const std::vector<WalkPicture>& walkPictures();
inline constexpr QSize kWalkSize{1200, 750};

}  // namespace hapticell::app
