// The language that a protocol names: one that comes with the program, or a lab's own file beside
// it, which the protocol then holds, as a study file keeps it. Its own texts stand in place of
// others.
//
//   "language": "de"                     "language": "languages/nl.json"
//   "texts": {"continue": "Weiter", "practice_advice": ""}
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>

#include "experiments/languages/language.hpp"
#include "experiments/protocol/protocol_file.hpp"
#include "experiments/settings/json_document.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline protocol {

/// The protocol's settings of language.
RowList<Protocol> language_rows();

/// Where the document, read from `path`, names a file as its language, what that says is put into
/// it. Throws InputError where there is no such file, or no language in it that is complete and can
/// be shown.
void hold_language(JsonDocument& protocol, const std::filesystem::path& path);

/// The language that the document holds or names, with the document's own texts; English when it
/// names none. Throws InputError.
Language language_of(const JsonDocument& protocol);

/// Letters beyond kShownLetters of all that participants read: the window needs a font for them.
std::set<std::uint16_t> wide_letters(const Protocol& protocol);

}  // namespace impetus::inline protocol
