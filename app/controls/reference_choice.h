// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <optional>
#include <string>
#include <vector>

#include "workcell/document/document_state.h"

namespace hapticell::app {

class Host;

/// Something in whose axes and from whose origin numbers can be given: a frame of the cell, or an entity's own frame.
struct Reference {
  QString name;                   ///< "Station", "fixture · grip".
  workcell::EntityId entity = 0;  ///< The frame of the cell, or the entity that has the frame.
  std::string frame = {};         ///< The entity's own frame; empty: a frame of the cell.
  bool operator==(const Reference&) const = default;
};

/// All references of a cell, its own frames first; without `without` and what is attached to it.
std::vector<Reference> referencesOf(const workcell::DocumentState& state, workcell::EntityId without = 0);

/// A list to choose a reference from: some fixed entries ("World"), then the frames of the cell. It follows the
/// document: while the chosen frame is not available, the first entry is selected. GUI thread.
class ReferenceChoice : public QComboBox {
  Q_OBJECT
 public:
  /// `fixed`: the entries before the frames; may be empty.
  ReferenceChoice(Host& host, const QStringList& fixed, QWidget* parent = nullptr);

  /// Leaves out `entity` and what is attached to it from now on.
  void leaveOut(workcell::EntityId entity);
  /// True if there is at least one frame to choose.
  bool hasFrames() const { return !references_.empty(); }
  /// Index of the fixed entry; -1 if a frame is chosen, or if there is nothing to choose.
  int fixedEntry() const;
  /// The chosen frame; empty for a fixed entry.
  std::optional<Reference> chosen() const;
  /// The present pose of the chosen frame; empty for a fixed entry.
  std::optional<Pose> frame_W() const;
  /// The present pose of any frame; empty if the cell no longer has it.
  std::optional<Pose> frame_W(const Reference& reference) const;
  /// True if the chosen frame moves with `entity`.
  bool goesWith(workcell::EntityId entity) const;

 signals:
  /// The user chose another entry, or the chosen frame was removed or moved.
  void referenceChanged();
  /// The first frame became available, or the last one was removed.
  void framesListed();

 private:
  void list();
  Host& host_;
  int fixed_ = 0;
  workcell::EntityId without_ = 0;
  std::vector<Reference> references_;
  std::optional<Reference> wanted_;  ///< What the user chose, even while it is not available; empty: a fixed entry.
};

}  // namespace hapticell::app
