// SPDX-License-Identifier: MIT
#include "experiments/site/returned_session.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <regex>
#include <utility>

#include "experiments/models/readable_file.hpp"
#include "experiments/session/resumption.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/site/session_keeping.hpp"
#include "experiments/study/stored_plan.hpp"
#include "experiments/tables/number_text.hpp"

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

std::string part_name(const std::string& session, std::int64_t number) {
  return session + printed("_%04lld.jsonl", static_cast<long long>(number));
}

/// What is to be read of a session of which so many parts are kept. Throws InputError where the
/// next one is missing, or there twice.
std::vector<fs::path> files_after(std::int64_t kept, const ReturnedFiles& files) {
  if (files.whole) {
    return {*files.whole};
  }
  std::vector<fs::path> next;
  for (const ReturnedPart& part : files.parts) {
    const bool is_kept = part.number >= 1 && part.number <= kept;
    const std::int64_t wanted = kept + static_cast<std::int64_t>(next.size()) + 1;
    if (!is_kept && part.number != wanted) {
      throw InputError(files.name + ": expected " + part_name(files.name, wanted) + " next, got " +
                       part.file.filename().string());
    }
    if (!is_kept) {
      next.push_back(part.file);
    }
  }
  return next;
}

/// A session that is there already goes on where there is more of it and nobody went on since.
void require_going(const ReturnedFiles& files, const PageSession& known, bool has_more,
                   const Protocol& protocol, StudyFile& study) {
  if (!has_more) {
    throw InputError(files.name + ": expected a session that is not in " + study.name() +
                     " yet, got one that is");
  }
  const auto enrolment =
      find_enrolment(study, known.participant, /*simulated=*/false, texts_of(protocol));
  if (!enrolment || enrolment->id != known.enrolment_id) {
    throw InputError(files.name + ": expected a session of " + protocol.name + " in " +
                     study.name() + ", got one of another protocol");
  }
  if (!known.is_last) {
    throw InputError(files.name + ": expected the last session of " + known.participant + " in " +
                     study.name() + " to go on from part " + std::to_string(known.parts + 1) +
                     ", got one after which another began");
  }
}

/// The proof of what is to be taken: of a session that is new, or that goes on.
SessionProof proof_of(const ReturnedFiles& files, const std::optional<PageSession>& known,
                      const PublishedStudy& published, const Protocol& protocol, StudyFile& study) {
  if (known) {
    return going_proof(files.name, published, protocol, study, *known);
  }
  return {files.name, published, protocol,
          [&](const SessionRecord& session) { return earlier_sessions(study, protocol, session); }};
}

std::vector<AnyRecord> proved_records(const std::vector<fs::path>& files, SessionProof& proof) {
  std::vector<AnyRecord> records;
  for (const fs::path& file : files) {
    for (const std::string& line : lines_in(text_of(file))) {
      if (auto record = proof.take(line)) {
        records.push_back(std::move(*record));
      }
    }
  }
  proof.require_plan();
  return records;
}

/// By number; whichever number is too large for one comes last.
ReturnedPart numbered_part(const fs::path& file, const std::string& digits) {
  ReturnedPart part{std::numeric_limits<std::int64_t>::max(), file};
  std::from_chars(digits.data(), digits.data() + digits.size(), part.number);
  return part;
}

}  // namespace

std::vector<ReturnedFiles> returned_files(const fs::path& folder) {
  static const std::regex numbered(R"((.+_[^_]+)_([0-9]{4,})\.jsonl)");
  std::error_code error;
  std::map<std::string, ReturnedFiles> sessions;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string file = entry.path().filename().string();
    std::smatch words;
    if (std::regex_match(file, words, numbered)) {
      sessions[words[1].str()].parts.push_back(numbered_part(entry.path(), words[2].str()));
    } else if (entry.path().extension() == ".jsonl") {
      sessions[entry.path().stem().string()].whole = entry.path();
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
    std::sort(session.parts.begin(), session.parts.end());
    all.push_back(std::move(session));
  }
  return all;
}

TakenSession take_session(const ReturnedFiles& files, const PublishedStudy& published,
                          const Protocol& protocol, StudyFile& study) {
  const auto known = find_page_session(study.database(), files.name);
  const std::int64_t kept = known ? known->parts : 0;
  const std::vector<fs::path> next = files_after(kept, files);
  if (known) {
    require_going(files, *known, /*has_more=*/!files.whole && !next.empty(), protocol, study);
  }
  SessionProof proof = proof_of(files, known, published, protocol, study);
  const std::vector<AnyRecord> records = proved_records(next, proof);
  std::vector<AnyRecord> all = known ? std::vector<AnyRecord>{} : screen_notes(proof, study);
  all.insert(all.end(), records.begin(), records.end());
  const auto parts = static_cast<std::int64_t>(next.size());
  const auto writer = known ? go_on_writing(proof, study, *known)
                            : begin_writing(proof, protocol, study, /*key=*/"");
  save_parts(files.name, all, parts, *writer);
  return {files.whole ? 0 : kept + 1, kept + parts, records.size(), proof.steps(),
          ends_finished(records)};
}

}  // namespace impetus::inline site
