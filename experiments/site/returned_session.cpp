// SPDX-License-Identifier: MIT
#include "experiments/site/returned_session.hpp"

#include <algorithm>
#include <map>
#include <regex>
#include <utility>

#include "experiments/models/readable_file.hpp"
#include "experiments/session/resumption.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/study/stored_plan.hpp"

namespace impetus::inline site {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = 200'000'000;  // of one file

/// What is there of the participant. When the session was left and taken up again nobody knows any
/// more: the page kept to the protocol's rule.
std::optional<EarlierSessions> earlier_sessions(StudyFile& study, const Protocol& protocol,
                                                const SessionRecord& session) {
  auto found = find_enrolment(study, session.participant, /*simulated=*/false, texts_of(protocol));
  if (!found) {
    return std::nullopt;
  }
  EarlierSessions earlier{std::move(*found)};
  if (earlier.enrolment.history.resumed) {
    const Plan plan = planned(earlier.enrolment.trials, protocol.design);
    earlier.resumed = ResumedSession{protocol.script.resume.at, std::nullopt,
                                     resume(protocol.script, plan, earlier.enrolment.history)};
  }
  return earlier;
}

std::string text_of(const fs::path& file) {
  try {
    return file_bytes(file, kMostBytes);
  } catch (const std::runtime_error& problem) {
    throw InputError(file.string() + ": expected a file that can be read, but " + problem.what());
  }
}

void require_not_taken(const ReturnedFiles& files, StudyFile& study) {
  if (find_page_session(study.database(), files.name)) {
    throw InputError(files.name + ": expected a session that is not in " + study.name() +
                     " yet, got one that is");
  }
}

/// How a record says that its session ended; none: it does not.
const char* ending_of(const AnyRecord& record) {
  if (std::holds_alternative<FinishedRecord>(record)) {
    return "finished";
  }
  if (const auto* note = std::get_if<NoteRecord>(&record)) {
    return note->kind == "quit" ? "quit" : note->kind == kSyncTestFailedNote ? "failed" : nullptr;
  }
  const auto* question = std::get_if<QuestionRecord>(&record);
  const bool declined =
      question != nullptr && question->kind == "consent" && question->answer == "declined";
  return declined ? "declined" : nullptr;
}

/// What a recorder is given of a record; the rest was for the proof.
struct Saving {
  StudyWriter& writer;

  void operator()(const SessionRecord& /*session*/) const {}
  void operator()(const PlannedTrial& /*trial*/) const {}
  void operator()(const FinishedRecord& /*finished*/) const { writer.mark_finished(); }
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
    const auto whole = std::find_if(
        session.files.begin(), session.files.end(),
        [&named = session](const fs::path& file) { return file.stem() == named.name; });
    if (whole != session.files.end()) {
      session.files = {*whole};
    }
    all.push_back(std::move(session));
  }
  return all;
}

std::vector<std::string> lines_in(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end > begin) {
      lines.push_back(text.substr(begin, end - begin));
    }
    begin = end + 1;
  }
  return lines;
}

void save_record(const AnyRecord& record, StudyWriter& writer) {
  std::visit(Saving{writer}, record);
  if (const char* ending = ending_of(record)) {
    writer.set_ending(ending);
  }
}

TakenSession take_session(const ReturnedFiles& files, const PublishedStudy& published,
                          const Protocol& protocol, StudyFile& study) {
  require_not_taken(files, study);
  SessionProof proof(files.name, published, protocol, [&](const SessionRecord& session) {
    return earlier_sessions(study, protocol, session);
  });
  std::vector<AnyRecord> records;
  for (const fs::path& file : files.files) {
    for (const std::string& line : lines_in(text_of(file))) {
      if (auto record = proof.take(line)) {
        records.push_back(std::move(*record));
      }
    }
  }
  proof.require_plan();
  const Enrolment enrolment =
      proof.earlier() ? proof.earlier()->enrolment
                      : enrol(study, proof.session().participant, /*simulated=*/false,
                              texts_of(protocol), proof.session().seed, stored(proof.plan()));
  const std::vector<AnyRecord> notes = screen_notes(proof, study);
  StudyWriter writer(study, enrolment, facts_of(proof, /*key=*/""));
  writer.save_whole([&] {
    for (const AnyRecord& note : notes) {
      save_record(note, writer);
    }
    for (const AnyRecord& record : records) {
      save_record(record, writer);
    }
    for (std::size_t part = 0; part < files.files.size(); ++part) {
      writer.count_part();
    }
  });
  writer.await_saved();
  return {records.size(), proof.steps(),
          !records.empty() && std::holds_alternative<FinishedRecord>(records.back())};
}

}  // namespace impetus::inline site
