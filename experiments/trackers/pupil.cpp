// Pupil Core and Pupil Invisible, by the network API of Pupil Capture and Pupil Service.
//
//   Pupil Remote (REQ)  "SUB_PORT" ──> the port of what is published
//                       "t"        ──> the tracker's time, asked for again every half second
//                       When nothing is published for a second, the port is asked for again: it is
//                       another one after Pupil Capture was started anew.
//   published (SUB)     surfaces.NAME ──> MessagePack: gaze_on_surfaces [{norm_pos, timestamp,
//                                         confidence, on_surf}], origin at the lower left
//
// The surface is the screen, defined in Pupil Capture by markers at its edges. Gaze in the image of
// the world camera ("gaze.") says nothing of the screen. (docs.pupil-labs.com/core/developer)
// SPDX-License-Identifier: MIT
#include "experiments/trackers/pupil.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/trackers/tracker_kinds.hpp"
#include "experiments/trackers/zeromq.hpp"

namespace impetus::inline trackers {
namespace {

using nlohmann::json;

constexpr const char* kPort = "SUB_PORT";
constexpr int kFirstAnswer_ms = 2000;
constexpr int kFirstTimes = 20;
constexpr std::int64_t kBetweenTimes_ns = 500'000'000;
constexpr std::int64_t kLongestAnswer_ns = 1'000'000'000;
constexpr std::int64_t kQuiet_ns = 1'000'000'000;

/// Ends the reading of a message that goes deeper than any of Pupil's: the library that makes
/// values of it calls itself for every list in a list, and the stack has an end.
class DepthLimit final : public nlohmann::json_sax<json> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return goes_deeper(); }
  bool key(string_t&) override { return true; }
  bool end_object() override { return comes_up(); }
  bool start_array(std::size_t) override { return goes_deeper(); }
  bool end_array() override { return comes_up(); }
  bool parse_error(std::size_t, const std::string&, const json::exception&) override {
    return false;
  }

 private:
  bool goes_deeper() {
    constexpr int kDeepest = 32;
    return ++depth_ <= kDeepest;
  }
  bool comes_up() {
    --depth_;
    return true;
  }

  int depth_{0};
};

/// Null: it cannot be read.
json message_from(const std::string& bytes) {
  DepthLimit limit;
  return json::sax_parse(bytes, &limit, json::input_format_t::msgpack)
             ? json::from_msgpack(bytes, /*strict=*/true, /*allow_exceptions=*/false)
             : json();
}

std::optional<double> number_at(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? std::optional(found->get<double>())
                                                     : std::nullopt;
}

bool is_on_surface(const json& gaze) {
  const auto found = gaze.find("on_surf");
  return found != gaze.end() && found->is_boolean() && found->get<bool>();
}

std::optional<Reading> gaze_reading(const json& gaze, const ClockEstimate& clock) {
  if (!gaze.is_object()) {
    return std::nullopt;
  }
  const auto time_s = number_at(gaze, "timestamp");
  const auto remote_ns = time_s ? nanoseconds(*time_s) : std::nullopt;
  if (!remote_ns) {
    return std::nullopt;
  }
  Reading reading{*remote_ns + clock.offset_ns, 0.0, 0.0, GazeLoss::kLost};
  const auto place = gaze.find("norm_pos");
  const bool has_place = place != gaze.end() && place->is_array() && place->size() == 2 &&
                         (*place)[0].is_number() && (*place)[1].is_number() &&
                         std::isfinite((*place)[0].get<double>() + (*place)[1].get<double>());
  if (has_place && number_at(gaze, "confidence").value_or(0.0) >= kLeastConfidence) {
    reading.x_share = (*place)[0].get<double>();
    reading.y_share = (*place)[1].get<double>();
    reading.loss = is_on_surface(gaze) ? GazeLoss::kNone : GazeLoss::kOffScreen;
  }
  return reading;
}

/// Connected to Pupil Remote and to what is published.
class PupilLink final : public TrackerLink {
 public:
  explicit PupilLink(const TrackerAddress& address)
      : host_("tcp://" + address.host + ":"),
        surface_(surface_of(address)),
        remote_(ZeroMqKind::kRequest, host_ + std::to_string(address.port)),
        port_(port_of_published(address)),
        published_(ZeroMqKind::kSubscribe, host_ + port_) {
    published_.subscribe("surfaces." + surface_);
    for (int i = 0; i < kFirstTimes; ++i) {
      ask("t");
      await_message({&remote_}, kFirstAnswer_ms);
      take_answer();
      if (!offset_.is_known()) {
        refuse_tracker(address.url, "the time of Pupil Remote in answer to \"t\", got none");
      }
    }
    published_ns_ = asked_ns_;
  }

