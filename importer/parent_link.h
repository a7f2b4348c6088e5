// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/system/error.h"

namespace hapticell::importer {

/// The importer's end of the protocol in workcell/scenes/import_process.h: lines to the parent, the scene's bytes in
/// both directions. One thread.
class ParentLink {
 public:
  /// Reports the fraction of the whole work, 0 to 1, and the present stage, at most a hundred times.
  void progress(double share, const Text& stage);
  /// From now on, 0 to 1 of progress() stands for this range of the whole: for one of several files.
  void setRange(double from, double to);
  /// Call it before a part that may crash the process: the parent then runs it again without that part.
  void beginPart(int number);
  void error(const Error& error);
  /// The error on one line: packed() of geometry/system/packed_text.h.
  static std::string flatParts(const Error& error);
  void done();

  /// The scene written by the parent; empty if there is no scene.
  std::string readScene();
  /// Leaves a scene for the parent; false if there is no room.
  bool writeScene(const std::string& bytes);

 private:
  void line(const std::string& text);
  double told_ = -1.0, from_ = 0.0, to_ = 1.0;
  Text stage_;
};

}  // namespace hapticell::importer
