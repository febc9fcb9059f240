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

/// What the document says, which keeps to the schema; without the words of its language.
Protocol protocol_of(const nlohmann::json& document);

}  // namespace impetus::inline protocol
