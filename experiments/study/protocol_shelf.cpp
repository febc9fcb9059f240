// SPDX-License-Identifier: MIT
#include "experiments/study/protocol_shelf.hpp"

#include <SQLiteCpp/Statement.h>

#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "experiments/store/study_reader.hpp"

namespace impetus::inline study {
namespace {

std::vector<std::int64_t> protocol_ids(StudyFile& study) {
  SQLite::Statement query(study.database(), "SELECT id FROM protocol ORDER BY id");
  std::vector<std::int64_t> ids;
  while (query.executeStep()) {
    ids.push_back(query.getColumn(0).getInt64());
  }
  return ids;
}

}  // namespace

ProtocolShelf::ProtocolShelf(StudyFile& study) {
  for (const std::int64_t id : protocol_ids(study)) {
    const ProtocolTexts texts = load_protocol_texts(study, id);
    const std::string place = "protocol " + texts.name;
    try {
      Protocol protocol = make_protocol(parse_json(place, texts.protocol_json),
                                        parse_json(place + ", scene", texts.scene_json));
      if (protocol.name != texts.name) {
        failures_.push_back(place + ": calls itself " + protocol.name);
      }
      if (protocol.hash != texts.hash) {
        failures_.push_back(place + ": its hash is " + texts.hash + ", computed anew it is " +
                            protocol.hash);
      }
      protocols_.emplace(id, std::move(protocol));
    } catch (const std::exception& error) {
      failures_.emplace_back(error.what());
      ++unreadable_;
    }
  }
}

const Protocol* ProtocolShelf::find(std::int64_t id) const {
  const auto found = protocols_.find(id);
  return found == protocols_.end() ? nullptr : &found->second;
}

}  // namespace impetus::inline study
