// SPDX-License-Identifier: MIT
#include "experiments/power/chunk_file.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "experiments/models/atomic_file.hpp"
#include "experiments/models/mesh_bytes.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/settings/json_document.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline power {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Numbers are written with all their digits: what is read is bit for bit what was written.
std::string text_of(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
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

/// "FILE: expected EXPECTED, got INSTEAD; remove it and compute it again". Throws InputError.
[[noreturn]] void refuse_chunk(const fs::path& file, const std::string& expected,
                               const std::string& instead) {
  throw InputError(file.string() + ": expected " + expected + ", got " + instead +
                   "; remove it and compute it again");
}

/// What the file holds, once it is known to be as it was written, and of this kind and format.
json read_chunk_value(const fs::path& file, const SweepKind& kind) {
  json whole;
  try {
    whole = read_json(file).value;
  } catch (const InputError&) {
    refuse_chunk(file, "a whole chunk", "one that was cut short");
  }
  if (!whole.is_object() || !whole.contains("chunk") || !whole.contains("checksum")) {
    refuse_chunk(file, std::string("a chunk of ") + kind.words, "other JSON");
  }
  if (whole["checksum"] != content_hash(text_of(whole["chunk"]))) {
    refuse_chunk(file, "a chunk as it was written", "one that was changed since");
  }
  json value = std::move(whole["chunk"]);
  if (value.value("sweep", kind.name) != std::string(kind.name)) {
    refuse_chunk(file, std::string("a chunk of ") + kind.words, "one of another sweep");
  }
  if (value.value("format", 0) != kind.format) {
    refuse_chunk(file, "a chunk of format " + std::to_string(kind.format), "another format");
  }
  return value;
}

/// Says which part of the question a chunk answers otherwise.
void require_question(const Sweep& sweep, const fs::path& file, const json& value) {
  for (const AskedPart& part : sweep.parts) {
    const json::json_pointer place(part.place);
    if (value.at(place) != sweep.asked.at(place)) {
      throw InputError(file.string() +
                       ": expected a chunk of the same question, got one of another " + part.words +
                       "; give another --out");
    }
  }
}

/// Names those of the chunks that are not there.
void require_all_chunks(const Sweep& sweep) {
  if (const std::vector<std::int64_t> missing = sweep.missing(); !missing.empty()) {
    throw InputError(chunk_folder(sweep.out).string() + ": expected all " +
                     std::to_string(sweep.chunks) + " chunks, got " +
                     std::to_string(sweep.chunks - std::ssize(missing)) + " of them, without " +
                     first_few(missing) + "; --list prints the command of each");
  }
}

}  // namespace

fs::path chunk_folder(const fs::path& out) { return out / "chunks"; }

fs::path chunk_file(const fs::path& out, std::int64_t number, const std::string& ending) {
  const std::string name = printed("chunk-%04lld", static_cast<long long>(number));
  return chunk_folder(out) / (name + ending);
}

std::vector<std::int64_t> numbers_of(const ChunkNumber& chunk, std::int64_t all) {
  std::vector<std::int64_t> numbers;
  const std::int64_t end = chunk.number * all / chunk.of;
  for (std::int64_t place = (chunk.number - 1) * all / chunk.of; place < end; ++place) {
    numbers.push_back(place + 1);
  }
  return numbers;
}

void write_chunk_value(const fs::path& file, const SweepKind& kind, json value) {
  value["sweep"] = kind.name;
  value["format"] = kind.format;
  const json whole{{"checksum", content_hash(text_of(value))}, {"chunk", value}};
  write_whole_file(file, text_of(whole) + "\n");
}

std::vector<std::int64_t> Sweep::missing() const {
  std::vector<std::int64_t> numbers;
  for (std::int64_t number = 1; number <= chunks; ++number) {
    if (!fs::exists(chunk_file(out, number))) {
      numbers.push_back(number);
    }
  }
  return numbers;
}

SweptChunk Sweep::read(std::int64_t number) const {
  const fs::path file = chunk_file(out, number);
  try {
    json value = read_chunk_value(file, kind);
    require_question(*this, file, value);
    if (const json& there = value.at("chunk"); there != number) {
      refuse_chunk(file, "chunk " + std::to_string(number), "chunk " + there.dump());
    }
    if (const std::string lacking = lacks(value); !lacking.empty()) {
      refuse_chunk(file, lacking, "others");
    }
    return {value.at("build").get<std::string>(), value.at("took_s").get<double>(),
            std::move(value)};
  } catch (const json::exception&) {
    refuse_chunk(file, "a whole chunk", "one that lacks a part");
  }
}

void Sweep::read_all(const std::function<void(const SweptChunk& chunk)>& take) const {
  require_all_chunks(*this);
  std::string build;
  for (std::int64_t number = 1; number <= chunks; ++number) {
    const SweptChunk chunk = read(number);
    build = number == 1 ? chunk.build : build;
    if (chunk.build != build) {
      refuse_chunk(chunk_file(out, number), "a chunk of the build of the others, " + build,
                   "one of " + chunk.build);
    }
    take(chunk);
  }
}

void Sweep::require_build(const std::string& build) const {
  for (std::int64_t number = 1; number <= chunks; ++number) {
    const fs::path file = chunk_file(out, number);
    if (!fs::exists(file)) {
      continue;
    }
    if (const std::string there = read(number).build; there != build) {
      throw InputError(file.string() + ": expected a chunk of this build, " + build +
                       ", got one of " + there + "; go on with that build, or give another --out");
    }
    return;  // whoever wrote the others has looked at this one
  }
}

}  // namespace impetus::inline power
