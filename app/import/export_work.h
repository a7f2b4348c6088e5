// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

#include "app/host/background_work.h"

namespace hapticell::app {

class Host;

/// What the window writes: exports, packs and change reports, in the background; messages report the result. Functions
/// that ask for a file call those that take its name. GUI thread.
class ExportWork : public QObject {
  Q_OBJECT
 public:
  /// What a change report compares with.
  enum class Against { kSaved, kImport, kOtherCell };

  ExportWork(Host& host, BackgroundWork& background, QObject* parent = nullptr);

  void askExport(bool selection_only);
  void askPack();
  void askReport(Against against);

  /// Writes the cell, or the selection and all below it, in the format that the name's ending says.
  void exportTo(const QString& path, bool selection_only);
  /// Packs the document with all its files into a folder or an archive (.zip, .tar.gz). Asks first if files are outside
  /// its folder, unless `allow_outside`.
  void packTo(const QString& path, bool allow_outside = false);
  /// Writes PDF or CSV by the name's ending; `other` is the workcell for kOtherCell.
  void reportTo(const QString& path, Against against, const QString& other = {});

 signals:
  void finished(const QString& path, bool done);

 private:
  void run(const QString& path, BackgroundWork::Work work, const QString& failed);
  void askOutside(const QString& path, const QStringList& files);
  void reportWritten(const QString& path, const std::vector<Text>& notes);

  Host& host_;
  BackgroundWork& background_;
};

}  // namespace hapticell::app
