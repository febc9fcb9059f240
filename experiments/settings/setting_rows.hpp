// What a file may say, declared once: a row for each setting, from which all else is made.
//
//   row: key, member of a struct, kind (type, range, names of an enum), sentence, key of --with
//     ├─> the JSON Schema; the committed *.schema.json are written from it (schema_files_test)
//     ├─> range checks and their sentences, which schema_sentences.hpp makes from the schema
//     ├─> reading: what is valid by the schema becomes the struct, once
//     └─> what `replay --with` may change, and what it is called there
//
// A key ends in its unit (_deg, _ms). A setting that a file leaves out keeps the initial value of
// its member: the default stands there alone. Rules across settings are code, on the structs. A new
// setting is its member, its row, its use and its test.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "engine/numerics/vector.hpp"

namespace impetus::inline settings {

using OrderedJson = nlohmann::ordered_json;

/// A setting that `replay --with` may change.
struct WithKey {
  std::string key;
  std::string words;    ///< what it is, and what it may be
  std::string pointer;  ///< from the struct that has it
};

/// What a value is in a file.
struct Form {
  OrderedJson schema;
  OrderedJson definitions = OrderedJson::object();  ///< that `schema` refers to, by name
  std::vector<WithKey> with{};                      ///< within it
};

/// And how it becomes a T.
template <typename T>
struct Kind : Form {
  std::function<T(const nlohmann::json&)> read;
};

/// From least to most, both allowed; or more than least.
struct NumberRange {
  double least{-std::numeric_limits<double>::infinity()};
  double most{std::numeric_limits<double>::infinity()};
  bool is_open{false};
};
inline NumberRange above(double least, double most = std::numeric_limits<double>::infinity()) {
  return {least, most, true};
}

Kind<double> number(NumberRange range);
Kind<bool> flag();
Kind<std::string> text();      ///< not empty
Kind<std::string> any_text();  ///< may be empty
Kind<std::string> text_like(const std::string& pattern);
Kind<std::string> one_of(const std::vector<std::string>& names);
Kind<Vector3> vector(NumberRange range);

/// A whole number, as an Integer.
Form whole_form(NumberRange range);
template <typename Integer>
Kind<Integer> whole(NumberRange range) {
  return {whole_form(range), [](const nlohmann::json& value) { return value.get<Integer>(); }};
}

/// What words in a file stand for, in the order in which messages list them.
template <typename T>
using Names = std::vector<std::pair<std::string, T>>;

template <typename T>
Kind<T> choice(const Names<T>& names) {
  std::vector<std::string> words;
  std::map<std::string, T> meanings;
  for (const auto& [word, meaning] : names) {
    words.push_back(word);
    meanings.emplace(word, meaning);
  }
  return {one_of(words), [meanings](const nlohmann::json& value) {
            return meanings.at(value.get_ref<const std::string&>());
          }};
}

/// The word for a value that is among the names.
template <typename T>
const std::string& word_for(const T& meaning, const Names<T>& names) {
  std::size_t i = 0;
  while (names[i].second != meaning) {
    ++i;
  }
  return names[i].first;
}

/// How many values a list has.
struct ListLength {
  int least{0};
  int most{-1};        ///< -1: any number
  bool is_set{false};  ///< no value comes twice
};
Form list_form(const Form& item, ListLength length);

template <typename T>
Kind<std::vector<T>> list(const Kind<T>& item, ListLength length) {
  return {list_form(item, length), [read = item.read](const nlohmann::json& values) {
            std::vector<T> result;
            result.reserve(values.size());
            for (const nlohmann::json& value : values) {
              result.push_back(read(value));
            }
            return result;
          }};
}

template <std::size_t kSize, typename T>
Kind<std::array<T, kSize>> several(const Kind<T>& item) {
  constexpr int kLength = static_cast<int>(kSize);
  return {list_form(item, {kLength, kLength}), [read = item.read](const nlohmann::json& values) {
            std::array<T, kSize> result;
            for (std::size_t i = 0; i < kSize; ++i) {
              result[i] = read(values[i]);
            }
            return result;
          }};
}

/// An object whose keys are anybody's.
Form by_name_form(const Form& value);

template <typename T>
Kind<std::map<std::string, T>> by_name(const Kind<T>& value) {
  return {by_name_form(value), [read = value.read](const nlohmann::json& values) {
            std::map<std::string, T> result;
            for (auto entry = values.begin(); entry != values.end(); ++entry) {
              result.emplace(entry.key(), read(entry.value()));
            }
            return result;
          }};
}

/// The form with a sentence that says what the value is; "": it has none.
Form described(const std::string& sentence, Form form);

/// The kind under a name in the schema's definitions, which is referred to.
Form defined_form(const std::string& name, Form form, const std::string& sentence);

template <typename T>
Kind<T> defined(const std::string& name, const Kind<T>& kind, const std::string& sentence = "") {
  return {defined_form(name, kind, sentence), kind.read};
}

/// One setting of a Struct.
template <typename Struct>
struct Row {
  std::string key;
  Form form;
  bool is_required{false};
  std::function<void(const nlohmann::json&, Struct&)> read;  ///< none: it is for people alone

