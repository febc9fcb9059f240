// A whole session as a page hands it over, and the study it is of.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/lines/published_study.hpp"
#include "experiments/lines/record_lines.hpp"
#include "experiments/lines/standing.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus {

inline constexpr std::uint64_t kPageSeed = 7;
inline constexpr const char* kPageName = "P01_20260102T030405006Z";

/// The causality study, each condition once.
inline PublishedStudy short_causality() {
  nlohmann::json protocol = nlohmann::json::parse(text_of(source_file("protocols/causality.json")));
  protocol["design"]["repetitions"] = 1;
  return {protocol.dump(), text_of(source_file("stimuli/two-spheres.json")), {}, "this test"};
}

/// What a page does with a record: a line each.
class LineRecorder final : public Recorder {
 public:
  void save(AttemptRecord attempt) override { keep(std::move(attempt)); }
  void save(QuestionRecord answer) override { keep(std::move(answer)); }
  void save(NoteRecord note) override { keep(std::move(note)); }
  void save(ChosenLevel chosen) override { keep(std::move(chosen)); }
  void save(CalibrationRecord calibration) override { keep(std::move(calibration)); }
  void mark_finished() override { keep(FinishedRecord{}); }
  void await_saved() override {}
  void keep(AnyRecord record) { lines.push_back(line_of(record)); }

  std::vector<std::string> lines;
};

/// What a page says of itself.
inline SessionRecord page_facts(const PublishedStudy& study, const Protocol& protocol,
                                const std::string& code) {
  SessionRecord session;
  session.participant = code;
  session.seed = kPageSeed;
  session.protocol_hash = protocol.hash;
  session.build = study.build;
  session.machine = "a browser";
  session.display = "a page";
  session.screen = assumed_screen();
  session.refresh_hz = 60.0;
  session.sync.passed = true;
  return session;
}

/// The lines of a participant's session from where they stand, null: from the start, as the page
/// would hand them over.
inline std::vector<std::string> lines_from(const PublishedStudy& study,
                                           const nlohmann::json& standing,
                                           const std::string& code = "P01") {
  TestLab lab(60.0, protocol_of(study, std::make_shared<ShapeLibrary>()));
  LineRecorder recorder;
  recorder.keep(page_facts(study, lab.protocol, code));
  const Plan plan = plan_of(study, lab.protocol, code, kPageSeed);
  for (const PlannedTrial& trial : plan) {
    recorder.keep(trial);
  }
  const Standing begun =
      standing.is_null() ? Standing{plan, {}} : standing_from(standing, plan, lab.protocol.design);
  const Ports ports{lab.display, lab.input, lab.scenes, recorder};
  run_session(lab.protocol.script, begun.plan, begun.history, ports, lab.protocol.design);
  return recorder.lines;
}

/// A whole session of the short causality study.
inline const std::vector<std::string>& session_lines() {
  static const std::vector<std::string> lines = lines_from(short_causality(), {});
  return lines;
}

inline constexpr const char* kPageKey = "0123456789abcdef";

/// What a page posts.
struct PagePart {
  std::string name;
  std::int64_t number{1};
  std::string lines;
};

/// A session's lines as its page posts them: whatever came up to the end of a trial.
inline std::vector<PagePart> parts_of(const std::vector<std::string>& lines,
                                      const std::string& name) {
  std::vector<PagePart> parts;
  bool open = false;
  for (const std::string& line : lines) {
    if (!open) {
      parts.push_back({name, static_cast<std::int64_t>(parts.size()) + 1, ""});
    }
    parts.back().lines += line + "\n";
    open = nlohmann::json::parse(line)["kind"] != "attempt";
  }
  return parts;
}

inline std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) {
    text += line + "\n";
  }
  return text;
}

/// The line of an attempt with another rating than its participant gave.
inline std::string with_rating(const std::string& attempt, int rating) {
  nlohmann::json line = nlohmann::json::parse(attempt);
  nlohmann::json& columns = line["ratings"][0];
  const auto place = std::find(columns.begin(), columns.end(), "rating") - columns.begin();
  line["ratings"][1][static_cast<std::size_t>(place)] = rating;
  return line.dump();
}

/// What the tables say to a rating beyond its scale.
inline constexpr const char* kForbiddenRating =
    ": expected values that a study may hold, got others (CHECK constraint failed: minimum < "
    "maximum AND rating BETWEEN minimum AND maximum)";

/// The place of the n-th line of a kind.
inline std::size_t line_of_kind(const std::string& kind, std::size_t number = 0) {
  const std::vector<std::string>& lines = session_lines();
  for (std::size_t at = 0; at < lines.size(); ++at) {
    if (nlohmann::json::parse(lines[at])["kind"] == kind && number-- == 0) {
      return at;
    }
  }
  ADD_FAILURE() << "no such line";
  return 0;
}

}  // namespace impetus
