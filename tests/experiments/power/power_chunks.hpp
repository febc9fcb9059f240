// A question, its request, and chunks of it as if they had been computed.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "experiments/power/power_chunk.hpp"

namespace impetus {

inline PowerQuestion chunked_question() {
  PowerQuestion question;
  question.protocol = "gap";
  question.protocol_hash = "0123";
  question.observer = R"({"effect": 0.1})";
  question.response = "rating";
  question.model = "means";
  question.factors = "[]";
  question.compared = "[]";
  question.seed = 7;
  return question;
}

/// Two sizes, five studies with the effect and three without: eight cells, in three chunks.
inline PowerRequest chunked_request(std::int64_t number = 1) {
  return {{10, 20}, 5, 3, {number, 3}};
}

/// A third has no short decimal; a number that could not be tested has no p.
inline TestedStudy tested_study(const PowerCell& cell, std::int64_t participants) {
  const double p = 1.0 / static_cast<double>(3 * cell.number + participants);
  return {cell.effect,
          cell.number,
          participants,
          7'000'000 + cell.number,
          "build A",
          0.25,
          {{"level", p, "ANOVA, Greenhouse–Geisser", ""},
           {"speed", std::nullopt, "ANOVA", "nothing varies"}}};
}

inline PowerChunk computed(std::int64_t number) {
  PowerChunk chunk{chunked_question(), chunked_request(number), "build A", 12.5, {}};
  for (const PowerCell& cell : cells_of(chunk.request)) {
    for (const std::int64_t size : cell.sizes) {
      chunk.studies.push_back(tested_study(cell, size));
    }
  }
  return chunk;
}

/// Writes it as a machine would.
inline void put_chunk(const std::filesystem::path& out, const PowerChunk& chunk) {
  std::filesystem::create_directories(chunk_folder(out));
  write_chunk(out, chunk);
}

}  // namespace impetus