  void receive(int wait_ms, std::vector<Reading>& readings) override {
    await_message({&remote_, &published_}, wait_ms);
    take_answer();
    const std::int64_t now_ns = SteadyClock().now_ns();
    if (now_ns - asked_ns_ > (asked_.empty() ? kBetweenTimes_ns : kLongestAnswer_ns)) {
      const bool is_quiet = now_ns - published_ns_ > kQuiet_ns;
      ask(is_quiet && !asked_port_ ? kPort : "t");
    }
    while (const auto parts = published_.receive()) {
      published_ns_ = now_ns;
      if (parts->size() > 1) {
        const auto more = surface_readings((*parts)[1], surface_, offset_.estimate());
        readings.insert(readings.end(), more.begin(), more.end());
      }
    }
  }

  [[nodiscard]] ClockEstimate clock() const override { return offset_.estimate(); }

 private:
  static std::string surface_of(const TrackerAddress& address) {
    const auto topic = address.options.find("topic");
    if (topic != address.options.end() && topic->second != "surfaces") {
      refuse_tracker(address.url,
                     "the topic surfaces, for gaze in the world camera's image cannot be mapped "
                     "to the screen; define a surface around it in Pupil Capture");
    }
    const auto surface = address.options.find("surface");
    return surface != address.options.end() ? surface->second : "screen";
  }

  std::string port_of_published(const TrackerAddress& address) {
    remote_.send(kPort);
    await_message({&remote_}, kFirstAnswer_ms);
    const auto answer = remote_.receive();
    if (!answer) {
      refuse_tracker(address.url,
                     "Pupil Capture or Pupil Service with Pupil Remote there, but nobody answers");
    }
    const std::string& port = answer->front();
    if (port.empty() || port.find_first_not_of("0123456789") != std::string::npos) {
      refuse_tracker(address.url, "Pupil Remote there, which answers SUB_PORT with a port");
    }
    return port;
  }

  void ask(const std::string& question) {
    asked_ns_ = SteadyClock().now_ns();
    if (!asked_.empty() || !remote_.send(question)) {
      throw TrackerGone("Pupil Remote does not answer");
    }
    asked_ = question;
    asked_port_ = question == kPort;
  }

  void take_answer() {
    const auto answer = asked_.empty() ? std::nullopt : remote_.receive();
    if (!answer) {
      return;
    }
    const std::int64_t received_ns = SteadyClock().now_ns();
    asked_.clear();
    if (!asked_port_) {
      take_time(answer->front(), received_ns);
    } else if (answer->front() != port_) {
      throw TrackerGone("Pupil publishes elsewhere");
    }
  }

  void take_time(const std::string& words, std::int64_t received_ns) {
    double time_s = 0.0;
    const auto read = std::from_chars(words.data(), words.data() + words.size(), time_s);
    const auto remote_ns = read.ec == std::errc{} ? nanoseconds(time_s) : std::nullopt;
    if (remote_ns) {
      offset_.add(asked_ns_, *remote_ns, received_ns);
    }
  }

  std::string host_;
  std::string surface_;
  ZeroMqSocket remote_;
  std::string port_;  ///< of what is published
  ZeroMqSocket published_;
  RoundTripOffset offset_;
  std::string asked_;       ///< and not answered yet; "": nothing
  bool asked_port_{false};  ///< the last time, not the time
  std::int64_t asked_ns_{0};
  std::int64_t published_ns_{0};  ///< the last message
};

}  // namespace

std::vector<Reading> surface_readings(const std::string& message, const std::string& surface,
                                      const ClockEstimate& clock) {
  std::vector<Reading> readings;
  const json read = message_from(message);
  if (!read.is_object() || read.value("name", json()) != surface) {
    return readings;
  }
  const auto gazes = read.find("gaze_on_surfaces");
  if (gazes == read.end() || !gazes->is_array()) {
    return readings;
  }
  for (const json& gaze : *gazes) {
    if (const auto reading = gaze_reading(gaze, clock)) {
      readings.push_back(*reading);
    }
  }
  std::stable_sort(readings.begin(), readings.end(), [](const Reading& one, const Reading& other) {
    return one.taken_ns < other.taken_ns;
  });
  return readings;
}

const TrackerKind& pupil_tracker() {
  static const TrackerKind kind{"pupil",
                                "Pupil",
                                50020,
                                {"surface", "topic"},
                                [](const TrackerAddress& address) -> std::unique_ptr<TrackerLink> {
                                  return std::make_unique<PupilLink>(address);
                                }};
  return kind;
}

}  // namespace impetus::inline trackers
