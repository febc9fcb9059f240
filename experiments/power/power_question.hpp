// What a power analysis asks: everything that changes a study's tests, and how many are wanted.
//
//   request ─> its cells, numbers rising, each with the effect and then without
//     └─ chunk 2 of 3: the second third of them, so that any machine knows its own
//
// A study's seed follows from its number alone: whoever simulates it, in whatever chunk, comes to
// the same tests.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/power/chunk_file.hpp"

namespace impetus::inline power {

/// What a power analysis answers. Everything that changes a study's tests is in it.
struct PowerQuestion {
  std::string protocol;
  std::string protocol_hash;
  std::string observer;       ///< JSON
  std::string null_observer;  ///< JSON; "": none is known
  std::string screen;
  std::string response;  ///< "rating", "answer" or "clicks"
  std::string model;     ///< "means" or "mixed"
  std::string factors;   ///< JSON array
  std::string compared;  ///< JSON array
  std::int64_t seed{1};
};

/// A text of the question: what it is called in files, what it is in words, and where it stands.
struct QuestionText {
  const char* name;
  const char* words;
  std::string PowerQuestion::*place;
};

/// All of the question but its seed.
const std::vector<QuestionText>& question_texts();

/// In words, what two questions differ in first ("observer"); "" when they ask the same.
std::string difference(const PowerQuestion& one, const PowerQuestion& other);

/// How many studies of which sizes are wanted.
struct PowerRequest {
  std::vector<std::int64_t> sizes;  ///< numbers of participants, rising, each once
  std::int64_t studies{0};          ///< of each size with the effect
  std::int64_t null_studies{0};     ///< of each size without it
  ChunkNumber chunk{};              ///< the whole unless told otherwise
};

/// One number of a study, to be simulated with as many participants as its greatest size.
struct PowerCell {
  bool effect{true};
  std::int64_t number{1};
  std::vector<std::int64_t> sizes;  ///< rising
};

/// The cells of the request's chunk, each with all its sizes. Numbers rise, each with the effect
/// and then without: what is done first tells of both.
std::vector<PowerCell> cells_of(const PowerRequest& request);

}  // namespace impetus::inline power
