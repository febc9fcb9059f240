// Refuses a type whose name two headers give: where one program links both, each may be taken for
// the other (the one-definition rule), and no compiler needs to say so; and one that does not say
// what it is for.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/places/places.hpp"

namespace impetus::one_definition_test {

using Texts = std::map<std::string, std::string>;  ///< by path

/// The types that a header defines outside of others: those that begin a line.
std::set<std::string> types_of(const std::string& text) {
  static const std::regex definition(
      R"(^(struct|class|union|enum( class| struct)?) (?:alignas\(\w+\) )?(\w+)[^;]*\{.*)");
  std::set<std::string> types;
  std::istringstream lines(text);
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, match, definition)) {
      types.insert(match[3]);
    }
  }
  return types;
}

/// A sentence for each name that more than one header gives to a type.
std::vector<std::string> shared_names(const Texts& headers) {
  std::map<std::string, std::string> homes;
  std::vector<std::string> found;
  for (const auto& [path, text] : headers) {
    for (const std::string& type : types_of(text)) {
      const auto [home, is_new] = homes.emplace(type, path);
      if (!is_new) {
        found.push_back(type + " is a type of " + home->second + " and of " + path);
      }
    }
  }
  return found;
}

/// The files of the product and of its tests that end so.
Texts all_files(const std::string& extension) {
  Texts files;
  const std::filesystem::path root(source_folder());
  for (const char* folder : {"engine", "experiments", "tests"}) {
    for (const auto& each : std::filesystem::recursive_directory_iterator(root / folder)) {
      if (each.path().extension() == extension) {
        std::stringstream text;
        text << std::ifstream(each.path()).rdbuf();
        files[std::filesystem::relative(each.path(), root).string()] = text.str();
      }
    }
  }
  return files;
}

Texts all_headers() { return all_files(".hpp"); }

TEST(OneDefinition, NoTypesNameStandsInTwoHeaders) {
  const Texts headers = all_headers();
  ASSERT_GT(headers.size(), 300U);
  for (const std::string& sentence : shared_names(headers)) {
    ADD_FAILURE() << sentence;
  }
}

TEST(OneDefinition, ANameOfTwoTypesIsNamedWithBothHeaders) {
  const Texts headers{
      {"a.hpp", "class Course {\n};\nstruct Inner;\n"},
      {"b.hpp", "struct Course final : Base {\n  struct Own {\n  };\n};\nstruct Inner {};\n"},
      {"c.hpp", "enum class Inner : int { kOne };\nstruct Course;\n  struct Own {\n"},
      {"d.hpp", "struct alignas(64) Block {\n};\nstruct alignas(8) Course {\n};\n"}};
  EXPECT_EQ(shared_names(headers),
            (std::vector<std::string>{"Course is a type of a.hpp and of b.hpp",
                                      "Inner is a type of b.hpp and of c.hpp",
                                      "Course is a type of a.hpp and of d.hpp"}));
}

/// A sentence for each namespace of a header of `engine` or `experiments` that is not its room's.
std::vector<std::string> foreign_namespaces(const std::string& path, const std::string& text) {
  const std::size_t room = path.find('/') + 1;
  const std::string own = "impetus::inline " + path.substr(room, path.find('/', room) - room);
  static const std::regex opening(R"(namespace (impetus[\w: ]*) \{)");
  std::vector<std::string> found;
  std::istringstream lines(text);
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, match, opening) && !match[1].str().starts_with(own)) {
      found.push_back(path + ": expected namespace " + own + ", got " + match[1].str());
    }
  }
  return found;
}

TEST(OneDefinition, EveryHeaderIsInTheNamespaceOfItsRoom) {
  for (const auto& [path, text] : all_headers()) {
    if (!path.starts_with("tests/")) {
      EXPECT_EQ(foreign_namespaces(path, text), std::vector<std::string>()) << path;
    }
  }
  EXPECT_EQ(foreign_namespaces("experiments/trade/impacts/approach.hpp", "namespace impetus {\n"),
            std::vector<std::string>{"experiments/trade/impacts/approach.hpp: expected namespace "
                                     "impetus::inline trade, got impetus"});
}

/// The types, wherever in a file, that no comment comes before; but specialisations, whose template
/// has one.
std::vector<std::string> unexplained_types(const std::string& text) {
  static const std::regex definition(
      R"( *(struct|class|enum|enum class) (\w+)( final)?( : [^;]*)? \{.*)");
  static const std::regex comment(" *//.*");
  static const std::regex head(R"( *(template|requires)\b.*)");
  std::vector<std::string> found;
  std::istringstream lines(text);
  std::smatch match;
  std::string before;
  for (std::string line; std::getline(lines, line);) {
    const bool is_explained =
        std::regex_match(before, comment) || line.find("///<") != std::string::npos;
    if (std::regex_match(line, match, definition) && !is_explained) {
      found.push_back(match[2]);
    }
    before = std::regex_match(line, head) ? before : line;
  }
  return found;
}

TEST(OneDefinition, EveryTypeSaysWhatItIsFor) {
  for (const char* extension : {".hpp", ".cpp"}) {
    for (const auto& [path, text] : all_files(extension)) {
      if (!path.starts_with("tests/")) {
        EXPECT_EQ(unexplained_types(text), std::vector<std::string>()) << path;
      }
    }
  }
  EXPECT_EQ(unexplained_types("/// Said.\ntemplate <typename T>\nclass A final : public B<T> {\n"
                              "  struct C {};  ///< said\n  enum class D { kOne };\n};\n\n"
                              "template <>\nstruct E<int> {};\nstruct F;\nstruct G : H {\n"),
            (std::vector<std::string>{"D", "G"}));
}

}  // namespace impetus::one_definition_test