  /// The same of a struct that has all that Struct has.
  template <typename Derived>
  operator Row<Derived>() const {  // NOLINT(google-explicit-constructor)
    return {key, form, is_required, read};
  }

  /// The same of a setting that every file has.
  [[nodiscard]] Row in_every_file() const {
    Row row = *this;
    row.is_required = true;
    return row;
  }

  /// With a key of `replay --with`.
  [[nodiscard]] Row with(const std::string& name, const std::string& words) const {
    Row row = *this;
    row.form.with.push_back({name, words, ""});
    return row;
  }
};

/// A setting that may be left out.
template <typename Struct, typename Member, typename T>
Row<Struct> row(const std::string& key, Member Struct::*member, const Kind<T>& kind,
                const std::string& sentence = "") {
  return {key, described(sentence, kind), false,
          [member, read = kind.read](const nlohmann::json& value, Struct& into) {
            into.*member = read(value);
          }};
}

/// The same of a struct within the struct.
template <typename Struct, typename Inner, typename Member, typename T>
Row<Struct> row(const std::string& key, Inner Struct::*inner, Member Inner::*member,
                const Kind<T>& kind, const std::string& sentence = "") {
  return {key, described(sentence, kind), false,
          [inner, member, read = kind.read](const nlohmann::json& value, Struct& into) {
            into.*inner.*member = read(value);
          }};
}

/// A setting that every file has.
template <typename... Arguments>
auto required(const Arguments&... arguments) {
  return row(arguments...).in_every_file();
}

/// A key of the file that the program does not read.
template <typename Struct>
Row<Struct> unread(const std::string& key, const Form& form, bool is_required = false) {
  return {key, form, is_required, nullptr};
}

/// The row of a struct within the struct.
template <typename Struct, typename Inner>
Row<Struct> row_within(Inner Struct::*inner, const Row<Inner>& row) {
  return {row.key, row.form, row.is_required,
          [inner, read = row.read](const nlohmann::json& value, Struct& into) {
            read(value, into.*inner);
          }};
}

/// Of all rows of an object.
struct KeyForm {
  const std::string& key;
  const Form& form;
  bool is_required;
};
Form object_form(const std::string& sentence, const std::vector<KeyForm>& keys);

template <typename Struct>
Form object_form(const std::string& sentence, const std::vector<Row<Struct>>& rows) {
  std::vector<KeyForm> keys;
  for (const Row<Struct>& each : rows) {
    keys.push_back({each.key, each.form, each.is_required});
  }
  return object_form(sentence, keys);
}

/// What of `value` the rows say, put into the struct.
template <typename Struct>
void read_rows(const std::vector<Row<Struct>>& rows, const nlohmann::json& value, Struct& into) {
  for (const Row<Struct>& each : rows) {
    const auto found = value.find(each.key);
    if (each.read && found != value.end()) {
      each.read(*found, into);
    }
  }
}

/// An object with these keys and no others.
template <typename Struct>
Kind<Struct> object(const std::string& sentence, const std::vector<Row<Struct>>& rows) {
  return {object_form(sentence, rows), [rows](const nlohmann::json& value) {
            Struct result;
            read_rows(rows, value, result);
            return result;
          }};
}

/// An object of the file alone: what its rows say belongs to the struct as its other settings do.
template <typename Struct>
Row<Struct> group(const std::string& key, const std::vector<Row<Struct>>& rows,
                  const std::string& sentence = "") {
  return {key, object_form(sentence, rows), false,
          [rows](const nlohmann::json& value, Struct& into) { read_rows(rows, value, into); }};
}

/// The schema of a whole file.
OrderedJson file_schema(const std::string& title, const std::string& sentence, const Form& object);

/// The rows that every file begins with: which schema it goes by, and for people its title and
/// where it comes from. `first` may have the title among rows of the struct.
template <typename Struct>
std::vector<Row<Struct>> rows_of_file(const std::vector<Row<Struct>>& more,
                                      const std::vector<Row<Struct>>& first = {
                                          unread<Struct>("title", text(), true)}) {
  std::vector<Row<Struct>> rows{
      unread<Struct>("$schema", any_text()),
      unread<Struct>("schema_version", {OrderedJson{{"const", 1}}}, /*is_required=*/true)};
  rows.insert(rows.end(), first.begin(), first.end());
  rows.push_back(unread<Struct>("source", any_text()));
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace impetus::inline settings
