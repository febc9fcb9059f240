// Sessions that came back from pages as files: proved, and only then written into a study file, by
// the writer of every session.
//
//   CODE_TIME_0001.jsonl, CODE_TIME_0002.jsonl, ... ──> lines ──> plan as published? hashes again?
//   CODE_TIME.jsonl (a download)                    ──┘            └─> StudyWriter ─> study.sqlite
//
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/site/session_proof.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline site {

/// A file with a part of a session.
struct ReturnedPart {
  std::int64_t number{1};
  std::filesystem::path file;

  auto operator<=>(const ReturnedPart&) const = default;
};

/// The files of one session, and what it is called by.
struct ReturnedFiles {
  std::string name;                              ///< "CODE_TIME"
  std::optional<std::filesystem::path> whole{};  ///< a download: it has all lines of the parts
  std::vector<ReturnedPart> parts{};             ///< by number
};

/// The sessions of a folder, by name, so that each participant's are in the order of time. Files
/// that do not end in .jsonl are nobody's. Throws InputError when the folder cannot be read or
/// holds no session.
std::vector<ReturnedFiles> returned_files(const std::filesystem::path& folder);

/// What came of one.
struct TakenSession {
  std::int64_t first_part{0};  ///< that was taken; 0: the whole download was
  std::int64_t last_part{0};
  std::size_t records{0};
  std::int64_t steps{0};  ///< simulated again
  bool finished{false};
};

/// Proves a session and writes it into the study as a whole: whoever is stopped on the way may
/// begin anew. Of one that is there already, as the participant's last, the parts are taken that
/// came after those that are there. Throws InputError, naming the session, the trial and what
/// differs, the part that is missing, or that it is there already; then nothing of it is in the
/// study, its participant neither. StoreError.
TakenSession take_session(const ReturnedFiles& files, const PublishedStudy& published,
                          const Protocol& protocol, StudyFile& study);

}  // namespace impetus::inline site
