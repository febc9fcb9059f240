// Markers: what is told arrives in order at a port and at a socket, with the instant it was sent;
// who does not take them, or goes away, holds nothing up.
// SPDX-License-Identifier: MIT
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "experiments/markers/marker_writer.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::markers_test {

using std::chrono::steady_clock;

/// A port's two ends; the far one is another recorder's.
class PortPair {
 public:
  PortPair() {
    EXPECT_EQ(openpty(&far_, &near_, nullptr, nullptr, nullptr), 0);
    termios raw{};
    tcgetattr(far_, &raw);
    cfmakeraw(&raw);
    tcsetattr(far_, TCSANOW, &raw);
  }
  ~PortPair() {
    close(near_);
    unplug();
  }
  [[nodiscard]] std::string address() const { return std::string("serial://") + ttyname(near_); }
  [[nodiscard]] std::string received(std::size_t count) const {
    std::string bytes(count, '\0');
    std::size_t done = 0;
    while (done < count) {
      const ssize_t got = ::read(far_, bytes.data() + done, count - done);
      if (got <= 0) {
        break;
      }
      done += static_cast<std::size_t>(got);
    }
    bytes.resize(done);
    return bytes;
  }
  void unplug() {
    if (far_ >= 0) {
      close(std::exchange(far_, -1));
    }
  }

 private:
  int far_{-1};
  int near_{-1};
};

/// A program that listens on this machine.
class Listener {
 public:
  explicit Listener(std::uint16_t port = 0) {
    file_ = socket(AF_INET, SOCK_STREAM, 0);
    const int again = 1;
    setsockopt(file_, SOL_SOCKET, SO_REUSEADDR, &again, sizeof again);
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    place.sin_port = htons(port);
    EXPECT_EQ(bind(file_, reinterpret_cast<sockaddr*>(&place), sizeof place), 0);
    EXPECT_EQ(listen(file_, 1), 0);
    socklen_t size = sizeof place;
    getsockname(file_, reinterpret_cast<sockaddr*>(&place), &size);
    port_ = ntohs(place.sin_port);
  }
  ~Listener() { leave(); }
  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::string address() const { return "tcp://127.0.0.1:" + std::to_string(port_); }
  void take_call() { call_ = accept(file_, nullptr, nullptr); }
  [[nodiscard]] std::string line() const {
    std::string words;
    for (char letter = 0; ::read(call_, &letter, 1) == 1 && letter != '\n';) {
      words += letter;
    }
    return words;
  }
  void leave() {
    for (int* file : {&call_, &file_}) {
      if (*file >= 0) {
        close(std::exchange(*file, -1));
      }
    }
  }

 private:
  int file_{-1};
  int call_{-1};
  std::uint16_t port_{0};
};

MarkerCodes codes() {
  MarkerCodes codes;
  codes.onset = 20;
  codes.contact = 200;
  codes.answer = 10;  // a line feed: what a terminal would change on its way
  return codes;
}

std::string bytes(std::initializer_list<int> values) {
  std::string text;
  for (const int value : values) {
    text += static_cast<char>(value);
  }
  return text;
}

TEST(Markers, ArriveAtAPortInOrderAsBytes) {
  const PortPair port;
  const SteadyClock clock;
  MarkerWriter writer(open_marker_line(port.address()), codes(), clock);
  const std::int64_t begin_ns = clock.now_ns();
  writer.mark(MarkedEvent::kFixation, begin_ns, 1);  // has no code
  writer.mark(MarkedEvent::kOnset, begin_ns, 1);
  writer.mark(MarkedEvent::kContact, begin_ns + 1, 1);
  writer.mark(MarkedEvent::kAnswer, begin_ns + 2, 2);
  EXPECT_EQ(port.received(3), bytes({20, 200, 10}));
  const std::vector<MarkerRecord> records = writer.take();
  ASSERT_EQ(records.size(), 3U);
  EXPECT_EQ(records[1].event, MarkedEvent::kContact);
  EXPECT_EQ(records[1].code, 200);
  EXPECT_EQ(records[1].event_ns, begin_ns + 1);
  EXPECT_EQ(records[2].interval, 2);
  for (const MarkerRecord& record : records) {
    ASSERT_TRUE(record.written_ns.has_value());
    EXPECT_GE(*record.written_ns, begin_ns);
    EXPECT_LE(*record.written_ns, clock.now_ns());
  }
  EXPECT_TRUE(writer.take().empty());
  EXPECT_EQ(writer.counts().marked, 3U);
  EXPECT_EQ(writer.counts().lost, 0U);
}

