// Gazepoint trackers, and others that speak the Open Gaze API (version 2): lines of XML over TCP.
//
//   <SET ID="ENABLE_SEND_DATA" STATE="1" />   ──>  and what is to be in a record
//   <──  <REC TIME="12.34" BPOGX="0.51" BPOGY="0.48" BPOGV="1" />
//
// Shares of the screen from its upper left. TIME is the tracker's own, and there is no way to ask
// for it: the delay of the fastest delivery, a fraction of a millisecond on one machine, stays
// unknown.
// SPDX-License-Identifier: MIT
#include "experiments/trackers/gazepoint.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <charconv>
#include <chrono>

#include "experiments/connections/tcp.hpp"
#include "experiments/trackers/tracker_kinds.hpp"

namespace impetus::inline trackers {
namespace {

constexpr std::chrono::milliseconds kConnect{2000};
constexpr std::size_t kFirstRecords = 50;
constexpr std::int64_t kFirstRecords_ns = 2'000'000'000;

/// The number of ` NAME="..."`; none: it is not there, or no number.
std::optional<double> attribute(const std::string& line, const std::string& name) {
  const std::string start = " " + name + "=\"";
  const std::size_t found = line.find(start);
  if (found == std::string::npos) {
    return std::nullopt;
  }
  const std::size_t begin = found + start.size();
  double value = 0.0;
  const auto read = std::from_chars(line.data() + begin, line.data() + line.size(), value);
  const bool is_whole =
      read.ec == std::errc{} && read.ptr != line.data() + line.size() && *read.ptr == '"';
  return is_whole ? std::optional(value) : std::nullopt;
}

bool send_whole(int file, const std::string& text) {
  return send(file, text.data(), text.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(text.size());
}

/// What came within `wait_ms`. Throws TrackerGone.
std::string receive_some(int file, int wait_ms) {
  if (!await_file(file, POLLIN, std::chrono::milliseconds(wait_ms))) {
    return "";
  }
  char bytes[16384];
  const ssize_t count = recv(file, bytes, sizeof bytes, 0);
  if (count > 0) {
    return {bytes, static_cast<std::size_t>(count)};
  }
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) {
    return "";
  }
  throw TrackerGone("the Open Gaze server closed the connection");
}

/// Connected, and told to send.
class GazepointLink final : public TrackerLink {
 public:
  explicit GazepointLink(const TrackerAddress& address) : connection_(connected_to(address)) {
    for (const char* id : {"TIME", "POG_FIX", "POG_BEST", "DATA"}) {
      if (!send_whole(connection_.get(),
                      "<SET ID=\"ENABLE_SEND_" + std::string(id) + "\" STATE=\"1\" />\r\n")) {
        refuse_tracker(address.url, "an Open Gaze server there, which takes SET");
      }
    }
    // The fastest of many deliveries is what the clock is known by; they are given out with it.
    const std::int64_t until_ns = SteadyClock().now_ns() + kFirstRecords_ns;
    while (records_.size() < kFirstRecords && SteadyClock().now_ns() < until_ns) {
      try {
        take_records(20);
      } catch (const TrackerGone&) {
        break;
      }
    }
    if (!offset_.is_known()) {
      refuse_tracker(address.url, "records with TIME from the server there, got none in 2 s");
    }
  }

  void receive(int wait_ms, std::vector<Reading>& readings) override {
    take_records(wait_ms);
    if (records_.empty()) {
      return;
    }
    const ClockEstimate clock = offset_.estimate();
    for (GazepointRecord& record : records_) {
      record.reading.taken_ns = record.remote_ns + clock.offset_ns;
      readings.push_back(record.reading);
    }
    records_.clear();
  }

  [[nodiscard]] ClockEstimate clock() const override { return offset_.estimate(); }

 private:
  static OpenFile connected_to(const TrackerAddress& address) {
    try {
      return connect_tcp(address.host, std::to_string(address.port), kConnect);
    } catch (const NotConnected& refused) {
      refuse_tracker(
          address.url,
          std::string("Gazepoint Control or another Open Gaze server there, but nobody answers: ") +
              refused.what());
    }
  }

  /// Waits, and keeps what came.
  void take_records(int wait_ms) {
    const std::string came = receive_some(connection_.get(), wait_ms);
    const std::int64_t arrived_ns = SteadyClock().now_ns();
    for (const std::string& line : take_lines(pending_, came)) {
      if (const auto record = gazepoint_record(line)) {
        offset_.add(record->remote_ns, arrived_ns);
        records_.push_back(*record);
      }
    }
  }

  OpenFile connection_;
  std::string pending_;                   ///< of a line that has not ended
  std::vector<GazepointRecord> records_;  ///< not given out yet
  OneWayOffset offset_;
};

}  // namespace

std::optional<GazepointRecord> gazepoint_record(const std::string& line) {
  const std::size_t start = line.find_first_not_of(" \t");
  if (start == std::string::npos || line.compare(start, 5, "<REC ") != 0) {
    return std::nullopt;
  }
  const auto time_s = attribute(line, "TIME");
  const auto remote_ns = time_s ? nanoseconds(*time_s) : std::nullopt;
  if (!remote_ns) {
    return std::nullopt;
  }
  const std::string point = line.find(" BPOGX=\"") != std::string::npos ? "BPOG" : "FPOG";
  const auto x = attribute(line, point + "X");
  const auto y = attribute(line, point + "Y");
  GazepointRecord record{*remote_ns, {0, 0.0, 0.0, GazeLoss::kLost}};
  if (x && y && attribute(line, point + "V") == 1.0) {
    const bool is_on = *x >= 0.0 && *x <= 1.0 && *y >= 0.0 && *y <= 1.0;
    record.reading = {0, *x, 1.0 - *y, is_on ? GazeLoss::kNone : GazeLoss::kOffScreen};
  }
  return record;
}

std::vector<std::string> take_lines(std::string& pending, const std::string& came) {
  constexpr std::size_t kLongestLine = 1 << 16;
  pending += came;
  std::vector<std::string> lines;
  std::size_t start = 0;
  for (std::size_t end = pending.find('\n'); end != std::string::npos;
       end = pending.find('\n', start)) {
    lines.push_back(pending.substr(start, end - start - (end > start && pending[end - 1] == '\r')));
    start = end + 1;
  }
  pending.erase(0, start);
  if (pending.size() > kLongestLine) {  // no server of this kind
    pending.clear();
  }
  return lines;
}

const TrackerKind& gazepoint_tracker() {
  static const TrackerKind kind{"gazepoint",
                                "Gazepoint",
                                4242,
                                {},
                                [](const TrackerAddress& address) -> std::unique_ptr<TrackerLink> {
                                  return std::make_unique<GazepointLink>(address);
                                }};
  return kind;
}

}  // namespace impetus::inline trackers
