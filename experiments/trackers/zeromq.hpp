// The little of ZeroMQ that Pupil's network API needs; the library is loaded when it is first used.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace impetus::inline trackers {

/// Kinds of sockets, as the library numbers them (zmq.h).
enum class ZeroMqKind { kSubscribe = 2, kRequest = 3 };

/// A socket that never blocks, of one thread.
class ZeroMqSocket {
 public:
  /// Connects in the background, so that nobody need be there yet. Throws InputError where the
  /// library is missing, or the endpoint ("tcp://HOST:PORT") is none.
  ZeroMqSocket(ZeroMqKind kind, const std::string& endpoint);

  /// Only of kSubscribe: receives the messages whose topic begins so.
  void subscribe(const std::string& topic);

  /// Whether it could be handed over.
  bool send(const std::string& message);

  /// The parts of the next message; none: there is none yet.
  std::optional<std::vector<std::string>> receive();

  [[nodiscard]] void* handle() const { return socket_.get(); }

 private:
  std::shared_ptr<void> context_;
  std::unique_ptr<void, int (*)(void*)> socket_;  ///< closed before the context ends
};

/// Waits until a message is there for one of them, `wait_ms` at most.
void await_message(const std::vector<const ZeroMqSocket*>& sockets, int wait_ms);

/// Throws InputError where there is no such library on this machine.
void require_zeromq(const char* library);

}  // namespace impetus::inline trackers
