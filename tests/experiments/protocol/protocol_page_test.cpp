// The page that explains a protocol is made of the file, and says all of it.
// SPDX-License-Identifier: MIT
#include "experiments/protocol/protocol_page.hpp"
#include "experiments/files/protocol_files.hpp"

#include <filesystem>

#include "tests/experiments/refusals.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::protocol_page_test {

std::vector<std::filesystem::path> shipped_protocols() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(source_file("protocols"))) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && name.ends_with(".json") && !name.ends_with(".schema.json")) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Every text of a session, whatever its key.
void collect_words(const json& value, std::vector<std::string>& words) {
  for (auto entry = value.begin(); entry != value.end(); ++entry) {
    if (entry->is_structured()) {
      collect_words(*entry, words);
    } else if (value.is_array() || entry.key() == std::string("title") ||
               entry.key() == std::string("text")) {
      words.push_back(entry->get<std::string>());
    }
  }
}

TEST(ProtocolPage, StandsBesideEveryShippedProtocolAsItIsNow) {
  const auto files = shipped_protocols();
  ASSERT_GE(files.size(), 4U);
  for (const auto& file : files) {
    std::filesystem::path page = file;
    page.replace_extension(".md");
    ASSERT_TRUE(std::filesystem::exists(page)) << page;
    EXPECT_EQ(text_of(page), protocol_page(load_protocol(file)))
        << "made anew by: impetus check protocols/" << file.filename().string()
        << " --explain > protocols/" << page.filename().string();
  }
}

TEST(ProtocolPage, SaysEveryWordThatAParticipantReads) {
  for (const auto& file : shipped_protocols()) {
    const Protocol protocol = load_protocol(file);
    if (!protocol.document.value.contains("session")) {
      continue;  // nobody takes part
    }
    const std::string page = protocol_page(protocol);
    std::vector<std::string> words;
    json session = protocol.document.value["session"];
    session.erase("demographics");
    for (const char* list : {"instructions", "demonstrations", "questions"}) {
      for (const json& entry : session.value(list, json::array())) {
        collect_words(entry, words);
      }
      session.erase(list);
    }
    collect_words(session, words);
    ASSERT_GT(words.size(), 5U) << file;
    for (const std::string& word : words) {
      EXPECT_NE(page.find(word), std::string::npos) << file << ": " << word;
    }
  }
}

TEST(ProtocolPage, ChangesWithTheDesign) {
  const std::string before = protocol_page(load_protocol(source_file("protocols/causality.json")));
  EXPECT_NE(before.find("3 × 3 × 3 cells, 3 repetitions of each."), std::string::npos);
  const std::string after = protocol_page(Study().with("/design/repetitions", 2).made());
  EXPECT_NE(after.find("3 × 3 × 3 cells, 2 repetitions of each."), std::string::npos);
  EXPECT_NE(after.find("54 trials after 6 of practice"), std::string::npos);
}

TEST(ProtocolPage, SaysByWhichKeysAndHowSoonToAnswerAndWhatIsRight) {
  const std::string page =
      protocol_page(Study()
                        .with("/yes_no", {{"question", "Late?"},
                                          {"keys", "j n"},
                                          {"timeout_ms", 4000},
                                          {"right_when", {{"factor", "delay_ms"}, {"above", 0}}}})
                        .made());
  EXPECT_NE(
      page.find("yes is right where delay_ms is above 0; by the keys j, n; at most 4000 ms to "
                "answer |"),
      std::string::npos);
}

}  // namespace impetus::protocol_page_test
