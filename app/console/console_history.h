// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

namespace hapticell::app {

/// What was typed, kept over sessions in a file (JSON, one line an entry) in a folder that is the
/// user's only. GUI thread.
class ConsoleHistory {
 public:
  /// Entries that are kept. Half, twice: as well.
  static constexpr int kKept = 1000;

  /// `file`: where it is kept; empty: nowhere.
  explicit ConsoleHistory(QString file);
  /// python-history in the user's state folder; empty if there is no such folder.
  static QString usualFile();
  /// Adds what was run; the same as the last one is not added again. Begins at the end again.
  void add(const QString& text);
  /// The entry before the present one, or after it; `text` is what stands in the field now and is kept until the end is
  /// left. At an end it returns `text`.
  QString before(const QString& text);
  QString after(const QString& text);
  const QStringList& entries() const { return entries_; }

 private:
  void read();
  void write() const;

  QString file_;
  QStringList entries_;
  QString typed_;  ///< What stood in the field when going back began.
  int at_ = 0;
};

}  // namespace hapticell::app
