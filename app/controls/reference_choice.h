// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>
#include <optional>
#include <string>
#include <vector>

#include "workcell/document/document_state.h"

namespace hapticell::app {

class Host;

/// Something whose axes and origin numbers can be given in: a frame of the cell, or an entity's own frame.
struct Reference {
  QString name;                   ///< "Station", "fixture · grip".
  workcell::EntityId entity = 0;  ///< The frame itself, or whose it is.
  std::string frame = {};         ///< The entity's own frame; empty: a frame of the cell.
  bool operator==(const Reference&) const = default;
};

/// All of a cell, those of the cell first. Without `without` and what is attached to it: nothing is given in itself.
std::vector<Reference> referencesOf(const workcell::DocumentState& state, workcell::EntityId without = 0);

/// A list to choose a reference from: the frames of the cell behind some fixed entries ("World"). It follows the
/// document; where the chosen frame cannot be chosen any longer the first entry is, until it can again. GUI thread.
class ReferenceChoice : public QComboBox {
  Q_OBJECT
 public:
  /// `fixed`: the entries before the frames; may be empty.
  ReferenceChoice(Host& host, const QStringList& fixed, QWidget* parent = nullptr);

  /// From now on `entity` and what is attached to it is left out.
  void leaveOut(workcell::EntityId entity);
  /// There is at least one frame to choose.
  bool hasFrames() const { return !references_.empty(); }
  /// Index of the fixed entry; -1: a frame is chosen, or there is nothing to choose.
  int fixedEntry() const;
  /// Where the chosen frame stands now; nothing for a fixed entry.
  std::optional<Pose> frame_W() const;
  /// The chosen frame moves when `entity` does.
  bool goesWith(workcell::EntityId entity) const;

 signals:
  /// The user chose another entry, or the chosen frame is gone or moved.
  void referenceChanged();
  /// Whether there are frames has changed.
  void framesListed();

 private:
  void list();
  std::optional<Reference> current() const;
  Host& host_;
  int fixed_ = 0;
  workcell::EntityId without_ = 0;
  std::vector<Reference> references_;
  std::optional<Reference> wanted_;  ///< What the user chose, also while it cannot be; nothing: a fixed entry.
};

}  // namespace hapticell::app
