// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/text_checks.hpp"

#include <cstdio>
#include <string>
#include <string_view>

#include "experiments/record/shown_letters.hpp"
#include "experiments/tables/plain_text.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

bool is_shown(std::uint32_t code) {
  return is_shown_letter(code) || code == '\n' || code == '\r' || code == '\t';
}

void check_text(const JsonDocument& protocol, const json::json_pointer& place,
                std::string_view text) {
  for (int letter = 1; !text.empty(); ++letter) {
    const auto point = first_code_point(text);
    if (!point) {
      return;  // the parser takes UTF-8 alone
    }
    if (!is_shown(point->value)) {
      char code[16];
      std::snprintf(code, sizeof code, "U+%04X", static_cast<unsigned>(point->value));
      refuse(protocol, place.to_string(),
             std::string("expected letters that screens can show (Latin, Greek, Cyrillic, signs), "
                         "got ") +
                 code + " as character " + std::to_string(letter));
    }
    text.remove_prefix(point->bytes);
  }
}

/// Values of the scene, which nobody reads.
bool is_setting(const std::string& key) { return key == "set" || key == "standard"; }

void check_texts_in(const JsonDocument& protocol, const json::json_pointer& place,
                    const json& value) {
  if (value.is_string()) {
    check_text(protocol, place, value.get_ref<const std::string&>());
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      check_texts_in(protocol, place / i, value[i]);
    }
  } else if (value.is_object()) {
    for (auto entry = value.begin(); entry != value.end(); ++entry) {
      if (!is_setting(entry.key())) {
        check_texts_in(protocol, place / entry.key(), entry.value());
      }
    }
  }
}

}  // namespace

void check_texts(const JsonDocument& protocol) {
  for (const char* part : {"session", "rating", "yes_no", "two_interval", "free_text"}) {
    if (protocol.value.contains(part)) {
      check_texts_in(protocol, json::json_pointer() / part, protocol.value[part]);
    }
  }
}

}  // namespace impetus::inline protocol
