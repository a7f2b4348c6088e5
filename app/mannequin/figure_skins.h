// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <memory>

#include "mannequin/shape/figure_skin.h"
#include "workcell/entity/entity.h"

namespace hapticell::app {

class Host;

/// Makes every mannequin draw its skin (mannequin/shape/figure_skin.h) in place of its links. Skins are made in the
/// background once for each size; until then, for some seconds, the links are shown. GUI thread.
class FigureSkins : public QObject {
 public:
  explicit FigureSkins(Host& host, QObject* parent = nullptr);
  /// Checks whether a mannequin lacks its skin; call it a few times a second.
  void look();

 private:
  void ask(const workcell::Entity& entity);
  Host& host_;
  bool asking_ = false;
};

/// The skin of a figure; figures of one size share it while it is in use. Takes some seconds the first time.
std::shared_ptr<const mannequin::FigureSkin> figureSkin(const mannequin::Figure& figure);

}  // namespace hapticell::app
