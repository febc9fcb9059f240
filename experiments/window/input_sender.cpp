// SPDX-License-Identifier: MIT
#include "experiments/window/input_sender.hpp"

#include <chrono>
#include <memory>
#include <utility>

#ifdef IMPETUS_HAS_XTEST
#include <X11/Xlib.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>
#endif

namespace impetus::inline window {
namespace {

constexpr std::chrono::microseconds kBetween{9'650};  // no simple part of any refresh
constexpr std::chrono::milliseconds kGivenUpAfter{500};
constexpr Uint32 kOwnMouse = 0x1A9E7;      // a mouse that no system has
constexpr SDL_Keycode kOwnKey = SDLK_F24;  // a key that no keyboard has

#ifdef IMPETUS_HAS_XTEST

/// A connection of the thread's own: one that is shared would make both wait.
class TestExtension {
 public:
  TestExtension() : connection_(XOpenDisplay(nullptr)) {
    int unused = 0;
    if (connection_ != nullptr &&
        XTestQueryExtension(connection_, &unused, &unused, &unused, &unused) == 0) {
      XCloseDisplay(std::exchange(connection_, nullptr));
    }
  }
  ~TestExtension() {
    if (connection_ != nullptr) {
      XCloseDisplay(connection_);
    }
  }
  TestExtension(const TestExtension&) = delete;
  TestExtension& operator=(const TestExtension&) = delete;

  [[nodiscard]] bool works() const { return connection_ != nullptr; }

  void press() {
    XTestFakeKeyEvent(connection_, control(), True, CurrentTime);
    XFlush(connection_);
  }
  void release() {
    XTestFakeKeyEvent(connection_, control(), False, CurrentTime);
    XFlush(connection_);
  }
  void move() {
    step_ = -step_;
    XTestFakeRelativeMotionEvent(connection_, step_, 0, CurrentTime);
    XFlush(connection_);
  }

 private:
  [[nodiscard]] unsigned control() const { return XKeysymToKeycode(connection_, XK_Control_L); }

  ::Display* connection_;
  int step_{1};
};

#else

class TestExtension {
 public:
  [[nodiscard]] static bool works() { return false; }
  void press() {}
  void release() {}
  void move() {}
};

#endif

int name_of(InputDevice device, InputRoute route) {
  return 1 + 2 * static_cast<int>(device) + static_cast<int>(route);
}

}  // namespace

std::optional<ArrivedInput> as_sent_input(const SDL_Event& event) {
  ArrivedInput input;
  if (event.type == SDL_KEYDOWN && event.key.repeat == 0) {
    const SDL_Keycode key = event.key.keysym.sym;
    input.route = key == kOwnKey ? InputRoute::kQueue : InputRoute::kWindowSystem;
    return key == kOwnKey || key == SDLK_LCTRL ? std::optional(input) : std::nullopt;
  }
  if (event.type == SDL_MOUSEMOTION) {
    input.device = InputDevice::kMouse;
    input.route = event.motion.which == kOwnMouse ? InputRoute::kQueue : InputRoute::kWindowSystem;
    return input;
  }
  return std::nullopt;
}

InputSender::InputSender(const Clock& clock)
    : clock_(clock), thread_([this] { send_until_stopped(); }) {}

InputSender::~InputSender() { static_cast<void>(stop()); }

std::vector<SentInput> InputSender::stop() {
  stopping_ = true;
  if (thread_.joinable()) {
    thread_.join();
  }
  if (on_its_way_ != 0 && !sent_.empty()) {
    sent_.pop_back();
  }
  return std::exchange(sent_, {});
}

void InputSender::tell(const ArrivedInput& arrived) {
  int awaited = name_of(arrived.device, arrived.route);
  on_its_way_.compare_exchange_strong(awaited, 0);
}

void InputSender::await_arrival() {
  const auto until = std::chrono::steady_clock::now() + kGivenUpAfter;
  while (on_its_way_ != 0 && !stopping_ && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (!stopping_) {
    on_its_way_ = 0;
  }
}

void InputSender::note(InputDevice device, InputRoute route) {
  on_its_way_ = name_of(device, route);
  sent_.push_back({device, route, clock_.now_ns()});
}

void InputSender::send_to_queue(InputDevice device) {
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
  note(device, InputRoute::kQueue);
  SDL_PushEvent(&event);
}

void InputSender::send_until_stopped() {
  TestExtension system;
  for (int turn = 0; !stopping_; turn = (turn + 1) % 5) {
    if (turn == 0) {
      send_to_queue(InputDevice::kKey);
    } else if (turn == 1) {
      send_to_queue(InputDevice::kMouse);
    } else if (system.works() && turn == 2) {
      note(InputDevice::kKey, InputRoute::kWindowSystem);
      system.press();
    } else if (system.works() && turn == 3) {
      system.release();
    } else if (system.works() && turn == 4) {
      note(InputDevice::kMouse, InputRoute::kWindowSystem);
      system.move();
    }
    await_arrival();
    std::this_thread::sleep_for(kBetween);
  }
  if (system.works()) {
    system.release();  // never leave a key down
  }
}

}  // namespace impetus::inline window