TEST(Markers, ArriveAtASocketAsLines) {
  Listener recorder;
  const SteadyClock clock;
  MarkerWriter writer(open_marker_line(recorder.address()), codes(), clock);
  recorder.take_call();
  writer.mark(MarkedEvent::kOnset, 1, 1);
  writer.mark(MarkedEvent::kContact, 2, 1);
  EXPECT_EQ(recorder.line(), "20 onset");
  EXPECT_EQ(recorder.line(), "200 contact");
}

TEST(Markers, ThatNobodyTakesHoldNothingUp) {
  const PortPair port;  // nobody reads: its buffer is full after some thousand bytes
  const SteadyClock clock;
  MarkerWriter writer(open_marker_line(port.address()), codes(), clock);
  const auto begin = steady_clock::now();
  for (int i = 0; i < 100'000; ++i) {
    writer.mark(MarkedEvent::kOnset, i, 1);
  }
  const std::vector<MarkerRecord> records = writer.take();
  EXPECT_LT(steady_clock::now() - begin, std::chrono::seconds(1));
  ASSERT_EQ(records.size(), 100'000U);
  EXPECT_TRUE(records.front().written_ns.has_value());
  EXPECT_FALSE(records.back().written_ns.has_value());
  EXPECT_GT(writer.counts().lost, 0U);
}

TEST(Markers, OfAnUnpluggedPortAreCountedAsLost) {
  PortPair port;
  const SteadyClock clock;
  MarkerWriter writer(open_marker_line(port.address()), codes(), clock);
  port.unplug();
  writer.mark(MarkedEvent::kOnset, 1, 1);
  writer.mark(MarkedEvent::kContact, 2, 1);
  const std::vector<MarkerRecord> records = writer.take();
  ASSERT_EQ(records.size(), 2U);
  EXPECT_FALSE(records[0].written_ns.has_value());
  EXPECT_EQ(writer.counts().lost, 2U);
}

TEST(Markers, GoOnWhereTheOtherProgramIsBack) {
  auto recorder = std::make_unique<Listener>();
  const std::uint16_t port = recorder->port();
  const std::unique_ptr<MarkerLine> line = open_marker_line(recorder->address());
  recorder->take_call();
  EXPECT_TRUE(line->write(MarkedEvent::kOnset, 1, 0));
  recorder.reset();
  bool is_sent = true;
  for (int i = 0; i < 20 && is_sent; ++i) {  // the system takes one before it knows
    is_sent = line->write(MarkedEvent::kOnset, 2, 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_FALSE(is_sent);
  EXPECT_FALSE(line->write(MarkedEvent::kOnset, 3, 0));
  Listener again(port);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  EXPECT_TRUE(line->write(MarkedEvent::kContact, 4, 0));
  again.take_call();
  EXPECT_EQ(again.line(), "4 contact");
}

TEST(Markers, WithoutALineAreRefusedInOneSentence) {
  const auto refused = [](const std::string& address) {
    return refusal([&] { static_cast<void>(open_marker_line(address)); });
  };
  const std::string begin = "--markers: expected ";
  EXPECT_EQ(refused("/dev/ttyUSB0"),
            begin + "serial:///dev/PORT, tcp://HOST:PORT or lsl://NAME, got /dev/ttyUSB0");
  EXPECT_EQ(refused("serial://ttyUSB0"),
            begin +
                "serial:///dev/PORT or serial:///dev/PORT?baud=115200, "
                "got serial://ttyUSB0");
  EXPECT_EQ(refused("serial:///dev/ttyUSB0?baud=7"),
            begin +
                "a baud of 9600, 19200, 38400, 57600, 115200, 230400, 460800, got "
                "serial:///dev/ttyUSB0?baud=7");
  EXPECT_EQ(refused("serial:///dev/no-such-port"),
            begin +
                "a serial port that opens, got serial:///dev/no-such-port: No such file or "
                "directory");
  EXPECT_EQ(refused("serial:///dev/null"), begin +
                                               "a serial port that opens, got "
                                               "serial:///dev/null: Inappropriate ioctl for "
                                               "device");
  EXPECT_EQ(refused("tcp://127.0.0.1"), begin + "tcp://HOST:PORT, got tcp://127.0.0.1");
  EXPECT_EQ(refused("tcp://127.0.0.1:1"),
            begin + "a program that listens, got tcp://127.0.0.1:1: Connection refused");
}

}  // namespace impetus::markers_test
