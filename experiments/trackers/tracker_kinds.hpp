// Every eye tracker that Impetus knows, by the scheme of its URL.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "experiments/trackers/tracker.hpp"

namespace impetus::inline trackers {

// Each in a source of its name.
const TrackerKind& pupil_tracker();
const TrackerKind& gazepoint_tracker();
const TrackerKind& lsl_tracker();

/// In the order in which they are listed.
const std::vector<const TrackerKind*>& tracker_kinds();

/// Whether what was given is meant for a tracker, not for a file: it has "://".
bool is_tracker_url(const std::string& given);

/// The kind and the parts of a URL. Throws InputError.
struct NamedTracker {
  const TrackerKind* kind{nullptr};
  TrackerAddress address;
};
NamedTracker parse_tracker(const std::string& url);

/// Throws InputError: what is no such URL, or where nobody answers.
std::shared_ptr<Tracker> open_tracker(const std::string& url);

}  // namespace impetus::inline trackers
