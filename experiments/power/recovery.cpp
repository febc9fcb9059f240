// SPDX-License-Identifier: MIT
#include "experiments/power/recovery.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline power {

// As a chunk's file has them.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RecoveryQuestion, protocol, protocol_hash, observer_name,
                                   observer, screen, participants, studies, seed)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RecoveredParameter, name, planted, value, low, high,
                                   held_because)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RecoveredStudy, number, seed, parameters, remark)

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr SweepKind kRecovery{"recovery", 1, "a parameter recovery"};

std::vector<RecoveredStudy> studies_of(const json& chunk) {
  return chunk.at("studies").get<std::vector<RecoveredStudy>>();
}

bool is_complete(const json& chunk, std::int64_t chunks, std::int64_t all_studies) {
  const std::vector<std::int64_t> numbers =
      numbers_of({chunk.at("chunk").get<std::int64_t>(), chunks}, all_studies);
  const std::vector<RecoveredStudy> studies = studies_of(chunk);
  return std::equal(
      numbers.begin(), numbers.end(), studies.begin(), studies.end(),
      [](std::int64_t number, const RecoveredStudy& study) { return study.number == number; });
}

double median(std::vector<double> values) {
  if (values.empty()) {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace

void write_chunk(const fs::path& out, const RecoveryChunk& chunk) {
  write_chunk_value(chunk_file(out, chunk.chunk.number), kRecovery,
                    {{"question", chunk.question},
                     {"chunk", chunk.chunk.number},
                     {"chunks", chunk.chunk.of},
                     {"build", chunk.build},
                     {"took_s", chunk.took_s},
                     {"studies", chunk.studies}});
}

Sweep recovery_sweep(const fs::path& out, const RecoveryQuestion& question, std::int64_t chunks) {
  return {kRecovery,
          out,
          chunks,
          {{"question", question}, {"chunks", chunks}},
          {{"/question/protocol", "protocol"},
           {"/question/protocol_hash", "version of the protocol"},
           {"/question/observer", "observer"},
           {"/question/screen", "screen"},
           {"/question/participants", "number of participants"},
           {"/question/studies", "number of studies"},
           {"/question/seed", "seed"},
           {"/chunks", "number of chunks"}},
          [chunks, all = question.studies](const json& chunk) {
            return is_complete(chunk, chunks, all) ? "" : "all studies of its chunk";
          }};
}

std::vector<RecoveredStudy> read_studies(const Sweep& recovery) {
  std::vector<RecoveredStudy> studies;
  recovery.read_all([&](const SweptChunk& chunk) {
    std::vector<RecoveredStudy> more = studies_of(chunk.value);
    std::move(more.begin(), more.end(), std::back_inserter(studies));
  });
  return studies;
}

std::vector<ParameterRecovery> recovery_of(const std::vector<RecoveredStudy>& studies) {
  std::vector<ParameterRecovery> all;
  std::vector<std::vector<double>> values;
  std::vector<std::vector<double>> widths;
  for (const RecoveredStudy& study : studies) {
    for (const RecoveredParameter& one : study.parameters) {
      const auto known = std::find_if(all.begin(), all.end(), [&](const ParameterRecovery& other) {
        return other.name == one.name;
      });
      const auto place = static_cast<std::size_t>(known - all.begin());
      if (known == all.end()) {
        all.push_back({one.name, one.planted});
        values.emplace_back();
        widths.emplace_back();
      }
      ParameterRecovery& sums = all[place];
      if (!one.is_fitted()) {
        ++sums.not_identified;
        continue;
      }
      ++sums.fitted;
      sums.covered += one.is_covered() ? 1 : 0;
      values[place].push_back(one.value);
      widths[place].push_back(one.high - one.low);
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto count = static_cast<double>(values[i].size());
    for (const double value : values[i]) {
      all[i].mean += value / count;
    }
    for (const double value : values[i]) {
      all[i].sd += count < 2.0 ? 0.0 : std::pow(value - all[i].mean, 2) / (count - 1.0);
    }
    all[i].sd = std::sqrt(all[i].sd);
    all[i].median_width = median(widths[i]);
  }
  return all;
}

ShareInterval wilson_interval(std::int64_t count, std::int64_t all) {
  constexpr double z = 1.959964;
  const auto n = static_cast<double>(all);
  const double share = static_cast<double>(count) / n;
  const double middle = share + z * z / (2.0 * n);
  const double half = z * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
  const double whole = 1.0 + z * z / n;
  return {(middle - half) / whole, (middle + half) / whole};
}

}  // namespace impetus::inline power
