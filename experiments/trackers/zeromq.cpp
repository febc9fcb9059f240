// SPDX-License-Identifier: MIT
#include "experiments/trackers/zeromq.hpp"

#include <cstddef>

#include "experiments/connections/loaded_library.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline trackers {
namespace {

constexpr const char* kLibrary = "libzmq.so.5";

// As zmq.h has them, version 4.
constexpr int kOptionSubscribe = 6;
constexpr int kOptionReceiveMore = 13;
constexpr int kOptionLinger = 17;
constexpr int kDontWait = 1;
constexpr short kPollIn = 1;

/// zmq_pollitem_t.
struct PollItem {
  void* socket;
  int descriptor;
  short events;
  short happened;
};

/// The functions that are used.
struct ZeroMqLibrary {
  void* (*new_context)();
  int (*end_context)(void*);
  void* (*new_socket)(void*, int);
  int (*close)(void*);
  int (*connect)(void*, const char*);
  int (*set_option)(void*, int, const void*, std::size_t);
  int (*get_option)(void*, int, void*, std::size_t*);
  int (*send)(void*, const void*, std::size_t, int);
  int (*receive)(void*, void*, std::size_t, int);
  int (*poll)(PollItem*, int, long);
};

LoadedLibrary open_library(const std::string& name) {
  try {
    return LoadedLibrary({name});
  } catch (const NoSuchLibrary& missing) {
    throw InputError(
        std::string("pupil://: expected the library ZeroMQ, by which Pupil sends, but ") +
        missing.what() + "; `apt install libzmq5`");
  }
}

ZeroMqLibrary load_functions() {
  const LoadedLibrary library = open_library(kLibrary);
  ZeroMqLibrary zmq{};
  library.find("zmq_ctx_new", zmq.new_context);
  library.find("zmq_ctx_term", zmq.end_context);
  library.find("zmq_socket", zmq.new_socket);
  library.find("zmq_close", zmq.close);
  library.find("zmq_connect", zmq.connect);
  library.find("zmq_setsockopt", zmq.set_option);
  library.find("zmq_getsockopt", zmq.get_option);
  library.find("zmq_send", zmq.send);
  library.find("zmq_recv", zmq.receive);
  library.find("zmq_poll", zmq.poll);
  return zmq;
}

const ZeroMqLibrary& loaded_zeromq() {
  static const ZeroMqLibrary library = load_functions();
  return library;
}

}  // namespace

ZeroMqSocket::ZeroMqSocket(ZeroMqKind kind, const std::string& endpoint)
    : context_(loaded_zeromq().new_context(), loaded_zeromq().end_context),
      socket_(loaded_zeromq().new_socket(context_.get(), static_cast<int>(kind)),
              loaded_zeromq().close) {
  const int linger_ms = 0;  // what was not sent when it is closed is not wanted any more
  loaded_zeromq().set_option(socket_.get(), kOptionLinger, &linger_ms, sizeof linger_ms);
  if (loaded_zeromq().connect(socket_.get(), endpoint.c_str()) != 0) {
    throw InputError("pupil://: expected a host and a port to connect to, got " + endpoint);
  }
}

void ZeroMqSocket::subscribe(const std::string& topic) {
  loaded_zeromq().set_option(socket_.get(), kOptionSubscribe, topic.data(), topic.size());
}

bool ZeroMqSocket::send(const std::string& message) {
  return loaded_zeromq().send(socket_.get(), message.data(), message.size(), kDontWait) >= 0;
}

std::optional<std::vector<std::string>> ZeroMqSocket::receive() {
  constexpr std::size_t kLongest = 1 << 20;
  static thread_local std::string part(kLongest, '\0');
  std::vector<std::string> parts;
  int more = 1;
  while (more != 0) {
    const int size = loaded_zeromq().receive(socket_.get(), part.data(), kLongest, kDontWait);
    if (size < 0) {
      return std::nullopt;
    }
    // A longer one came cut short: nothing that Pupil sends of a surface.
    const auto length = static_cast<std::size_t>(size);
    parts.push_back(length <= kLongest ? part.substr(0, length) : "");
    std::size_t bytes = sizeof more;
    loaded_zeromq().get_option(socket_.get(), kOptionReceiveMore, &more, &bytes);
  }
  return parts;
}

void await_message(const std::vector<const ZeroMqSocket*>& sockets, int wait_ms) {
  std::vector<PollItem> items;
  items.reserve(sockets.size());
  for (const ZeroMqSocket* socket : sockets) {
    items.push_back({socket->handle(), 0, kPollIn, 0});
  }
  loaded_zeromq().poll(items.data(), static_cast<int>(items.size()), wait_ms);
}

void require_zeromq(const char* library) { static_cast<void>(open_library(library)); }

}  // namespace impetus::inline trackers
