// SPDX-License-Identifier: MIT
#include "experiments/power/recovery.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline power {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr SweepKind kRecovery{"recovery", 1, "a parameter recovery"};

json json_of(const RecoveryQuestion& question) {
  return {{"protocol", question.protocol},
          {"protocol_hash", question.protocol_hash},
          {"observer_name", question.observer_name},
          {"observer", question.observer},
          {"screen", question.screen},
          {"participants", question.participants},
          {"studies", question.studies},
          {"seed", question.seed}};
}

json json_of(const RecoveredStudy& study) {
  json parameters = json::array();
  for (const RecoveredParameter& one : study.parameters) {
    parameters.push_back({{"name", one.name},
                          {"planted", one.planted},
                          {"value", one.value},
                          {"low", one.low},
                          {"high", one.high},
                          {"held_because", one.held_because}});
  }
  return {{"number", study.number},
          {"seed", study.seed},
          {"parameters", parameters},
          {"remark", study.remark}};
}

RecoveredStudy study_of(const json& value) {
  RecoveredStudy study{value.at("number").get<std::int64_t>(),
                       value.at("seed").get<std::uint64_t>(),
                       {},
                       value.at("remark").get<std::string>()};
  for (const json& one : value.at("parameters")) {
    study.parameters.push_back({one.at("name").get<std::string>(), one.at("planted").get<double>(),
                                one.at("value").get<double>(), one.at("low").get<double>(),
                                one.at("high").get<double>(),
                                one.at("held_because").get<std::string>()});
  }
  return study;
}

/// Says which part of the question a chunk answers otherwise.
void require_question(const fs::path& file, const json& there, const RecoveryQuestion& question) {
  const json wanted = json_of(question);
  const std::pair<const char*, const char*> words[] = {{"protocol", "protocol"},
                                                       {"protocol_hash", "version of the protocol"},
                                                       {"observer", "observer"},
                                                       {"screen", "screen"},
                                                       {"participants", "number of participants"},
                                                       {"studies", "number of studies"},
                                                       {"seed", "seed"}};
  for (const auto& [key, word] : words) {
    if (there.at(key) != wanted.at(key)) {
      throw InputError(file.string() +
                       ": expected a chunk of the same question, got one of another " + word +
                       "; give another --out");
    }
  }
}

RecoveryChunk parsed(const fs::path& file, const json& value, const RecoveryQuestion& question,
                     const ChunkNumber& wanted) {
  require_question(file, value.at("question"), question);
  RecoveryChunk chunk{
      question,
      {value.at("chunk").get<std::int64_t>(), value.at("chunks").get<std::int64_t>()},
      value.at("build").get<std::string>(),
      value.at("took_s").get<double>(),
      {}};
  if (chunk.chunk.of != wanted.of) {
    throw InputError(file.string() +
                     ": expected a chunk of the same question, got one of another number of "
                     "chunks; give another --out");
  }
  if (chunk.chunk.number != wanted.number) {
    refuse_chunk(file, "chunk " + std::to_string(wanted.number),
                 "chunk " + std::to_string(chunk.chunk.number));
  }
  for (const json& study : value.at("studies")) {
    chunk.studies.push_back(study_of(study));
  }
  return chunk;
}

bool is_complete(const RecoveryChunk& chunk) {
  const std::vector<std::int64_t> numbers = numbers_of(chunk.chunk, chunk.question.studies);
  return std::equal(
      numbers.begin(), numbers.end(), chunk.studies.begin(), chunk.studies.end(),
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
  json studies = json::array();
  for (const RecoveredStudy& study : chunk.studies) {
    studies.push_back(json_of(study));
  }
  write_chunk_value(chunk_file(out, chunk.chunk.number), kRecovery,
                    {{"question", json_of(chunk.question)},
                     {"chunk", chunk.chunk.number},
                     {"chunks", chunk.chunk.of},
                     {"build", chunk.build},
                     {"took_s", chunk.took_s},
                     {"studies", studies}});
}

RecoveryChunk read_chunk(const fs::path& out, const RecoveryQuestion& question,
                         const ChunkNumber& wanted) {
  const fs::path file = chunk_file(out, wanted.number);
  const json value = read_chunk_value(file, kRecovery);
  try {
    RecoveryChunk chunk = parsed(file, value, question, wanted);
    if (!is_complete(chunk)) {
      refuse_chunk(file, "all studies of its chunk", "others");
    }
    return chunk;
  } catch (const json::exception&) {
    refuse_chunk(file, "a whole chunk", "one that lacks a part");
  }
}

void require_build(const fs::path& out, const RecoveryQuestion& question, std::int64_t chunks,
                   const std::string& build) {
  for (std::int64_t number = 1; number <= chunks; ++number) {
    const fs::path file = chunk_file(out, number);
    if (fs::exists(file)) {
      require_same_build(file, read_chunk(out, question, {number, chunks}).build, build);
      return;  // whoever wrote the others has looked at this one
    }
  }
}

std::vector<RecoveredStudy> read_all_chunks(const fs::path& out, const RecoveryQuestion& question,
                                            std::int64_t chunks) {
  require_all_chunks(out, chunks);
  std::vector<RecoveredStudy> studies;
  std::string build;
  for (std::int64_t number = 1; number <= chunks; ++number) {
    RecoveryChunk chunk = read_chunk(out, question, {number, chunks});
    build = build.empty() ? chunk.build : build;
    if (chunk.build != build) {
      refuse_chunk(chunk_file(out, number), "a chunk of the build of the others, " + build,
                   "one of " + chunk.build);
    }
    std::move(chunk.studies.begin(), chunk.studies.end(), std::back_inserter(studies));
  }
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
