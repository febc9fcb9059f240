// A simulated participant from a file, the same without the effect, and whether it can do what a
// protocol asks.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "experiments/observers/observer_kinds.hpp"
#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// What a file says of a simulated participant.
struct ObserverFile {
  JsonDocument document;
  const ObserverKind* kind;
  std::shared_ptr<const RatingParameters> parameters;  ///< of that kind
};

/// `name_or_path`: a file, or the name of one in the observers' folder that lies beside the
/// protocol's. Throws InputError.
ObserverFile load_observer(const std::string& name_or_path, const std::filesystem::path& protocol);

/// For "rating": `effect` is 0, so what was seen changes no rating on average, and participants
/// differ in it as before (`effect_sd`). For "clicks": nothing is seen (`miss_rate` 1), and clicks
/// come by chance. For any response of a kind whose `effect` is of all answers, that is 0. The
/// participant is the same otherwise: the studies of type-I errors are made with it. None for other
/// responses, or when the observer lacks the number.
std::optional<ObserverFile> without_effect(const ObserverFile& observer,
                                           const std::string& response);

/// The observer rates on the protocol's scale, where it has one, clicks where clicks are asked for,
/// has an eye where the gaze is followed, and goes by a factor that is there. Throws InputError.
void check_observer(const Protocol& protocol, const ObserverFile& observer);

/// Throws InputError, naming the kinds that can, where the parameters of the observer's kind cannot
/// be fitted.
void require_fittable(const ObserverFile& observer);

/// What the participant looks at: its own, or all of its kind do.
const Attention& attention_of(const ObserverFile& observer);

/// A sentence where no factor that varies changes what the observer looks at: which vary, and what
/// it looks at. "" where one does, or none varies.
std::string unseen_factors(const Protocol& protocol, const ObserverFile& observer);

/// The participant that the file and the birth make.
inline std::unique_ptr<RatingObserver> make_observer(const ObserverFile& file, const Birth& birth) {
  return file.kind->make(*file.parameters, birth);
}

}  // namespace impetus::inline protocol
