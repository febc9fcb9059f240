// The protocols of a study, read anew from the texts that it keeps.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>

#include "experiments/protocol/protocol_file.hpp"
#include "experiments/store/study_file.hpp"
#include "experiments/study/verification.hpp"

namespace impetus::inline study {

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

}  // namespace impetus::inline study
