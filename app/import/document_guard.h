// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <string>

#include "workcell/files/document_lock.h"

namespace hapticell::app {

class DocumentModel;

/// Keeps two programs on one file from undoing each other's work: says that this window has the open document
/// (workcell/files/document_lock.h), and whether saving should be asked about. It goes by content, not by clocks. GUI
/// thread.
class DocumentGuard : public QObject {
  Q_OBJECT
 public:
  explicit DocumentGuard(DocumentModel& document, QObject* parent = nullptr);

  /// What the file of a document that is to be opened held when it was read (contentName()); for a copy from a crash,
  /// what it held when the copy's work began. Before the document takes its place.
  void setContent(std::filesystem::path document, std::string content);
  /// Of the open document; empty: unknown.
  std::string content() const;
  /// Another program has the open document, and had it first: this window should not save it.
  bool isReadOnly() const { return lock_.owner().has_value(); }
  /// Who, as a sentence; empty: nobody.
  QString ownerSentence() const;
  /// Why saving the open document at `path` should be asked about; empty: there is no reason. Reads the file.
  QString doubtAbout(const QString& path);
  /// The document was saved: its file holds what it holds.
  void noteSaved();

 signals:
  void changed();  ///< isReadOnly() may have changed.

 private:
  void follow();

  DocumentModel& document_;
  workcell::DocumentLock lock_;
  std::filesystem::path path_;  ///< That lock_ is about.
  std::filesystem::path content_path_;
  std::string content_;
};

}  // namespace hapticell::app
