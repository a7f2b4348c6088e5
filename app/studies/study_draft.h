// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "geometry/shapes/vector.h"
#include "studies/document/study_text.h"
#include "workcell/document/document_state.h"

namespace hapticell::app {

/// The place of a thing in a rectangle of the floor, as two tables [[vary]] with the axes x and y say it.
struct FloorRange {
  std::string entity;
  std::size_t x = 0, y = 0;              ///< Their indices.
  double x_from = 0.0, x_to = 0.0;       ///< m in the cell W.
  double y_from = 0.0, y_to = 0.0;
  bool operator==(const FloorRange&) const = default;
};

/// The study that is edited in the window: its text, its file, and whether it differs from that. What the window does not
/// know of it stays as it is written. GUI thread.
class StudyDraft : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  const studies::StudyText& text() const { return text_; }
  const QString& file() const { return file_; }  ///< Empty: in no file yet.
  bool isEmpty() const { return text_.text().empty(); }
  bool isChanged() const { return changed_; }
  /// "car-door-robot", "New study".
  QString title() const;
  /// Absolute path of the cell that it names; empty: none.
  QString cell() const;
  /// What is missing or wrong, as StudyDocument says it; empty: the document can be read.
  std::optional<Error> fault() const;

  /// A study of a cell, in no file. Nothing varies yet.
  void begin(const QString& cell);
  /// Reads a file. Error: it cannot be read, or is not TOML. The draft stays as it was then.
  Expected<void> open(const QString& file);
  /// Writes it; paths that it names relative to its old folder are written relative to the new one.
  Expected<void> save(const QString& file);
  void clear();

  /// Changes a key; refused() if the text cannot take it.
  void set(const studies::StudyPlace& place, const char* key, const studies::StudyValue& value);
  /// Several keys of one table as one change.
  void setAll(const studies::StudyPlace& place,
              const std::vector<std::pair<const char*, studies::StudyValue>>& values);
  /// Adds a table; gives its index.
  std::size_t add(const std::string& table, const std::vector<std::pair<std::string, studies::StudyValue>>& keys);
  void remove(const studies::StudyPlace& place);
  /// Lets a thing (and what hangs on it) stand anywhere in a rectangle about its place: two tables [[vary]].
  void addFloorRange(const std::string& entity);
  /// The search for a better workplace as a study: the station (entities by name) moves up and down, and nearer to the
  /// mannequin and farther from it; its work is done by small women to large men, and the worst RULA score should be
  /// small. @pre the mannequin is one, the station is not empty
  void addWorkplace(const workcell::Entity& mannequin, const std::vector<std::string>& station);
  /// One combination of all values, samples, or a search; sets the tables that say so.
  void setMethod(const std::string& method);
  /// "grid", "list", "halton", "sobol", or "search".
  std::string method() const;

  /// All rectangles that its positions make, in a cell.
  std::vector<FloorRange> floorRanges(const workcell::DocumentState& cell) const;
  /// Writes a rectangle that was dragged or typed.
  void setFloorRange(const FloorRange& range, const workcell::DocumentState& cell);

  /// What a table is called in results: `name`, else `what`.
  std::string nameOf(const studies::StudyPlace& place) const;
  /// Names of all numbers that the questions answer with: "reach.share".
  std::vector<std::string> resultNames() const;
  /// Keys of a table that this window does not edit; they stay.
  std::vector<std::string> unknownKeys(const studies::StudyPlace& place) const;
  /// A name that no table of this list has: "position", "position_2".
  std::string freeName(const std::string& table, const std::string& wanted) const;

 signals:
  void changed();
  void refused(const hapticell::Error& error);

 private:
  void take(const Expected<void>& done);

  studies::StudyText text_;
  QString file_;
  QString cell_;  ///< Of a study in no file: absolute.
  bool changed_ = false;
};

}  // namespace hapticell::app
