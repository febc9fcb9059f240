// A simulated participant's parameters from a file, each marked as sourced or assumed.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "experiments/observers/causality_observer.hpp"
#include "experiments/protocol/json_document.hpp"

namespace impetus {

struct ObserverFile {
  JsonDocument document;
  CausalityParameters parameters;
};

/// `name_or_path`: a file, or the name of one in the observers' folder that lies beside the
/// protocol's. Throws InputError.
ObserverFile load_observer(const std::string& name_or_path, const std::filesystem::path& protocol);

}  // namespace impetus
