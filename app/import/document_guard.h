// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <string>

#include "workcell/files/document_lock.h"

namespace hapticell::app {

class DocumentModel;

/// Keeps two programs from overwriting each other's work in one file: marks the open document as used by this
/// window (workcell/files/document_lock.h), and says whether to ask before saving. Compares content, not times. GUI
/// thread.
class DocumentGuard : public QObject {
  Q_OBJECT
 public:
  explicit DocumentGuard(DocumentModel& document, QObject* parent = nullptr);

  /// Sets what the file of a document held when it was read (contentName()); for a recovery copy, what it held when the
  /// copy's work began. Call it before the document is opened.
  void setContent(std::filesystem::path document, std::string content);
  /// Content name of the open document; empty: unknown.
  std::string content() const;
  /// True if another program opened the document first: this window should not save it.
  bool isReadOnly() const { return lock_.owner().has_value(); }
  /// Who has the document, as a sentence; empty: nobody.
  QString ownerSentence() const;
  /// Why to ask before saving the open document at `path`; empty: no reason. Reads the file.
  QString doubtAbout(const QString& path);
  /// The document was saved: its file now holds the document's content.
  void noteSaved();

 signals:
  void changed();  ///< isReadOnly() may have changed.

 private:
  void follow();

  DocumentModel& document_;
  workcell::DocumentLock lock_;
  std::filesystem::path path_;  ///< The document that lock_ is for.
  std::filesystem::path content_path_;
  std::string content_;
};

}  // namespace hapticell::app
