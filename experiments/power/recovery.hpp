// Parameter recovery: whether a study of this design, answered by a simulated participant whose
// numbers are known, gives these numbers back (Wilson and Collins 2019).
//
//   study 1, 2, 3, ... ─simulated, fitted─> estimates and 95 % intervals ─> bias, coverage, width
//     └─ in chunks, whoever computes them (chunk_file.hpp)
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/power/chunk_file.hpp"

namespace impetus::inline power {

/// What is to be recovered. Everything that changes a study's estimates is in it.
struct RecoveryQuestion {
  std::string protocol;
  std::string protocol_hash;
  std::string observer_name;
  std::string observer;  ///< JSON
  std::string screen;
  std::int64_t participants{2};
  std::int64_t studies{1};
  std::int64_t seed{1};
};

/// A parameter, as it was planted and as one study gave it back.
struct RecoveredParameter {
  std::string name;
  double planted{0.0};
  double value{0.0};
  double low{0.0};  ///< of its 95 % interval
  double high{0.0};
  std::string held_because{};  ///< "": it was fitted

  [[nodiscard]] bool is_fitted() const { return held_because.empty(); }
  [[nodiscard]] bool is_covered() const { return low <= planted && planted <= high; }

  friend bool operator==(const RecoveredParameter&, const RecoveredParameter&) = default;
};

/// One simulated study, fitted.
struct RecoveredStudy {
  std::int64_t number{1};
  std::uint64_t seed{0};
  std::vector<RecoveredParameter> parameters;
  std::string remark{};  ///< why it was not fitted; "": it was

  friend bool operator==(const RecoveredStudy&, const RecoveredStudy&) = default;
};

/// What a chunk's file holds.
struct RecoveryChunk {
  RecoveryQuestion question;
  ChunkNumber chunk;
  std::string build;
  double took_s{0.0};
  std::vector<RecoveredStudy> studies;
};

/// Throws std::runtime_error, in one sentence, when it cannot be written; then there is no file.
void write_chunk(const std::filesystem::path& out, const RecoveryChunk& chunk);

/// All chunks of a recovery. One is complete when it has all studies of its numbers.
Sweep recovery_sweep(const std::filesystem::path& out, const RecoveryQuestion& question,
                     std::int64_t chunks);

/// The studies of all chunks, in their order. Throws InputError as Sweep::read_all() does.
std::vector<RecoveredStudy> read_studies(const Sweep& recovery);

/// What the studies together say of one parameter.
struct ParameterRecovery {
  std::string name;
  double planted{0.0};
  std::int64_t fitted{0};          ///< studies in which it was
  std::int64_t not_identified{0};  ///< studies that held it
  std::int64_t covered{0};         ///< fitted, and the interval holds what was planted
  double mean{0.0};                ///< of the estimates of those that fitted it
  double sd{0.0};
  double median_width{0.0};  ///< of the intervals
};

/// In the order of the fit.
std::vector<ParameterRecovery> recovery_of(const std::vector<RecoveredStudy>& studies);

/// A 95 % interval of a probability, of which `count` of `all` were (Wilson 1927); `all` > 0.
struct ShareInterval {
  double low{0.0};
  double high{1.0};
};
ShareInterval wilson_interval(std::int64_t count, std::int64_t all);

/// The page, in Markdown.
std::string recovery_page(const RecoveryQuestion& question,
                          const std::vector<RecoveredStudy>& studies);

/// CSV: a row for each parameter of each study.
std::string recovery_csv(const std::vector<RecoveredStudy>& studies);

}  // namespace impetus::inline power
