// SPDX-License-Identifier: MIT
#include "experiments/window/input_self_test.hpp"

#ifdef IMPETUS_HAS_XTEST
#include <X11/Xlib.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>
#endif

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include "experiments/window/canvas.hpp"
#include "experiments/window/display.hpp"

namespace impetus::inline window {
namespace {

constexpr std::chrono::microseconds kBetween{9'650};  // no simple part of any refresh
constexpr std::chrono::milliseconds kGivenUpAfter{500};
constexpr Uint32 kOwnMouse = 0x1A9E7;      // a mouse that no system has
constexpr SDL_Keycode kOwnKey = SDLK_F24;  // a key that no keyboard has
constexpr int kNothing = -1;

/// X11's test extension: the left Ctrl key, and the pointer one pixel to and fro.
class TestExtension {
 public:
#ifdef IMPETUS_HAS_XTEST
  TestExtension() {
    int unused = 0;
    works_ = connection_ != nullptr &&
             XTestQueryExtension(connection_.get(), &unused, &unused, &unused, &unused) != 0;
  }
  void press(bool down) {
    const KeyCode control = XKeysymToKeycode(connection_.get(), XK_Control_L);
    XTestFakeKeyEvent(connection_.get(), control, down ? True : False, CurrentTime);
    XFlush(connection_.get());
  }
  void move() {
    step_ = -step_;
    XTestFakeRelativeMotionEvent(connection_.get(), step_, 0, CurrentTime);
    XFlush(connection_.get());
  }
#else
  void press(bool /*down*/) {}
  void move() {}
#endif
  [[nodiscard]] bool works() const { return works_; }

 private:
#ifdef IMPETUS_HAS_XTEST
  /// The thread's own: one that is shared would make both wait.
  std::unique_ptr<::Display, int (*)(::Display*)> connection_{XOpenDisplay(nullptr), XCloseDisplay};
  int step_{1};
#endif
  bool works_{false};
};

void send_to_queue(InputDevice device) {
  SDL_Event event{};
  if (device == InputDevice::kKey) {
    event.type = SDL_KEYDOWN;
    event.key.state = SDL_PRESSED;
    event.key.keysym.sym = kOwnKey;
    event.key.keysym.scancode = SDL_SCANCODE_F24;
  } else {
    event.type = SDL_MOUSEMOTION;
    event.motion.which = kOwnMouse;
  }
  SDL_PushEvent(&event);
}

/// What an event is of the test's; none: nothing, or a release.
std::optional<ArrivedInput> as_sent_input(const StampedEvent& stamped) {
  const SDL_Event& event = stamped.event;
  ArrivedInput input{InputDevice::kKey, InputRoute::kWindowSystem, stamped.arrived_ns,
                     stamped.uncertainty_ns};
  if (event.type == SDL_MOUSEMOTION) {
    input.device = InputDevice::kMouse;
    input.route = event.motion.which == kOwnMouse ? InputRoute::kQueue : InputRoute::kWindowSystem;
    return input;
  }
  const SDL_Keycode key = event.type == SDL_KEYDOWN && event.key.repeat == 0
                              ? event.key.keysym.sym
                              : SDL_Keycode{SDLK_UNKNOWN};
  input.route = key == kOwnKey ? InputRoute::kQueue : InputRoute::kWindowSystem;
  return key == kOwnKey || key == SDLK_LCTRL ? std::optional(input) : std::nullopt;
}

int name_of(InputDevice device, InputRoute route) {
  return 2 * static_cast<int>(route) + static_cast<int>(device);
}

/// Sends from its beginning until it is stopped.
class Sender {
 public:
  /// `clock` must outlive this.
  explicit Sender(const Clock& clock) : clock_(clock) {}

  /// Tells that this has arrived; to be called as soon as it has.
  void tell(const ArrivedInput& arrived) {
    int awaited = name_of(arrived.device, arrived.route);
    on_its_way_.compare_exchange_strong(awaited, kNothing);
  }

  /// Stops; what was sent, in order of time, but for what had no time to arrive.
  std::vector<SentInput> stop() {
    thread_.request_stop();
    thread_.join();
    if (on_its_way_ != kNothing) {
      sent_.pop_back();
    }
    return std::move(sent_);
  }

 private:
  void send_until(const std::stop_token& stopped) {
    TestExtension system;
    for (int turn = 0; !stopped.stop_requested(); turn = (turn + 1) % (system.works() ? 4 : 2)) {
      const auto device = turn % 2 == 0 ? InputDevice::kKey : InputDevice::kMouse;
      const auto route = turn < 2 ? InputRoute::kQueue : InputRoute::kWindowSystem;
      const bool presses = route == InputRoute::kWindowSystem && device == InputDevice::kKey;
      on_its_way_ = name_of(device, route);
      sent_.push_back({device, route, clock_.now_ns()});
      if (route == InputRoute::kQueue) {
        send_to_queue(device);
      } else {
        presses ? system.press(true) : system.move();
      }
      await_arrival(stopped);
      std::this_thread::sleep_for(kBetween);
      if (presses) {  // never leave a key down
        system.press(false);
        std::this_thread::sleep_for(kBetween);
      }
    }
  }

  void await_arrival(const std::stop_token& stopped) {
    const auto until = std::chrono::steady_clock::now() + kGivenUpAfter;
    while (on_its_way_ != kNothing && !stopped.stop_requested() &&
           std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (!stopped.stop_requested()) {
      on_its_way_ = kNothing;
    }
  }

  const Clock& clock_;
  std::vector<SentInput> sent_;  ///< the thread's until it is joined
  std::atomic<int> on_its_way_{kNothing};
  std::jthread thread_{[this](const std::stop_token& stopped) { send_until(stopped); }};
};

}  // namespace

InputTrace try_input(Window& window, const Clock& clock, const std::function<bool()>& show) {
  InputTrace trace;
  EventPump& events = window.canvas().events;
  Sender sender(clock);
  events.listen([&trace, &sender](const StampedEvent& event) {
    if (const auto arrived = as_sent_input(event)) {
      trace.arrived.push_back(*arrived);
      sender.tell(*arrived);
    }
  });
  while (show()) {
  }
  trace.sent = sender.stop();
  events.listen({});
  return trace;
}

void centre_pointer(Window& window) {
  while_display_lasts([&] {
    SDL_WarpMouseInWindow(window.canvas().window.handle(), window.width_px() / 2,
                          window.height_px() / 2);
    window.canvas().events.pump();
  });
}

}  // namespace impetus::inline window
