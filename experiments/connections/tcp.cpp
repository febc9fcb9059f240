// SPDX-License-Identifier: MIT
#include "experiments/connections/tcp.hpp"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <memory>

namespace impetus::inline connections {
namespace {

/// 0, or what went wrong.
int connected(int file, const addrinfo& place, std::chrono::milliseconds longest) {
  if (connect(file, place.ai_addr, place.ai_addrlen) == 0) {
    return 0;
  }
  if (errno != EINPROGRESS) {
    return errno;
  }
  if (!await_file(file, POLLOUT, longest)) {
    return ETIMEDOUT;
  }
  int error = 0;
  socklen_t size = sizeof error;
  getsockopt(file, SOL_SOCKET, SO_ERROR, &error, &size);
  return error;
}

}  // namespace

OpenFile connect_tcp(const std::string& host, const std::string& port,
                     std::chrono::milliseconds longest) {
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (const int error = getaddrinfo(host.c_str(), port.c_str(), &wanted, &found); error != 0) {
    throw NotConnected(gai_strerror(error));
  }
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> places(found, freeaddrinfo);
  int error = EADDRNOTAVAIL;
  for (const addrinfo* place = found; place != nullptr; place = place->ai_next) {
    OpenFile file(socket(place->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    error = file.is_open() ? connected(file.get(), *place, longest) : errno;
    if (error == 0) {
      const int at_once = 1;
      setsockopt(file.get(), IPPROTO_TCP, TCP_NODELAY, &at_once, sizeof at_once);
      return file;
    }
  }
  throw NotConnected(std::strerror(error));
}

bool await_file(int file, short events, std::chrono::milliseconds longest) {
  pollfd waiting{file, events, 0};
  return poll(&waiting, 1, static_cast<int>(longest.count())) > 0;
}

}  // namespace impetus::inline connections
