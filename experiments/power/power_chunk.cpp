// SPDX-License-Identifier: MIT
#include "experiments/power/power_chunk.hpp"

#include <nlohmann/json.hpp>

#include "experiments/power/chunk_file.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline power {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr SweepKind kPower{"power", 2, "a power analysis"};

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
  return {{"build", chunk.build},
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

PowerChunk parse_chunk(const fs::path& file) {
  const json value = read_chunk_value(file, kPower);
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

}  // namespace

void write_chunk(const fs::path& out, const PowerChunk& chunk) {
  write_chunk_value(chunk_file(out, chunk.request.chunk.number), kPower, json_of(chunk));
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
    require_same_build(file, read_chunk(out, question, request).build, build);
    return;  // whoever wrote the others has looked at this one
  }
}

std::vector<PowerChunk> read_all_chunks(const fs::path& out, const PowerQuestion& question,
                                        PowerRequest request) {
  require_all_chunks(out, request.chunk.of);
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
