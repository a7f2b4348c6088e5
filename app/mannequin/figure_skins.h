// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <memory>

#include "mannequin/shape/figure_skin.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

class Host;

/// Sees to it that every mannequin is drawn in its skin (mannequin/shape/figure_skin.h) in place of its links. It is
/// made beside the window once for each size; until it is there, some seconds, the links are seen. GUI thread.
class FigureSkins : public QObject {
 public:
  explicit FigureSkins(Host& host, QObject* parent = nullptr);
  /// Looks whether a figure lacks its skin; to be called some times a second.
  void look();

 private:
  void ask(const workcell::Entity& entity);
  Host& host_;
  bool asking_ = false;
};

/// The skin of a figure; figures of one size share it as long as somebody has it. Takes some seconds the first time.
std::shared_ptr<const mannequin::FigureSkin> figureSkin(const mannequin::Figure& figure);

}  // namespace hapticell::app
