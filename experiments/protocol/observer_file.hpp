// A simulated participant from a file.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "experiments/protocol/observer_parameters.hpp"

namespace impetus::inline protocol {

struct ObserverFile {
  JsonDocument document;
  ObserverParameters parameters;

  /// Points of the rating scale that the participant answers on.
  [[nodiscard]] std::size_t points() const;
  [[nodiscard]] bool clicks() const;   ///< whether it clicks during the stimulus
  [[nodiscard]] bool has_eye() const;  ///< whether its gaze can be followed
};

/// `name_or_path`: a file, or the name of one in the observers' folder that lies beside the
/// protocol's. Throws InputError.
ObserverFile load_observer(const std::string& name_or_path, const std::filesystem::path& protocol);

/// The participant whose traits and answers follow from `seed` and `pseudonym`. Its answers advance
/// `clock`; its eye, where it has one, lives by `flip_clock`, with which flips are stamped. Both
/// must outlive it, and may be the same.
std::unique_ptr<RatingObserver> make_observer(const ObserverFile& file, std::uint64_t seed,
                                              const std::string& pseudonym, VirtualClock& clock,
                                              const Clock& flip_clock);

}  // namespace impetus::inline protocol
