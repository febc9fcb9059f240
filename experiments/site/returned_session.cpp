// SPDX-License-Identifier: MIT
#include "experiments/site/returned_session.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <utility>

#include "experiments/lines/replayed_attempt.hpp"
#include "experiments/models/readable_file.hpp"
#include "experiments/protocol/participant_code.hpp"
#include "experiments/questions/level_value.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/store/session_rows.hpp"
#include "experiments/store/study_writer.hpp"
#include "experiments/study/stored_plan.hpp"

namespace impetus::inline site {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uintmax_t kMostBytes = 200'000'000;  // of one file
constexpr const char* kReturnedNote = "returned from a page";

/// Proves one session, line by line.
class Proof {
 public:
  Proof(const std::string& name, const PublishedStudy& study, const Protocol& protocol)
      : study_(study), protocol_(protocol) {
    returned_.name = name;
  }

  void take(const std::string& text) {
    ++line_;
    AnyRecord record = read(text);
    if (!replay_) {
      return begin(record);
    }
    if (auto* trial = std::get_if<PlannedTrial>(&record)) {
      returned_.plan.push_back(std::move(*trial));
      return;
    }
    require_plan();
    if (auto* attempt = std::get_if<AttemptRecord>(&record)) {
      prove(*attempt);
    } else if (const auto* chosen = std::get_if<ChosenLevel>(&record)) {
      choose(*chosen);
    } else if (std::holds_alternative<FinishedRecord>(record)) {
      returned_.finished = true;
      return;
    } else if (std::holds_alternative<SessionRecord>(record)) {
      refuse_line("expected one session, got another");
    }
    returned_.records.push_back(std::move(record));
  }

  ReturnedSession end() {
    if (!replay_) {
      refuse_line("expected a session, got no line");
    }
    require_plan();
    return std::move(returned_);
  }

 private:
  [[noreturn]] void refuse_line(const std::string& sentence) const {
    throw InputError(returned_.name + ": line " + std::to_string(line_) + ": " + sentence);
  }

  AnyRecord read(const std::string& text) {
    try {
      return record_from(json::parse(text));
    } catch (const std::exception& error) {
      refuse_line(error.what());
    }
  }

  void begin(const AnyRecord& record) {
    const auto* session = std::get_if<SessionRecord>(&record);
    if (session == nullptr) {
      refuse_line("expected the session first");
    }
    if (session->protocol_hash != protocol_.hash) {
      refuse_line("expected a session of " + protocol_.name + " (" + protocol_.hash +
                  "), got one of " + session->protocol_hash);
    }
    if (!is_participant_code(session->participant)) {
      refuse_line("expected a participant's code, got " + json(session->participant).dump());
    }
    require_screen(session->screen);
    returned_.session = *session;
    replay_.emplace(protocol_, *session);
  }

  void require_screen(const ScreenGeometry& screen) const {
    constexpr double kMost_m = 1000.0;
    for (const double length_m : {screen.width_m, screen.height_m, screen.viewing_distance_m}) {
      if (!(length_m > 0.0 && length_m <= kMost_m)) {
        refuse_line("expected a screen with sides and a viewing distance above 0 m");
      }
    }
  }

  /// The plan follows from code and seed: the page's is the program's own.
  void require_plan() {
    if (!trials_.empty()) {
      return;
    }
    const Plan plan =
        plan_of(study_, protocol_, returned_.session.participant, returned_.session.seed);
    if (plan != returned_.plan) {
      refuse_line("expected the trials that code and seed lead to, got others");
    }
    for (const PlannedTrial& trial : plan) {
      trials_[trial.slot] = trial;
    }
  }

  PlannedTrial& trial_at(std::int64_t slot) {
    const auto found = trials_.find(slot);
    if (found == trials_.end()) {
      refuse_line("expected a trial of the plan, got " + std::to_string(slot));
    }
    return found->second;
  }

  void choose(const ChosenLevel& chosen) {
    const std::vector<Condition> shown = cells(protocol_.design);
    if (std::find(shown.begin(), shown.end(), chosen.condition) == shown.end()) {
      refuse_line("trial " + std::to_string(chosen.slot) +
                  ": expected a level of the design, got " + to_json(chosen.condition).dump());
    }
    trial_at(chosen.slot).condition = chosen.condition;
  }

  void prove(AttemptRecord& attempt) {
    const std::string trial = "trial " + std::to_string(attempt.slot);
    require_bodies(attempt, trial);
    ReplayedAttempt found;
    try {
      found = replay_->replay(trial_at(attempt.slot), attempt);
    } catch (const InputError&) {
      throw;
    } catch (const std::exception& error) {
      refuse_line(trial + ": " + error.what());
    }
    if (found.divergence) {
      refuse_line("expected the states that these inputs lead to, got others from " +
                  divergence_words(attempt.slot, *found.divergence) + " on");
    }
    if (!made_.insert({attempt.slot, attempt.number}).second) {
      refuse_line(trial + ": expected each attempt once, got " + std::to_string(attempt.number) +
                  " again");
    }
    returned_.steps += found.steps;
  }

