// Sends key presses and mouse movements to this program from a thread of its own, at instants that
// wander through the frame, and says when. One is on its way at a time: the next is sent when it
// has arrived, or is given up.
//
//   into the queue           as if SDL had just taken them from the system
//   into the window system   by X11's test extension, as a device's driver does: the left Ctrl key,
//                            and the pointer one pixel to and fro
//
// SPDX-License-Identifier: MIT
#pragma once

#include <SDL.h>

#include <atomic>
#include <optional>
#include <thread>
#include <vector>

#include "experiments/record/ports.hpp"
#include "experiments/record/sent_input.hpp"

namespace impetus::inline window {

/// What an event is of the sender's; none: nothing, or a release.
std::optional<ArrivedInput> as_sent_input(const SDL_Event& event);

class InputSender {
 public:
  /// Begins to send. `clock` must outlive this.
  explicit InputSender(const Clock& clock);
  /// Stops.
  ~InputSender();
  InputSender(const InputSender&) = delete;
  InputSender& operator=(const InputSender&) = delete;

  /// Tells that this has arrived; to be called as soon as it has.
  void tell(const ArrivedInput& arrived);

  /// Stops; what was sent, in order of time, but for what had no time to arrive.
  std::vector<SentInput> stop();

 private:
  void send_until_stopped();
  void send_to_queue(InputDevice device);
  void note(InputDevice device, InputRoute route);
  void await_arrival();

  const Clock& clock_;
  std::vector<SentInput> sent_;     ///< the thread's until it is joined
  std::atomic<int> on_its_way_{0};  ///< which device and route; 0: nothing
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace impetus::inline window
