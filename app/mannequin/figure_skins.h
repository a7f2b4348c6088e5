// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <map>
#include <vector>

#include "app/viewport/scene_model.h"

namespace hapticell::app {

class Host;

/// Draws mannequins that rest in one smooth skin (mannequin/body_skin.h) in place of their segments, in the looks that
/// their links have in the scene (scores). It is made beside the window once posture and looks have stood for a moment;
/// while the figure moves, its segments are seen, in the same looks. GUI thread.
class FigureSkins : public QObject {
 public:
  explicit FigureSkins(Host& host, QObject* parent = nullptr);
  /// Looks which figures rest; to be called some times a second.
  void look();

 private:
  struct Dressed {
    std::vector<double> joints;
    const mannequin::Figure* figure = nullptr;  ///< Only compared.
    std::map<int, LinkLook> looks;
    QElapsedTimer since;
    std::uint64_t set_at = 0;  ///< Revision of the scene that has the skin.
    enum class State { kMoves, kAsked, kReady, kAlone } state = State::kMoves;
  };
  void ask(const workcell::Entity& entity, Dressed& dressed);
  Host& host_;
  std::map<workcell::EntityId, Dressed> dressed_;
  bool asking_ = false;
};

/// The skin of an entity with a figure at these joints, its links in these looks (none: as clothed). Takes about a
/// second.
SceneModel::Skin makeSkin(const workcell::Entity& entity, const std::vector<double>& joints,
                          const std::map<int, LinkLook>& looks = {});

}  // namespace hapticell::app
