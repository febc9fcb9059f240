// The kinds of response that a protocol can ask for, each declared in one place: its parameters in
// the protocol, the columns it records, and who simulates it.
//
// A new kind is a line here, its block in the protocol's schema and its table in the study's: a
// test holds the three against each other.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/session/script.hpp"

namespace impetus {

struct DeclaredValue {
  std::string name;
  std::string meaning;
};

struct ResponseKind {
  std::string name;                       ///< also the table that keeps it
  std::string protocol_key;               ///< its block of parameters in a protocol
  std::string when;                       ///< in which part of a trial
  std::vector<DeclaredValue> parameters;  ///< of that block
  std::vector<DeclaredValue> columns;     ///< recorded, beside the attempt it belongs to
  std::string simulated_by;               ///< Input's function that a simulated participant has
};

/// All kinds.
const std::vector<ResponseKind>& response_kinds();

/// The names of those that a script asks for.
std::vector<std::string> responses_of(const Script& script);

}  // namespace impetus
