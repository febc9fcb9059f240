// A study file that takes part in a merge: opened unused and whole, with what identifies it.
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "experiments/store/read_only_file.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline store {

/// A file that was merged into the study before.
struct EarlierMerge {
  std::string name;
  std::string merged_utc;

  bool operator==(const EarlierMerge&) const = default;
};

/// What studies are compared by before they are merged.
struct StudyIdentity {
  std::map<std::string, std::set<std::string>> protocols{};  ///< hashes of versions, by name
  std::set<std::string> pseudonyms{};
  std::map<std::string, EarlierMerge> merged{};  ///< by hash

  bool operator==(const StudyIdentity&) const = default;
};

StudyIdentity identity_of(StudyFile& study);

/// One study of a merge, locked against sessions for as long as this lives.
struct MergePart {
  ReadingLock lock;  ///< before the study: it must go after it
  StudyFile study;
  std::string hash;  ///< of the file's bytes and its log's
  StudyIdentity identity;
};

/// What identifies a study: the hash of the file's bytes and its log's.
std::string hash_of_file(const std::filesystem::path& path);

/// Throws InputError when the file is no study, is in use, damaged or anonymised, or its
/// schema was changed.
MergePart open_merge_part(const std::filesystem::path& path);

/// Throws InputError with the first reason why these are not stations of one study, all with other
/// participants.
void require_one_study(const std::deque<MergePart>& parts);

}  // namespace impetus::inline store