  /// What names a body names one.
  void require_bodies(const AttemptRecord& attempt, const std::string& trial) const {
    const auto bodies = static_cast<std::int32_t>(attempt.body_names.size());
    for (const CollisionRecord& collision : attempt.collisions) {
      const BodyPair& pair = collision.report.bodies;
      if (pair.a < 0 || pair.a >= bodies || pair.b >= bodies ||
          pair.b < wall_index(kWallCount - 1)) {
        refuse_line(trial + ": expected collisions of its bodies, got one of others");
      }
    }
    for (const StepRecord& step : attempt.steps) {
      for (const NotFiniteBody& found : step.not_finite) {
        if (found.body < 0 || found.body >= bodies) {
          refuse_line(trial + ": expected states of its bodies, got one of another");
        }
      }
    }
  }

  const PublishedStudy& study_;
  const Protocol& protocol_;
  ReturnedSession returned_;
  std::optional<AttemptReplay> replay_;  ///< once the session is known
  std::map<std::int64_t, PlannedTrial> trials_;
  std::set<std::pair<std::int64_t, std::int64_t>> made_;
  std::int64_t line_{0};
};

SessionFacts facts_of(const SessionRecord& session) {
  SessionFacts facts;
  facts.build = session.build;
  facts.machine = session.machine;
  facts.display = session.display;
  facts.screen = session.screen;
  facts.screen_measured = session.screen_measured;
  facts.refresh_hz = session.refresh_hz;
  facts.rounding_allowed = session.rounding_allowed;
  facts.sync = session.sync;
  facts.sync_overridden = !session.sync.passed;
  facts.gaze_source = session.gaze_source;
  return facts;
}

bool has_declined(const ReturnedSession& returned) {
  return std::any_of(returned.records.begin(), returned.records.end(), [](const AnyRecord& record) {
    const auto* question = std::get_if<QuestionRecord>(&record);
    return question != nullptr && question->kind == "consent" && question->answer == "declined";
  });
}

/// What a recorder is given of a record; the rest was for the proof.
struct Saving {
  StudyWriter& writer;

  void operator()(const SessionRecord& /*session*/) const {}
  void operator()(const PlannedTrial& /*trial*/) const {}
  void operator()(const FinishedRecord& /*finished*/) const {}
  template <typename Kept>
  void operator()(const Kept& record) const {
    writer.save(record);
  }
};

}  // namespace

std::vector<ReturnedFiles> returned_files(const fs::path& folder) {
  static const std::regex numbered(R"((.+_[^_]+)_[0-9]{4,}\.jsonl)");
  std::error_code error;
  std::map<std::string, ReturnedFiles> sessions;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string file = entry.path().filename().string();
    std::smatch parts;
    const bool is_part = std::regex_match(file, parts, numbered);
    if (is_part || entry.path().extension() == ".jsonl") {
      ReturnedFiles& session = sessions[is_part ? parts[1].str() : entry.path().stem().string()];
      session.files.push_back(entry.path());
    }
  }
  if (error || sessions.empty()) {
    throw InputError(folder.string() +
                     ": expected a folder with sessions that came back (.jsonl), " +
                     (error ? "got none: " + error.message() : "got one without"));
  }
  std::vector<ReturnedFiles> all;
  for (auto& [name, session] : sessions) {
    session.name = name;
    std::sort(session.files.begin(), session.files.end());
    // A download has all lines of its parts.
    const auto whole =
        std::find_if(session.files.begin(), session.files.end(),
                     [&](const fs::path& file) { return file.stem() == session.name; });
    if (whole != session.files.end()) {
      session.files = {*whole};
    }
    all.push_back(std::move(session));
  }
  return all;
}

ReturnedSession proved_session(const ReturnedFiles& files, const PublishedStudy& study,
                               const Protocol& protocol) {
  Proof proof(files.name, study, protocol);
  for (const fs::path& file : files.files) {
    std::string bytes;
    try {
      bytes = file_bytes(file, kMostBytes);
    } catch (const std::runtime_error& problem) {
      throw InputError(file.string() + ": expected a file that can be read, but " + problem.what());
    }
    for (std::size_t begin = 0; begin < bytes.size();) {
      const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
      if (end > begin) {
        proof.take(bytes.substr(begin, end - begin));
      }
      begin = end + 1;
    }
  }
  return proof.end();
}

void write_session(const ReturnedSession& returned, const Protocol& protocol, StudyFile& study) {
  const SessionRecord& session = returned.session;
  const ProtocolTexts texts = texts_of(protocol);
  if (find_enrolment(study, session.participant, /*simulated=*/false, texts)) {
    throw InputError(returned.name + ": expected a participant who has no session yet in " +
                     study.name() + ", got " + session.participant);
  }
  const Enrolment enrolment = enrol(study, session.participant, /*simulated=*/false, texts,
                                    session.seed, stored(returned.plan));
  StudyWriter writer(study, enrolment, facts_of(session));
  writer.save(NoteRecord{kReturnedNote, returned.name});
  for (const AnyRecord& record : returned.records) {
    std::visit(Saving{writer}, record);
  }
  if (returned.finished) {
    writer.mark_finished();
  }
  writer.end(returned.finished ? "finished" : has_declined(returned) ? "declined" : "quit");
}

}  // namespace impetus::inline site
