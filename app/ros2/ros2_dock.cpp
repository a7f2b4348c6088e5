// SPDX-License-Identifier: Apache-2.0
#include "app/ros2/ros2_dock.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/host/host.h"
#include "app/kit/action_face.h"
#include "app/kit/dock_front.h"
#include "app/kit/form.h"
#include "app/kit/top_menus.h"
#include "app/ros2/description_section.h"
#include "app/ros2/motion_section.h"
#include "app/ros2/robot_link_section.h"
#include "app/ros2/ros2_network.h"
#include "app/ros2/ros2_topics.h"
#include "app/style/dock_title_bar.h"
#include "app/style/icon.h"

namespace hapticell::app {

void addRos2Dock(Host& host) {
  auto* panel = new QWidget;
  panel->setObjectName("ros2Panel");
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* network = new Ros2Network;
  column->addWidget(network);
  auto* topics = new Ros2Topics(*network);
  column->addWidget(topics);
  column->addWidget(new RobotLinkSection(host, *network, *topics));
  column->addWidget(new DescriptionSection(host, *network, *topics));
  column->addWidget(new MotionSection(host, *network));
  column->addStretch(1);
  QDockWidget* dock = makeDock("dockRos2", QObject::tr("ROS 2"), scrolledPanel(panel, 332));
  dock->setWindowIcon(icon("robot"));
  host.addDock(dock, Qt::RightDockWidgetArea);
  dock->hide();
  markAsTask(dock);
  QAction* action = makeAction(&host.window(), {"actionRos2", QObject::tr("ROS 2"), {}, {}, {}});
  host.window().addAction(action);
  topMenu(host.window(), "menuApplications", QObject::tr("Applications"))->addAction(action);
  QObject::connect(action, &QAction::triggered, dock, [dock] {
    bringToFront(dock);
  });
}

}  // namespace hapticell::app
