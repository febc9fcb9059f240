// A session that came back from a page as lines: held against the study that was published,
// simulated again, and only then written into a study file, by the writer of every session.
//
//   CODE_TIME_0001.jsonl, CODE_TIME_0002.jsonl, ... ──> lines ──> plan as published? hashes again?
//   CODE_TIME.jsonl (a download)                    ──┘            └─> StudyWriter ─> study.sqlite
//
// What is proved is that these trials were simulated from these inputs, in this order; never that a
// person sat there.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/lines/published_study.hpp"
#include "experiments/lines/record_lines.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline site {

/// The files of one session, and what it is called by.
struct ReturnedFiles {
  std::string name;  ///< "CODE_TIME"
  std::vector<std::filesystem::path> files;
};

/// The sessions of a folder, by name. Files that do not end in .jsonl are nobody's. Throws
/// InputError when the folder cannot be read or holds no session.
std::vector<ReturnedFiles> returned_files(const std::filesystem::path& folder);

/// What a session came back with, as it was recorded.
struct ReturnedSession {
  std::string name;
  SessionRecord session;
  Plan plan;
  std::vector<AnyRecord> records;  ///< in order; digests of bodies filled in
  bool finished{false};
  std::int64_t steps{0};  ///< compared
};

/// Reads a session and proves it. Throws InputError, naming the session, the trial and what
/// differs.
ReturnedSession proved_session(const ReturnedFiles& files, const PublishedStudy& study,
                               const Protocol& protocol);

/// Writes it into a study. Throws InputError when the participant has a session there already;
/// StoreError.
void write_session(const ReturnedSession& returned, const Protocol& protocol, StudyFile& study);

}  // namespace impetus::inline site
