// SPDX-License-Identifier: Apache-2.0
#include "app/mannequin/figure_skins.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "app/host/host.h"
#include "app/kit/thread_pool_task.h"
#include "app/viewport/widget/viewport_widget.h"

namespace hapticell::app {
namespace {

/// Skins that were made and are still worn, and the last one made: a size that is tried and taken back costs nothing.
struct Wardrobe {
  struct Worn {
    mannequin::Sex sex;
    mannequin::BodyDimensions body;
    std::weak_ptr<const mannequin::FigureSkin> skin;
  };
  std::mutex mutex;
  std::vector<Worn> worn;
  std::shared_ptr<const mannequin::FigureSkin> last;
};

}  // namespace

std::shared_ptr<const mannequin::FigureSkin> figureSkin(const mannequin::Figure& figure) {
  static Wardrobe wardrobe;
  {
    const std::scoped_lock lock(wardrobe.mutex);
    std::erase_if(wardrobe.worn, [](const auto& worn) { return worn.skin.expired(); });
    for (const auto& worn : wardrobe.worn)
      if (worn.sex == figure.sex && worn.body.values == figure.body.values) return worn.skin.lock();
  }
  auto skin = std::make_shared<const mannequin::FigureSkin>(figure);
  const std::scoped_lock lock(wardrobe.mutex);
  wardrobe.worn.push_back({figure.sex, figure.body, skin});
  wardrobe.last = skin;
  return skin;
}

FigureSkins::FigureSkins(Host& host, QObject* parent) : QObject(parent), host_(host) {}

void FigureSkins::look() {
  if (asking_) return;
  for (const workcell::Entity& entity : host_.viewport().scene().entities()) {
    if (!entity.figure() || !entity.robot() || host_.viewport().scene().hasSkin(entity)) continue;
    return ask(entity);
  }
}

void FigureSkins::ask(const workcell::Entity& entity) {
  asking_ = true;
  runInThreadPool(
      this, [figure = entity.figure()] { return figureSkin(*figure); },
      [this, id = entity.id, figure = entity.figure()](std::shared_ptr<const mannequin::FigureSkin> skin) {
        asking_ = false;
        SceneModel& scene = host_.viewport().scene();
        const workcell::Entity* wearer = scene.find(id);
        if (!wearer || wearer->figure() != figure) return;
        scene.setSkin(*wearer, std::move(skin));
        host_.viewport().refresh();
      });
}

}  // namespace hapticell::app
