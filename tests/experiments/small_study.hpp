// A small study that lacks nothing: one person's finished session of a protocol of five trials.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/protocol/checks/protocol_checks.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus {

/// The shipped protocol with one practice trial and two delays, shown twice each; with another
/// `title` it is another version of it, with another `name` another protocol.
inline Protocol small_protocol(const std::string& title = "small",
                               const std::string& name = "causality") {
  const Protocol shipped = causality();
  nlohmann::json changed = shipped.document.value;
  changed["name"] = name;
  changed["title"] = title;
  nlohmann::json& design = changed["design"];
  design["repetitions"] = 2;
  design["factors"][0]["levels"] = {0, 100};
  design["factors"][1]["levels"] = {10};
  design["factors"][2]["levels"] = {0};
  design["practice"].erase(design["practice"].begin() + 1, design["practice"].end());
  return make_protocol(parse_json("small.json", changed.dump()), shipped.scene);
}

inline constexpr const char* kSmallTrials = "5";  // 1 of practice, 2 × 2 that count

/// Runs a session of what is left of the plan; `on_page` answers, or ends it.
inline void run_sitting(StudyFile& study, Enrolment& enrolment, const Protocol& protocol,
                        const Plan& plan, const SessionFacts& said,
                        const std::function<Answer(const Page&)>& on_page = {}) {
  TestLab lab(60.0, protocol);
  lab.input.on_page = on_page;
  StudyWriter writer(study, enrolment, said);
  const Ports ports{lab.display, lab.input, lab.scenes, writer, nullptr, &lab.clock, &lab.clock};
  const SessionResult result =
      run_session(protocol.script, plan, enrolment.history, ports, protocol.design);
  writer.end(result.ending == SessionEnding::kFinished ? "finished" : "quit");
}

/// Enrols a person in the study and runs the whole session.
inline void add_person(StudyFile& study, const Protocol& protocol, const std::string& pseudonym) {
  const Plan plan = plan_for(protocol, pseudonym, 1);
  Enrolment enrolment = enrol(study, pseudonym, false, texts_of(protocol), 1, stored(plan));
  run_sitting(study, enrolment, protocol, plan, facts());
}

/// A closed study file of these people.
inline std::filesystem::path small_study(const std::filesystem::path& path,
                                         const std::vector<std::string>& people = {"P01"},
                                         const Protocol& protocol = small_protocol()) {
  StudyFile study = opened(path);
  for (const std::string& pseudonym : people) {
    add_person(study, protocol, pseudonym);
  }
  return path;
}

/// Changes a study as no program of ours would: no constraint is in the way.
inline void tamper(const std::filesystem::path& path, const std::string& sql) {
  SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
  database.exec("PRAGMA ignore_check_constraints = ON");
  database.exec(sql);
}

}  // namespace impetus
