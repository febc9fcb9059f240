// SPDX-License-Identifier: MIT
#include "experiments/store/merging/merge_part.hpp"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <system_error>
#include <utility>

#include "experiments/settings/input_error.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/store/study_integrity.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline store {
namespace {

void add_bytes(const std::filesystem::path& path, XXH3_state_t* state) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 1 << 16> part{};
  while (file.read(part.data(), part.size()) || file.gcount() > 0) {
    XXH3_128bits_update(state, part.data(), static_cast<std::size_t>(file.gcount()));
  }
}

void require_whole(const std::string& name, const std::vector<std::string>& problems) {
  if (!problems.empty()) {
    const std::size_t more = problems.size() - 1;
    throw InputError(name + ": expected a study that is whole, but " + problems.front() +
                     (more > 0 ? " (and " + std::to_string(more) + " more)" : ""));
  }
}

/// What makes a study anonymous holds for the whole of it, its order of participants above all.
void require_not_anonymised(StudyFile& study) {
  const std::int64_t anonymised =
      study.database()
          .execAndGet("SELECT count(*) FROM study WHERE anonymised_by IS NOT NULL")
          .getInt64();
  if (anonymised > 0) {
    throw InputError(study.name() + ": expected a study that is not anonymised; merge first");
  }
}

std::string names_of(const std::map<std::string, std::set<std::string>>& protocols) {
  const std::string text = listed(protocols, [](const auto& each) { return each.first; });
  return text.empty() ? "none" : text;
}

/// Neither file is in the other, nor a third in both.
void require_other_file(const MergePart& part, const MergePart& before) {
  if (part.hash == before.hash) {
    throw InputError(part.study.name() + ": the same file as " + before.study.name());
  }
  const auto require_not_in = [](const MergePart& in, const MergePart& file) {
    const auto found = in.identity.merged.find(file.hash);
    if (found != in.identity.merged.end()) {
      throw InputError(file.study.name() + ": was merged into " + in.study.name() +
                       " already, as " + found->second.name + " at " + found->second.merged_utc);
    }
  };
  require_not_in(before, part);
  require_not_in(part, before);
  for (const auto& [hash, earlier] : part.identity.merged) {
    if (before.identity.merged.contains(hash)) {
      throw InputError(part.study.name() + ": " + earlier.name + " was merged into it and into " +
                       before.study.name());
    }
  }
}

void require_same_versions(const MergePart& part, const MergePart& before) {
  for (const auto& [name, versions] : part.identity.protocols) {
    const auto found = before.identity.protocols.find(name);
    if (found != before.identity.protocols.end() && found->second != versions) {
      throw InputError(part.study.name() + ": expected the version of " + name + " that " +
                       before.study.name() + " holds (" + *found->second.begin() + "), got " +
                       *versions.begin());
    }
  }
}

void require_one_version(const MergePart& part) {
  for (const auto& [name, versions] : part.identity.protocols) {
    if (versions.size() > 1) {
      throw InputError(part.study.name() + ": expected one version of " + name + ", got " +
                       std::to_string(versions.size()) + ": " + *versions.begin() + ", " +
                       *std::next(versions.begin()));
    }
  }
}

/// The first protocol of `part` that the other lacks; "": there is none.
std::string protocol_beyond(const MergePart& part, const MergePart& other) {
  for (const auto& [name, versions] : part.identity.protocols) {
    if (!other.identity.protocols.contains(name)) {
      return name;
    }
  }
  return "";
}

/// A station may not have come to all protocols of the study yet: of two, one has all of the
/// other's.
void require_same_study(const MergePart& part, const MergePart& before) {
  const std::string beyond = protocol_beyond(part, before);
  if (!beyond.empty() && !protocol_beyond(before, part).empty()) {
    throw InputError(part.study.name() + ": expected protocols of the same study as " +
                     before.study.name() + " (" + names_of(before.identity.protocols) + "), got " +
                     beyond);
  }
}

void require_other_participants(const MergePart& part, const MergePart& before) {
  std::vector<std::string> both;
  std::set_intersection(part.identity.pseudonyms.begin(), part.identity.pseudonyms.end(),
                        before.identity.pseudonyms.begin(), before.identity.pseudonyms.end(),
                        std::back_inserter(both));
  if (!both.empty()) {
    throw InputError(
        part.study.name() + ": expected other participants than in " + before.study.name() +
        ", got " + both.front() + " in both" +
        (both.size() > 1 ? " (and " + std::to_string(both.size() - 1) + " more)" : ""));
  }
}

}  // namespace

StudyIdentity identity_of(StudyFile& study) {
  SQLite::Database& database = study.database();
  StudyIdentity identity;
  for (const auto& [name, hash] :
       load_rows<std::string, std::string>(database, "SELECT name, hash FROM protocol")) {
    identity.protocols[name].insert(hash);
  }
  for (const std::string& pseudonym :
       load_column<std::string>(database, "SELECT pseudonym FROM participant")) {
    identity.pseudonyms.insert(pseudonym);
  }
  for (const auto& [hash, name, merged_utc] : load_rows<std::string, std::string, std::string>(
           database, "SELECT hash, name, merged_utc FROM merged_file")) {
    identity.merged[hash] = {name, merged_utc};
  }
  return identity;
}

std::string hash_of_file(const std::filesystem::path& path) {
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(),
                                                                       &XXH3_freeState);
  XXH3_128bits_reset(state.get());
  add_bytes(path, state.get());
  add_bytes(log_beside(path), state.get());
  const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
  return printed("%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                 static_cast<unsigned long long>(hash.low64));
}

MergePart open_merge_part(const std::filesystem::path& path) {
  ReadingLock lock(path);
  std::error_code error;
  const bool is_there = std::filesystem::exists(path, error);
  if (is_there && !lock.held()) {
    throw InputError(path.string() + ": in use by another Impetus process; end that session first");
  }
  if (is_there) {
    require_whole(path.string(), damage_in(path));
  }
  // Before the study is open: whoever closes its file takes SQLite's locks on it along.
  const std::string hash = hash_of_file(path);
  MergePart part{std::move(lock), StudyFile::open_for_reading(path), hash, {}};
  require_whole(path.string(), schema_differences(part.study.database()));
  require_whole(path.string(), forbidden_rows(part.study.database()));
  require_not_anonymised(part.study);
  part.identity = identity_of(part.study);
  return part;
}

void require_one_study(const std::deque<MergePart>& parts) {
  const auto each_two = [&](void (*require)(const MergePart&, const MergePart&)) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        require(parts[i], parts[j]);
      }
    }
  };
  each_two(require_other_file);
  for (const MergePart& part : parts) {
    require_one_version(part);
  }
  each_two(require_same_study);
  each_two(require_same_versions);
  each_two(require_other_participants);
}

}  // namespace impetus::inline store
