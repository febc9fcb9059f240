// A simulated participant for whom nothing of what is planted is there, and who is the same
// otherwise: the studies of type-I errors are made with it.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "experiments/protocol/observer_file.hpp"

namespace impetus::inline protocol {

/// For "rating": `effect` is 0, so what was seen changes no rating on average, and participants
/// differ in it as before (`effect_sd`). For "clicks": nothing is seen (`miss_rate` 1), and clicks
/// come by chance. None for other responses, or when the observer lacks the number.
std::optional<ObserverFile> without_effect(const ObserverFile& observer,
                                           const std::string& response);

}  // namespace impetus::inline protocol
