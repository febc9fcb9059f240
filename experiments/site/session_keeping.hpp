// How a session that is proved comes into a study file, whichever way it was handed over.
//
//   lines ──SessionProof──> records ──save_parts()──> session, and enrolment where it is the first:
//                                                     all of it or nothing
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "experiments/site/session_proof.hpp"
#include "experiments/store/study_file.hpp"
#include "experiments/store/study_writer.hpp"

namespace impetus::inline site {

/// The lines of a part.
std::vector<std::string> lines_in(const std::string& text);

/// Goes on with the proof of a session of which the study has some. Throws SQLite::Exception.
SessionProof going_proof(const std::string& name, const PublishedStudy& published,
                         const Protocol& protocol, StudyFile& study, const PageSession& known);

/// Begins to write a session whose plan is proved. Nothing is in the study before its first parts
/// are saved; with them a participant who is new is enrolled.
std::unique_ptr<StudyWriter> begin_writing(const SessionProof& proof, const Protocol& protocol,
                                           StudyFile& study, const std::string& key);

/// Goes on writing the session of a proof that goes on.
std::unique_ptr<StudyWriter> go_on_writing(const SessionProof& proof, StudyFile& study,
                                           const PageSession& known);

/// Saves the records of so many parts, and with them how the session ends, where they say so: as
/// one, or nothing of it. Returns once they are kept. Throws InputError, naming the session and the
/// place, when the study's tables forbid one; StoreError.
void save_parts(const std::string& session, const std::vector<AnyRecord>& records,
                std::int64_t parts, StudyWriter& writer);

/// Whether the participant has done everything with these records.
bool ends_finished(const std::vector<AnyRecord>& records);

}  // namespace impetus::inline site
