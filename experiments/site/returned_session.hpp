// Sessions that came back from pages as files: proved, and only then written into a study file, by
// the writer of every session.
//
//   CODE_TIME_0001.jsonl, CODE_TIME_0002.jsonl, ... ──> lines ──> plan as published? hashes again?
//   CODE_TIME.jsonl (a download)                    ──┘            └─> StudyWriter ─> study.sqlite
//
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/site/session_proof.hpp"
#include "experiments/store/study_file.hpp"
#include "experiments/store/study_writer.hpp"

namespace impetus::inline site {

/// The files of one session, and what it is called by.
struct ReturnedFiles {
  std::string name;  ///< "CODE_TIME"
  std::vector<std::filesystem::path> files;
};

/// The sessions of a folder, by name, so that each participant's are in the order of time. Files
/// that do not end in .jsonl are nobody's. Throws InputError when the folder cannot be read or
/// holds no session.
std::vector<ReturnedFiles> returned_files(const std::filesystem::path& folder);

/// What came of one.
struct TakenSession {
  std::size_t records{0};
  std::int64_t steps{0};  ///< simulated again
  bool finished{false};
};

/// Proves a session and writes it into the study as a whole: whoever is stopped on the way may
/// begin anew. Throws InputError, naming the session, the trial and what differs, or that it is
/// there already; StoreError.
TakenSession take_session(const ReturnedFiles& files, const PublishedStudy& published,
                          const Protocol& protocol, StudyFile& study);

/// The lines of a part.
std::vector<std::string> lines_in(const std::string& text);

/// Gives a record to save, and marks with it how the session ends, where it says so.
void save_record(const AnyRecord& record, StudyWriter& writer);

}  // namespace impetus::inline site
