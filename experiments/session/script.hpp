// What a session says and asks, and how its trials run: the struct that a protocol becomes.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/session/page.hpp"

namespace impetus {

struct Text {
  std::string title;
  std::vector<std::string> paragraphs;
};

struct RatingScale {
  std::string question;
  std::int64_t minimum{1};
  std::int64_t maximum{3};
  std::int64_t best{1};  ///< which end is good: minimum or maximum
  std::string low_anchor;
  std::string high_anchor;
};

struct TrialTiming {
  double fixation_ms{500.0};
  double interval_ms{700.0};  ///< blank, between trials; nothing in it is timed
};

struct FreeQuestion {
  std::string id;
  std::string text;
};

struct Script {
  std::string title;
  Text welcome;
  Text consent;
  std::string consent_statement;  ///< what is agreed to, as stored
  std::vector<Field> demographics;
  std::vector<Text> instructions;
  Text break_text;
  std::int64_t break_every{0};  ///< main trials; 0: no breaks
  std::vector<FreeQuestion> questions;
  Text thanks;
  RatingScale scale;
  TrialTiming timing;
};

}  // namespace impetus
