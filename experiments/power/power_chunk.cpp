// SPDX-License-Identifier: MIT
#include "experiments/power/power_chunk.hpp"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "experiments/models/atomic_file.hpp"
#include "experiments/models/mesh_bytes.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/settings/json_document.hpp"

namespace impetus::inline power {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kChunkFormat = 1;

/// Numbers are written with all their digits: a p that is read is bit for bit the one written.
std::string text_of(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

json json_of(const StudyTest& test) {
  return {{"factor", test.factor},
          {"p", test.p ? json(*test.p) : json()},
          {"method", test.method},
          {"remark", test.remark}};
}

json json_of(const TestedStudy& study) {
  json tests = json::array();
  for (const StudyTest& test : study.tests) {
    tests.push_back(json_of(test));
  }
  return {{"effect", study.effect},
          {"number", study.number},
          {"participants", study.participants},
          {"seed", study.seed},
          {"simulated_s", study.simulated_s},
          {"tests", tests}};
}

json json_of(const PowerQuestion& question) {
  json value{{"seed", question.seed}};
  for (const QuestionText& text : question_texts()) {
    value[text.name] = question.*text.place;
  }
  return value;
}

json json_of(const PowerChunk& chunk) {
  json studies = json::array();
  for (const TestedStudy& study : chunk.studies) {
    studies.push_back(json_of(study));
  }
  return {{"format", kChunkFormat},
          {"build", chunk.build},
          {"question", json_of(chunk.question)},
          {"participants", chunk.request.sizes},
          {"studies_with_effect", chunk.request.studies},
          {"studies_without_effect", chunk.request.null_studies},
          {"chunk", chunk.request.chunk.number},
          {"chunks", chunk.request.chunk.of},
          {"took_s", chunk.took_s},
          {"studies", studies}};
}

StudyTest test_of(const json& value) {
  const json& p = value.at("p");
  return {value.at("factor").get<std::string>(),
          p.is_null() ? std::nullopt : std::optional(p.get<double>()),
          value.at("method").get<std::string>(), value.at("remark").get<std::string>()};
}

TestedStudy study_of(const json& value, const std::string& build) {
  TestedStudy study{value.at("effect").get<bool>(),
                    value.at("number").get<std::int64_t>(),
                    value.at("participants").get<std::int64_t>(),
                    value.at("seed").get<std::int64_t>(),
                    build,
                    value.at("simulated_s").get<double>(),
                    {}};
  for (const json& test : value.at("tests")) {
    study.tests.push_back(test_of(test));
  }
  return study;
}

PowerQuestion question_of(const json& value) {
  PowerQuestion question;
  question.seed = value.at("seed").get<std::int64_t>();
  for (const QuestionText& text : question_texts()) {
    question.*text.place = value.at(text.name).get<std::string>();
  }
  return question;
}

PowerChunk chunk_of(const json& value) {
  PowerChunk chunk;
  chunk.build = value.at("build").get<std::string>();
  chunk.question = question_of(value.at("question"));
  chunk.request = {value.at("participants").get<std::vector<std::int64_t>>(),
                   value.at("studies_with_effect").get<std::int64_t>(),
                   value.at("studies_without_effect").get<std::int64_t>(),
                   {value.at("chunk").get<std::int64_t>(), value.at("chunks").get<std::int64_t>()}};
  chunk.took_s = value.at("took_s").get<double>();
  for (const json& study : value.at("studies")) {
    chunk.studies.push_back(study_of(study, chunk.build));
  }
  return chunk;
}

[[noreturn]] void refuse_chunk(const fs::path& file, const std::string& expected,
                               const std::string& instead) {
  throw InputError(file.string() + ": expected " + expected + ", got " + instead +
                   "; remove it and compute it again");
}

/// What the file holds, once it is known to be as it was written.
json chunk_value(const fs::path& file) {
  json whole;
  try {
    whole = read_json(file).value;
  } catch (const InputError&) {
    refuse_chunk(file, "a whole chunk", "one that was cut short");
  }
  if (!whole.is_object() || !whole.contains("chunk") || !whole.contains("checksum")) {
    refuse_chunk(file, "a chunk of a power analysis", "other JSON");
  }
  if (whole["checksum"] != content_hash(text_of(whole["chunk"]))) {
    refuse_chunk(file, "a chunk as it was written", "one that was changed since");
  }
  return whole["chunk"];
}

PowerChunk parse_chunk(const fs::path& file) {
  const json value = chunk_value(file);
  if (value.value("format", 0) != kChunkFormat) {
    refuse_chunk(file, "a chunk of format " + std::to_string(kChunkFormat), "another format");
  }
  try {
    return chunk_of(value);
  } catch (const json::exception&) {
    refuse_chunk(file, "a whole chunk", "one that lacks a part");
  }
}

void require_request(const fs::path& file, const PowerChunk& chunk, const PowerQuestion& question,
                     const PowerRequest& request) {
  std::string words = difference(chunk.question, question);
  if (words.empty()) {
    words = difference(chunk.request, request);
  }
  if (!words.empty()) {
    throw InputError(file.string() +
                     ": expected a chunk of the same question, got one of another " + words +
                     "; give another --out");
  }
  if (chunk.request.chunk.number != request.chunk.number) {
    refuse_chunk(file, "chunk " + std::to_string(request.chunk.number),
                 "chunk " + std::to_string(chunk.request.chunk.number));
  }
}

/// Whether the studies are those of the request, in its order.
bool is_complete(const PowerChunk& chunk) {
  auto study = chunk.studies.begin();
  for (const PowerCell& cell : cells_of(chunk.request)) {
    for (const std::int64_t size : cell.sizes) {
      if (study == chunk.studies.end() || study->effect != cell.effect ||
          study->number != cell.number || study->participants != size || study->tests.empty()) {
        return false;
      }
      ++study;
    }
  }
  return study == chunk.studies.end();
}

[[noreturn]] void refuse_build(const fs::path& file, const std::string& build,
                               const std::string& other) {
  refuse_chunk(file, "a chunk of the build of the others, " + build, "one of " + other);
}

/// "3, 7 and 20 more".
std::string first_few(const std::vector<std::int64_t>& numbers) {
  constexpr std::size_t kFew = 8;
  std::string words;
  for (std::size_t i = 0; i < std::min(kFew, numbers.size()); ++i) {
    words += (i == 0 ? "" : ", ") + std::to_string(numbers[i]);
  }
  return numbers.size() <= kFew ? words
                                : words + " and " + std::to_string(numbers.size() - kFew) + " more";
}

void require_all(const fs::path& out, std::int64_t chunks) {
  std::vector<std::int64_t> missing;
  for (std::int64_t number = 1; number <= chunks; ++number) {
    if (!fs::exists(chunk_file(out, number))) {
      missing.push_back(number);
    }
  }
  if (!missing.empty()) {
    throw InputError(chunk_folder(out).string() + ": expected all " + std::to_string(chunks) +
                     " chunks, got " + std::to_string(chunks - std::ssize(missing)) +
                     " of them, without " + first_few(missing) +
                     "; --list prints the command of each");
  }
}

}  // namespace

fs::path chunk_folder(const fs::path& out) { return out / "chunks"; }

fs::path chunk_file(const fs::path& out, std::int64_t number, const std::string& ending) {
  char name[32];
  std::snprintf(name, sizeof name, "chunk-%04lld", static_cast<long long>(number));
  return chunk_folder(out) / (name + ending);
}

void write_chunk(const fs::path& out, const PowerChunk& chunk) {
  const json value = json_of(chunk);
  const json whole{{"checksum", content_hash(text_of(value))}, {"chunk", value}};
  write_whole_file(chunk_file(out, chunk.request.chunk.number), text_of(whole) + "\n");
}

PowerChunk read_chunk(const fs::path& out, const PowerQuestion& question,
                      const PowerRequest& request) {
  const fs::path file = chunk_file(out, request.chunk.number);
  PowerChunk chunk = parse_chunk(file);
  require_request(file, chunk, question, request);
  if (!is_complete(chunk)) {
    refuse_chunk(file, "all studies of its chunk", "others");
  }
  return chunk;
}

void require_build(const fs::path& out, const PowerQuestion& question, PowerRequest request,
                   const std::string& build) {
  for (request.chunk.number = 1; request.chunk.number <= request.chunk.of; ++request.chunk.number) {
    const fs::path file = chunk_file(out, request.chunk.number);
    if (!fs::exists(file)) {
      continue;
    }
    const PowerChunk there = read_chunk(out, question, request);
    if (there.build != build) {
      throw InputError(file.string() + ": expected a chunk of this build, " + build +
                       ", got one of " + there.build +
                       "; go on with that build, or give another --out");
    }
    return;  // whoever wrote the others has looked at this one
  }
}

std::vector<PowerChunk> read_all_chunks(const fs::path& out, const PowerQuestion& question,
                                        PowerRequest request) {
  require_all(out, request.chunk.of);
  std::vector<PowerChunk> chunks;
  for (request.chunk.number = 1; request.chunk.number <= request.chunk.of; ++request.chunk.number) {
    chunks.push_back(read_chunk(out, question, request));
    if (chunks.back().build != chunks.front().build) {
      refuse_build(chunk_file(out, request.chunk.number), chunks.front().build,
                   chunks.back().build);
    }
  }
  return chunks;
}

}  // namespace impetus::inline power
