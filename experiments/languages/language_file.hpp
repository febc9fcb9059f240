// Languages as files: those that come with the program, a lab's own, and single texts in their
// place.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "experiments/languages/language.hpp"
#include "experiments/settings/json_document.hpp"

namespace impetus::inline languages {

/// The languages that come with the program, by the names of their files: "de", "en", ...
const std::map<std::string, Language>& shipped_languages();

const Language& english();

/// The language that stands in a document at a place, "" for the whole file. It is complete, keeps
/// the placeholders of the English texts, and presses different keys on one page; otherwise this
/// throws InputError.
Language read_language(const JsonDocument& document, const std::string& place = "");

/// The same of one that a study has stored, perhaps before a text was added: English has what it
/// lacks.
Language read_stored_language(const JsonDocument& document, const std::string& place);

/// The language with the texts at a place of the document in place of its own. An empty one
/// switches a text off. Throws InputError where there is no such text, it lacks a placeholder, or a
/// button or key would be without a name.
Language with_texts(const Language& language, const JsonDocument& document,
                    const std::string& place);

}  // namespace impetus::inline languages
