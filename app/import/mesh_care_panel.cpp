// SPDX-License-Identifier: Apache-2.0
#include "app/import/mesh_care_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/host/document_model.h"
#include "app/host/host.h"
#include "app/host/message_log.h"
#include "app/host/selection.h"
#include "app/import/import_choices.h"
#include "app/kit/form.h"
#include "app/style/segmented.h"
#include "app/style/units.h"
#include "app/style/value_field.h"
#include "workcell/meshes/mesh_care.h"

namespace hapticell::app {
namespace {

using workcell::CollisionProxy;

QString millimetreText(double metres) {
  return lengthText(metres, metres < 1e-4 ? 3 : 2);
}

QString healthText(const workcell::MeshHealth& health) {
  const auto count = [](std::size_t n) { return countText(static_cast<double>(n)); };
  QStringList words;
  if (health.border_edges > 0) words << QObject::tr("%1 open edges").arg(count(health.border_edges));
  if (health.non_manifold_edges > 0)
    words << QObject::tr("%1 edges with more than two faces").arg(count(health.non_manifold_edges));
  if (health.flipped_edges > 0)
    words << QObject::tr("%1 edges between faces of opposite orientation").arg(count(health.flipped_edges));
  return words.isEmpty() ? QObject::tr("closed") : words.join(", ");
}

}  // namespace

MeshCarePanel::MeshCarePanel(Host& host, BackgroundWork& background, QWidget* parent)
    : QWidget(parent), host_(host), background_(background) {
  setMinimumWidth(330);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  QVBoxLayout* what = addSection(*column, {});
  name_ = makeLabel({}, TextRole::kSection);
  counts_ = makeLive(3, TextRole::kSecond, true);
  counts_->setObjectName("meshCounts");
  what->addWidget(name_);
  what->addWidget(counts_);
  QVBoxLayout* fewer = addSection(*column, tr("Mesh"));
  tolerance_ = new ValueField({tr("mm"), 2, 0.01, 1000.0, 0.1});
  tolerance_->setValue(0.2);
  simplify_ = new QPushButton(tr("Simplify"));
  simplify_->setObjectName("meshSimplify");
  addRow(*fewer, tr("Tolerance"), sideBySide({tolerance_, simplify_}), 100);
  turn_ = new QPushButton(tr("Orient faces outwards"));
  turn_->setObjectName("meshTurn");
  addRow(*fewer, {}, turn_, 100);
  QVBoxLayout* checked = addSection(*column, tr("Collision shape"));
  proxy_ = new Segmented({tr("Own mesh"), tr("Coarse"), tr("Convex hull")});
  proxy_->setObjectName("meshProxy");
  checked->addWidget(proxy_);
  proxy_text_ = makeLive(2, TextRole::kSecond, true);
  proxy_text_->setObjectName("meshProxyText");
  checked->addWidget(proxy_text_);
  column->addStretch(1);
  connect(simplify_, &QPushButton::clicked, this, &MeshCarePanel::simplify);
  connect(turn_, &QPushButton::clicked, this, &MeshCarePanel::turnOutwards);
  connect(proxy_, &Segmented::chosen, this, &MeshCarePanel::chooseProxy);
  connect(&host_.selection(), &Selection::changed, this, &MeshCarePanel::refresh);
  connect(&host_.documentModel(), &DocumentModel::changed, this, &MeshCarePanel::refresh);
  refresh();
}

const workcell::Entity* MeshCarePanel::solid() const {
  const workcell::Entity* entity = host_.documentModel().document().find(host_.selection().current());
  return entity && entity->mesh() ? entity : nullptr;
}

void MeshCarePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void MeshCarePanel::refresh() {
  if (!isVisible()) return;
  const workcell::Entity* entity = solid();
  for (QWidget* widget : std::initializer_list<QWidget*>{tolerance_, simplify_, turn_, proxy_})
    widget->setEnabled(entity);
  if (!entity) {
    looked_at_ = nullptr;
    name_->setText(tr("No solid is selected"));
    counts_->setText(tr("Click one in the scene or in the tree."));
    proxy_text_->clear();
    return;
  }
  name_->setText(QString::fromStdString(entity->name));
  proxy_->setCurrent(static_cast<int>(entity->proxy().kind));
  const CollisionProxy& proxy = entity->proxy();
  proxy_text_->setText(proxy.mesh ? tr("%1 triangles, at most %2 from the mesh")
                                        .arg(countText(static_cast<double>(proxy.mesh->triangles.size())),
                                             millimetreText(proxy.deviation))
                                  : tr("The displayed mesh."));
  if (looked_at_ != entity->mesh().get()) look();
}

void MeshCarePanel::look() {
  const auto mesh = solid()->mesh();
  looked_at_ = mesh.get();
  const QString triangles = tr("%1 triangles").arg(countText(static_cast<double>(mesh->triangles.size())));
  counts_->setText(triangles);
  background_.start(
      tr("Checking the mesh"),
      [this, mesh, triangles](workcell::ImportMonitor&) -> Expected<BackgroundWork::Then> {
        const QString health = healthText(workcell::healthOf(*mesh));
        return BackgroundWork::Then([this, mesh, triangles, health] {
          if (looked_at_ == mesh.get()) counts_->setText(triangles + QStringLiteral(", ") + health);
        });
      },
      [](const Error&) {});
}

void MeshCarePanel::start(const QString& name, BackgroundWork::Work work) {
  background_.start(name, std::move(work), [this, name](const Error& error) {
    host_.messages().reportCause(Severity::kProblem, tr("%1 is unchanged").arg(name), error);
  });
}

void MeshCarePanel::replace(workcell::EntityId id, const workcell::SourceFile& source, geometry::TriangleMesh mesh,
                            const QString& told) {
  const workcell::Entity* entity = host_.documentModel().document().find(id);
  if (!entity) return;
  workcell::Entity fresh = *entity;
  fresh.source = source;
  fresh.body = workcell::Solid{std::make_shared<const geometry::TriangleMesh>(std::move(mesh))};
  if (host_.documentModel().execute(workcell::ReplaceShape{id, std::move(fresh)}))
    host_.messages().tell(Severity::kInformation, QString::fromStdString(entity->name), told);
}

void MeshCarePanel::simplify() {
  const workcell::Entity* entity = solid();
  if (!entity) return;
  workcell::SourceFile source = entity->source;
  source.simplified += 0.001 * tolerance_->value();
  start(QString::fromStdString(entity->name),
        [this, id = entity->id, mesh = entity->mesh(), source,
         tolerance = 0.001 * tolerance_->value()](workcell::ImportMonitor& monitor) -> Expected<BackgroundWork::Then> {
          monitor.report(Text("simplifying"), 0.1);
          auto made = workcell::simplify(*mesh, tolerance);
          HAPTICELL_TRY(made);
          const QString told =
              tr("%1 of %2 triangles left, at most %3 from the surface.")
                  .arg(countText(static_cast<double>(made->mesh.triangles.size())),
                       countText(static_cast<double>(mesh->triangles.size())), millimetreText(made->deviation));
          auto result = std::make_shared<workcell::MadeMesh>(std::move(*made));
          return BackgroundWork::Then(
              [this, id, source, result, told] { replace(id, source, std::move(result->mesh), told); });
        });
}

void MeshCarePanel::turnOutwards() {
  const workcell::Entity* entity = solid();
  if (!entity) return;
  workcell::SourceFile source = entity->source;
  source.oriented = true;
  start(
      QString::fromStdString(entity->name),
      [this, id = entity->id, mesh = entity->mesh(),
       source](workcell::ImportMonitor&) -> Expected<BackgroundWork::Then> {
        auto turned = std::make_shared<geometry::TriangleMesh>(*mesh);
        const std::size_t count = workcell::orient(*turned);
        const QString told = count == 0
                                 ? tr("All faces already point outwards.")
                                 : tr("%1 faces were flipped outwards.").arg(countText(static_cast<double>(count)));
        return BackgroundWork::Then(
            [this, id, source, turned, told] { replace(id, source, std::move(*turned), told); });
      });
}

void MeshCarePanel::chooseProxy(int kind) {
  const workcell::Entity* entity = solid();
  if (!entity) return;
  start(QString::fromStdString(entity->name),
        [this, id = entity->id, mesh = entity->mesh(), kind = static_cast<CollisionProxy::Kind>(kind),
         tolerance = 0.001 * tolerance_->value()](workcell::ImportMonitor& monitor) -> Expected<BackgroundWork::Then> {
          monitor.report(Text("preparing the collision shape"), 0.1);
          auto proxy = workcell::makeProxy(*mesh, kind, tolerance);
          HAPTICELL_TRY(proxy);
          auto made = std::make_shared<CollisionProxy>(std::move(*proxy));
          return BackgroundWork::Then([this, id, made] {
            host_.documentModel().execute(workcell::SetCollisionProxy{id, *made});
          });
        });
}

}  // namespace hapticell::app
