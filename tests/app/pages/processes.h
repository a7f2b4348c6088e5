// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QByteArrayList>
#include <QFile>

namespace hapticell::app {

/// A port that nobody listens on now.
inline int freePort() {
  const int listener = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* any = reinterpret_cast<sockaddr*>(&address);
  EXPECT_EQ(::bind(listener, any, size), 0);
  EXPECT_EQ(::getsockname(listener, any, &size), 0);
  ::close(listener);
  return ntohs(address.sin_port);
}

/// The children of a process, by the system's own list: all that its threads started.
inline QByteArrayList childrenOf(qint64 process) {
  QFile list(QStringLiteral("/proc/%1/task/%1/children").arg(process));
  return list.open(QIODevice::ReadOnly) ? list.readAll().simplified().split(' ') : QByteArrayList();
}

/// The child of this process whose program is called so; 0: there is none.
inline pid_t childCalled(const QByteArray& program) {
  for (const QByteArray& child : childrenOf(::getpid())) {
    QFile name(QStringLiteral("/proc/%1/cmdline").arg(QString::fromLatin1(child)));
    if (!child.isEmpty() && name.open(QIODevice::ReadOnly) && name.readAll().split('\0').front().endsWith(program))
      return static_cast<pid_t>(child.toLongLong());
  }
  return 0;
}

}  // namespace hapticell::app
