// SPDX-License-Identifier: MIT
#include "experiments/site/served_study.hpp"

#include <chrono>
#include <regex>
#include <utility>
#include <vector>

#include "experiments/protocol/participant_code.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/site/session_keeping.hpp"
#include "experiments/study/stored_plan.hpp"
#include "experiments/study/taking_up.hpp"

namespace impetus::inline site {

using nlohmann::json;

/// A session that is going on.
struct ServedStudy::Sitting {
  explicit Sitting(SessionProof proving) : proof(std::move(proving)) {}

  std::mutex turn;
  bool failed{false};  ///< what was proved is no longer what is kept
  SessionProof proof;
  std::int64_t parts{0};
  std::unique_ptr<StudyWriter> writer;  ///< none: nothing is kept of it yet
  std::chrono::steady_clock::time_point used{std::chrono::steady_clock::now()};
};

PostedPart posted_part_from(const json& body) {
  static const std::regex wanted(R"(([A-Za-z0-9._-]+_[0-9A-Za-z]+)_([0-9]{4,9})\.jsonl)");
  const auto text_of = [&](const char* name) {
    const auto found = body.is_object() ? body.find(name) : body.end();
    if (!body.is_object() || found == body.end() || !found->is_string()) {
      throw InputError(std::string("expected an object with texts \"filename\", \"data\" and ") +
                       "\"key\", got none called \"" + name + "\"");
    }
    return found->get<std::string>();
  };
  const std::string file = text_of("filename");
  constexpr std::size_t kLongestName = 255;  // the expression goes as deep as its text is long
  std::smatch words;
  if (file.size() > kLongestName || !std::regex_match(file, words, wanted)) {
    throw InputError(
        "filename: expected CODE_TIME_0001.jsonl, got " +
        json(file.substr(0, kLongestName)).dump(-1, ' ', false, json::error_handler_t::replace));
  }
  constexpr std::size_t kLeastKey = 16;
  PostedPart part{words[1].str(), std::stoll(words[2].str()), text_of("data"), text_of("key")};
  if (part.key.size() < kLeastKey || part.key.size() > 100) {
    throw InputError("key: expected 16 to 100 letters, got " + std::to_string(part.key.size()));
  }
  return part;
}

ServedStudy::ServedStudy(const PublishedStudy& published, const Protocol& protocol,
                         StudyFile& study)
    : published_(published), protocol_(protocol), study_(study) {}

void ServedStudy::take(const PostedPart& part) {
  // A sitting on which another post failed while this one waited is made anew from the file.
  for (std::shared_ptr<Sitting> sitting = sitting_of(part); !take_with(*sitting, part);) {
    sitting = sitting_of(part);
  }
}

/// Whether the sitting could still take anything.
bool ServedStudy::take_with(Sitting& sitting, const PostedPart& part) {
  const std::lock_guard turn(sitting.turn);
  if (sitting.failed) {
    return false;
  }
  try {
    keep(part, sitting);
  } catch (...) {
    // What is kept is in the file alone: whoever posts next begins from there.
    sitting.failed = true;
    const std::lock_guard lock(mutex_);
    sittings_.erase(part.name);
    throw;
  }
  return true;
}

std::shared_ptr<ServedStudy::Sitting> ServedStudy::sitting_of(const PostedPart& part) {
  const std::lock_guard lock(mutex_);
  forget_the_idle();
  std::shared_ptr<Sitting>& sitting = sittings_[part.name];
  if (!sitting) {
    sitting = known_sitting(part);
  }
  if (!sitting) {
    sitting = std::make_shared<Sitting>(SessionProof(
        part.name, published_, protocol_, [this, key = part.key](const SessionRecord& session) {
          const std::lock_guard reading(study_.transactions());
          return earlier_sessions(session.participant, key);
        }));
  }
  sitting->used = std::chrono::steady_clock::now();
  return sitting;
}

/// Of pages that were closed nobody hears.
void ServedStudy::forget_the_idle() {
  constexpr std::chrono::minutes kIdle{10};
  const auto now = std::chrono::steady_clock::now();
  std::erase_if(sittings_, [&](const auto& named) {
    return named.second.use_count() == 1 && now - named.second->used > kIdle;
  });
}

/// A session of which earlier parts are kept, though nobody here remembers them; none: it is new.
std::shared_ptr<ServedStudy::Sitting> ServedStudy::known_sitting(const PostedPart& part) {
  const std::lock_guard reading(study_.transactions());
  const auto session = find_page_session(study_.database(), part.name);
  if (!session) {
    return nullptr;
  }
  auto sitting =
      std::make_shared<Sitting>(going_proof(part.name, published_, protocol_, study_, *session));
  sitting->parts = session->parts;
  sitting->writer = go_on_writing(sitting->proof, study_, *session);
  return sitting;
}

std::optional<EarlierSessions> ServedStudy::earlier_sessions(const std::string& participant,
                                                             const std::string& key) {
  auto found = find_enrolment(study_, participant, /*simulated=*/false, texts_of(protocol_));
  if (!found) {
    return std::nullopt;
  }
  if (found->history.resumed && !goes_on_by(study_.database(), found->id, key)) {
    throw NotYours("the session of " + participant +
                   " goes on by the link with which it began, and by no other");
  }
  const Plan plan = planned(found->trials, protocol_.design);
  const auto resumed = take_up(study_, protocol_, participant, plan, *found);
  return EarlierSessions{std::move(*found), resumed};
}

void ServedStudy::keep(const PostedPart& part, Sitting& sitting) {
  if (part.number <= sitting.parts) {
    return;
  }
  if (part.number > sitting.parts + 1) {
    throw InputError(part.name + ": expected part " + std::to_string(sitting.parts + 1) + ", got " +
                     std::to_string(part.number));
  }
  if (sitting.writer) {
    require_its_page(part);
  }
  std::vector<AnyRecord> records;
  for (const std::string& line : lines_in(part.lines)) {
    if (auto record = sitting.proof.take(line)) {
      records.push_back(std::move(*record));
    }
  }
  sitting.proof.require_plan();
  if (!sitting.writer) {
    begin(part.key, sitting, records);
  }
  save_parts(part.name, records, /*parts=*/1, *sitting.writer);
  ++sitting.parts;
  say_how_far(sitting, records);
}

void ServedStudy::say_how_far(const Sitting& sitting, const std::vector<AnyRecord>& records) {
  const bool finished = ends_finished(records);
  if (told_ && (sitting.parts == 1 || finished)) {
    const std::lock_guard lock(mutex_);
    told_(sitting.proof.session().participant + (finished ? " has finished" : " begins"));
  }
}

/// Whoever knows a session's name has not its key; and a page that was opened later has taken over.
void ServedStudy::require_its_page(const PostedPart& part) {
  const std::lock_guard reading(study_.transactions());
  const auto session = find_page_session(study_.database(), part.name);
  if (!session || session->key != part.key || !session->is_last) {
    throw NotYours(part.name + ": this session goes on elsewhere, or is over");
  }
}

/// What is to be said of the session goes before its first records.
void ServedStudy::begin(const std::string& key, Sitting& sitting, std::vector<AnyRecord>& records) {
  const SessionProof& proof = sitting.proof;
  const std::lock_guard reading(study_.transactions());
  const std::vector<AnyRecord> notes = screen_notes(proof, study_);
  records.insert(records.begin(), notes.begin(), notes.end());
  sitting.writer = begin_writing(proof, protocol_, study_, key);
}

json ServedStudy::standing(const std::string& participant, const std::string& key) {
  if (!is_participant_code(participant)) {
    throw InputError("expected a participant's code, got " + json(participant).dump());
  }
  const std::lock_guard reading(study_.transactions());
  if (has_finished(study_, participant, /*simulated=*/false, texts_of(protocol_))) {
    return {{"finished", true}};
  }
  auto earlier = earlier_sessions(participant, key);
  if (!earlier || !earlier->resumed) {
    return nullptr;
  }
  // Its page sets aside what is to be shown again, as this one did.
  const Enrolment& enrolment = earlier->enrolment;
  return to_json(Standing{planned(enrolment.trials, protocol_.design), enrolment.history},
                 protocol_.design);
}

}  // namespace impetus::inline site
