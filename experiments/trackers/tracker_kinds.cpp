// SPDX-License-Identifier: MIT
#include "experiments/trackers/tracker_kinds.hpp"

#include <algorithm>
#include <charconv>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline trackers {
namespace {

constexpr const char* kMark = "://";

const TrackerKind& kind_of(const std::string& url, const std::string& scheme) {
  std::vector<std::string> schemes;
  for (const TrackerKind* kind : tracker_kinds()) {
    if (kind->scheme == scheme) {
      return *kind;
    }
    schemes.push_back(kind->scheme + std::string(kMark) + "HOST");
  }
  refuse_tracker(url, "a file of recorded gaze or one of " + listed(schemes));
}

int port_of(const std::string& url, const std::string& words) {
  int port = 0;
  const char* end = words.data() + words.size();
  const auto read = std::from_chars(words.data(), end, port);
  if (read.ec != std::errc{} || read.ptr != end || port < 1 || port > 65535) {
    refuse_tracker(url, "a port from 1 to 65535 behind the host, got \"" + words + "\"");
  }
  return port;
}

/// "a=b&c=d"
std::map<std::string, std::string> options_of(const TrackerKind& kind, const std::string& url,
                                              const std::string& words) {
  std::map<std::string, std::string> options;
  for (std::size_t start = 0; start < words.size();) {
    const std::size_t end = std::min(words.find('&', start), words.size());
    const std::string option = words.substr(start, end - start);
    const std::size_t equals = std::min(option.find('='), option.size());
    const std::string key = option.substr(0, equals);
    if (std::find(kind.options.begin(), kind.options.end(), key) == kind.options.end() ||
        equals + 1 >= option.size()) {
      refuse_tracker(url, (kind.options.empty() ? std::string("nothing behind \"?\"")
                                                : listed(kind.options) + "=VALUE behind \"?\"") +
                              ", got \"" + option + "\"");
    }
    options[key] = option.substr(equals + 1);
    start = end + 1;
  }
  return options;
}

}  // namespace

const std::vector<const TrackerKind*>& tracker_kinds() {
  static const std::vector<const TrackerKind*> kinds = {
      &pupil_tracker(),
      &gazepoint_tracker(),
      &lsl_tracker(),
  };
  return kinds;
}

bool is_tracker_url(const std::string& given) { return given.find(kMark) != std::string::npos; }

NamedTracker parse_tracker(const std::string& url) {
  const std::size_t mark = std::min(url.find(kMark), url.size());
  NamedTracker tracker{&kind_of(url, url.substr(0, mark)), {}};
  const std::string place = url.substr(mark + 3);
  const std::size_t question = std::min(place.find('?'), place.size());
  std::string host = place.substr(0, question);
  if (!host.empty() && host.back() == '/') {
    host.pop_back();
  }
  const std::size_t colon = std::min(host.find(':'), host.size());
  TrackerAddress& address = tracker.address;
  address.url = url;
  address.host = host.substr(0, colon);
  if (address.host.empty() || address.host.find_first_of("/@ ") != std::string::npos) {
    refuse_tracker(url, "a host, such as " + std::string(tracker.kind->scheme) +
                            "://localhost:" + std::to_string(tracker.kind->port));
  }
  address.port = colon < host.size() ? port_of(url, host.substr(colon + 1)) : tracker.kind->port;
  if (question < place.size()) {
    address.options = options_of(*tracker.kind, url, place.substr(question + 1));
  }
  return tracker;
}

std::shared_ptr<Tracker> open_tracker(const std::string& url) {
  NamedTracker tracker = parse_tracker(url);
  return std::make_shared<Tracker>(*tracker.kind, std::move(tracker.address));
}

}  // namespace impetus::inline trackers
