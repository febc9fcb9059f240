// A study that takes sessions from pages while they run: each part is acknowledged once it is
// proved and committed.
//
//   page ──part 1, 2, ...──> proof ──> StudyWriter ──commit──> acknowledged
//   page that is opened again <── where its participant stands
//
// Everything that is needed to go on is in the study file: a program that was killed and started
// again takes the next part of a session that it has never heard of.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "experiments/site/session_proof.hpp"
#include "experiments/store/study_file.hpp"
#include "experiments/store/study_writer.hpp"

namespace impetus::inline site {

/// What a page posts: a file's name and content, as to any drop, and its participant's key.
struct PostedPart {
  std::string name;  ///< of the session, "CODE_TIME"
  std::int64_t number{1};
  std::string lines;
  std::string key;
};

/// Reads {"filename": "CODE_TIME_0001.jsonl", "data": "...", "key": "..."}. Throws InputError.
PostedPart posted_part_from(const nlohmann::json& body);

/// The participant's session is another's who has the key, or goes on elsewhere.
class NotYours : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Keeps the sessions of one published study. Any number of threads may call it at once.
class ServedStudy {
 public:
  /// All must outlive this.
  ServedStudy(const PublishedStudy& published, const Protocol& protocol, StudyFile& study);

  /// From now on `told` is given a line whenever a participant begins or has finished; on any
  /// thread, one at a time.
  void tell(std::function<void(const std::string&)> told) { told_ = std::move(told); }

  /// Returns once the part is kept; one that is kept already changes nothing. Throws InputError
  /// when it does not follow from what was published or the study's tables forbid it, NotYours,
  /// StoreError when it cannot be kept now.
  void take(const PostedPart& part);

  /// Where a participant stands, for a page that is opened again; null: nothing is known of them;
  /// {"finished": true}: all is done. Throws NotYours without their key, InputError when they
  /// stayed away for too long.
  nlohmann::json standing(const std::string& participant, const std::string& key);

 private:
  struct Sitting;

  bool take_with(Sitting& sitting, const PostedPart& part);
  std::shared_ptr<Sitting> sitting_of(const PostedPart& part);
  std::shared_ptr<Sitting> known_sitting(const PostedPart& part);
  std::optional<EarlierSessions> earlier_sessions(const std::string& participant,
                                                  const std::string& key);
  void forget_the_idle();
  void keep(const PostedPart& part, Sitting& sitting);
  void require_its_page(const PostedPart& part);
  void say_how_far(const Sitting& sitting, const std::vector<AnyRecord>& records);
  void begin(const std::string& key, Sitting& sitting, std::vector<AnyRecord>& records);

  const PublishedStudy& published_;
  const Protocol& protocol_;
  StudyFile& study_;
  std::function<void(const std::string&)> told_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Sitting>> sittings_;  ///< by the session's name
};

}  // namespace impetus::inline site
