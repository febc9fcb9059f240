// What a protocol file says, row by row: its JSON Schema and what it is read into.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/protocol_file.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline protocol {

/// The protocol's JSON Schema: protocols/protocol.schema.json, as an output of the rows.
OrderedJson protocol_file_schema();

/// What the document says. Conditions have their levels in the order of the design's factors, those
/// of unknown factors last. Throws InputError where the document breaks the schema.
Protocol read_protocol(JsonDocument document);

/// Puts what the scene says in place of levels that are null: design and script are read anew.
/// Pointers that the scene lacks are left to the checks of the design.
void take_levels_of_scene(Protocol& protocol, const nlohmann::json& scene);

}  // namespace impetus::inline protocol
