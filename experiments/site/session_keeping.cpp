// SPDX-License-Identifier: MIT
#include "experiments/site/session_keeping.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "experiments/settings/input_error.hpp"
#include "experiments/study/stored_plan.hpp"

namespace impetus::inline site {
namespace {

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

/// Gives a record to save, and marks with it how the session ends, where it says so.
void save_record(const AnyRecord& record, StudyWriter& writer) {
  std::visit(Saving{writer}, record);
  if (const char* ending = ending_of(record)) {
    writer.set_ending(ending);
  }
}

}  // namespace

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

SessionProof going_proof(const std::string& name, const PublishedStudy& published,
                         const Protocol& protocol, StudyFile& study, const PageSession& known) {
  SessionRecord record;
  record.participant = known.participant;
  record.seed = known.seed;
  record.screen = known.screen;
  return {name, published, protocol, record, {load_enrolment(study, known.enrolment_id)}};
}

std::unique_ptr<StudyWriter> begin_writing(const SessionProof& proof, const Protocol& protocol,
                                           StudyFile& study, const std::string& key) {
  SessionFacts facts = facts_of(proof, key);
  if (proof.earlier()) {
    return std::make_unique<StudyWriter>(study, proof.earlier()->enrolment, std::move(facts));
  }
  const SessionRecord& session = proof.session();
  NewEnrolment fresh{session.participant, /*simulated=*/false, texts_of(protocol), session.seed,
                     stored(proof.plan())};
  return std::make_unique<StudyWriter>(study, std::move(fresh), std::move(facts));
}

std::unique_ptr<StudyWriter> go_on_writing(const SessionProof& proof, StudyFile& study,
                                           const PageSession& known) {
  return std::make_unique<StudyWriter>(study, proof.earlier()->enrolment, known);
}

void save_parts(const std::string& session, const std::vector<AnyRecord>& records,
                std::int64_t parts, StudyWriter& writer) {
  writer.save_whole([&] {
    for (const AnyRecord& record : records) {
      save_record(record, writer);
    }
    for (std::int64_t part = 0; part < parts; ++part) {
      writer.count_part();
    }
  });
  try {
    writer.await_saved();
  } catch (const ForbiddenRecord& forbidden) {
    throw InputError(session + ": " + forbidden.refusal());
  }
}

bool ends_finished(const std::vector<AnyRecord>& records) {
  return !records.empty() && std::holds_alternative<FinishedRecord>(records.back());
}

}  // namespace impetus::inline site
