// The protocols of a study, and whether each plan is the one that protocol, code and seed give.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>

#include "experiments/protocol/protocol_file.hpp"
#include "experiments/store/study_file.hpp"
#include "experiments/study/verification_report.hpp"

namespace impetus::inline study {

/// The protocols of a study, read anew from the texts that it keeps.
class ProtocolShelf {
 public:
  /// Reads all of them. What cannot be read, or is not what its name and hash say, is a failure.
  /// Throws SQLite::Exception.
  explicit ProtocolShelf(StudyFile& study);

  [[nodiscard]] const Failures& failures() const { return failures_; }
  [[nodiscard]] std::size_t size() const { return protocols_.size() + unreadable_; }

  /// By its id in the study; null: it could not be read.
  [[nodiscard]] const Protocol* find(std::int64_t id) const;

 private:
  std::map<std::int64_t, Protocol> protocols_;
  std::size_t unreadable_{0};
  Failures failures_;
};

/// Plans every enrolment anew; of each the first difference is told. The level of an adaptive trial
/// is left to a replay, solved values are taken as they were stored. Enrolments whose protocol
/// cannot be read are passed over. Throws SQLite::Exception.
Failures changed_plans(StudyFile& study, const ProtocolShelf& shelf);

}  // namespace impetus::inline study
