// SPDX-License-Identifier: MIT
#include "experiments/power/power_chunk.hpp"

#include <nlohmann/json.hpp>

#include "experiments/settings/optional_json.hpp"

namespace impetus::inline power {

// As a chunk's file has them; the build of its studies is said once, of the chunk.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StudyTest, factor, p, method, remark)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TestedStudy, effect, number, participants, seed, simulated_s,
                                   tests)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PowerQuestion, protocol, protocol_hash, observer, null_observer,
                                   screen, response, model, factors, compared, seed)

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr SweepKind kPower{"power", 2, "a power analysis"};

json json_of(const PowerChunk& chunk) {
  return {{"build", chunk.build},
          {"question", chunk.question},
          {"participants", chunk.request.sizes},
          {"studies_with_effect", chunk.request.studies},
          {"studies_without_effect", chunk.request.null_studies},
          {"chunk", chunk.request.chunk.number},
          {"chunks", chunk.request.chunk.of},
          {"took_s", chunk.took_s},
          {"studies", chunk.studies}};
}

PowerChunk chunk_of(const json& value) {
  PowerChunk chunk;
  chunk.build = value.at("build").get<std::string>();
  value.at("question").get_to(chunk.question);
  chunk.request = {value.at("participants").get<std::vector<std::int64_t>>(),
                   value.at("studies_with_effect").get<std::int64_t>(),
                   value.at("studies_without_effect").get<std::int64_t>(),
                   {value.at("chunk").get<std::int64_t>(), value.at("chunks").get<std::int64_t>()}};
  chunk.took_s = value.at("took_s").get<double>();
  value.at("studies").get_to(chunk.studies);
  for (TestedStudy& study : chunk.studies) {
    study.build = chunk.build;
  }
  return chunk;
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

}  // namespace

void write_chunk(const fs::path& out, const PowerChunk& chunk) {
  write_chunk_value(chunk_file(out, chunk.request.chunk.number), kPower, json_of(chunk));
}

Sweep power_sweep(const fs::path& out, const PowerQuestion& question, const PowerRequest& request) {
  std::vector<AskedPart> parts;
  for (const QuestionText& text : question_texts()) {
    parts.push_back({std::string("/question/") + text.name, text.words});
  }
  parts.insert(parts.end(), {{"/question/seed", "seed"},
                             {"/participants", "choice of numbers of participants"},
                             {"/studies_with_effect", "number of studies"},
                             {"/studies_without_effect", "number of studies without the effect"},
                             {"/chunks", "number of chunks"}});
  return {kPower,
          out,
          request.chunk.of,
          json_of(PowerChunk{question, request, "", 0.0, {}}),
          parts,
          [](const json& value) {
            return is_complete(chunk_of(value)) ? "" : "all studies of its chunk";
          }};
}

std::vector<TestedStudy> tested_studies(const SweptChunk& chunk) {
  return chunk_of(chunk.value).studies;
}

}  // namespace impetus::inline power
