// The simulated participant that --observer names: where its file is, and whether it fits.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "experiments/protocol/observer_file.hpp"

namespace impetus::inline commands {

/// The participant of this name or file: a file, one in the observers' folder beside the protocol's
/// (`file`), or one that comes with the program. Throws InputError, also where it does not fit.
ObserverFile observer_for(const Protocol& protocol, const std::filesystem::path& file,
                          const std::string& name_or_path);

/// Warns on standard error where no factor that varies changes what the observer looks at.
void tell_unseen_factors(const Protocol& protocol, const ObserverFile& observer);

}  // namespace impetus::inline commands
