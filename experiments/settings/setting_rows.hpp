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
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
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

/// What a word that is among the names stands for.
template <typename T>
T meaning_of(const std::string& word, const Names<T>& names) {
  std::size_t i = 0;
  while (names.at(i).first != word) {
    ++i;
  }
  return names[i].second;
}

template <typename T>
Kind<T> choice(const Names<T>& names) {
  std::vector<std::string> words;
  for (const auto& [word, meaning] : names) {
    words.push_back(word);
  }
  return {one_of(words), [names](const nlohmann::json& value) {
            return meaning_of(value.get_ref<const std::string&>(), names);
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

/// One setting, of whatever struct: Row says of which. What rows have in common is compiled once,
/// not for every struct: it would be a third of what a compiler does with a file of rows.
struct AnyRow {
  using Read = std::function<void(const nlohmann::json&, void* into)>;

  AnyRow(std::string_view key, const Form& form, std::string_view sentence, Read read);

  std::string key;
  Form form;
  bool is_required{false};
  Read read;  ///< none: it is for people alone
};

/// The row of what is at a place within a struct, so many bytes from where it begins.
AnyRow row_at(std::ptrdiff_t place, AnyRow row);

/// One of a Struct, to see in which places its members are.
template <typename Struct>
const Struct& any_struct() {
  static const Struct whole{};
  return whole;
}

inline std::ptrdiff_t bytes_between(const void* from, const void* to) {
  return static_cast<const char*>(to) - static_cast<const char*>(from);
}

/// Where a member is in its struct.
template <typename Struct, typename Member>
std::ptrdiff_t place_of(Member Struct::*member) {
  const Struct& whole = any_struct<Struct>();
  return bytes_between(&whole, &(whole.*member));
}

/// Where a base is in a struct that has all that the base has.
template <typename Struct, typename Base>
std::ptrdiff_t place_of_base() {
  const Struct& whole = any_struct<Struct>();
  return bytes_between(&whole, static_cast<const Base*>(&whole));
}

/// One setting of a Struct.
template <typename Struct>
struct Row : AnyRow {
  explicit Row(AnyRow row) : AnyRow(std::move(row)) {}

  /// A setting that may be left out; `put` is called with the value and the Struct.
  template <typename Put>
  Row(std::string_view name, const Form& value, std::string_view sentence, Put put)
      : AnyRow(name, value, sentence,
               [put = std::move(put)](const nlohmann::json& found, void* into) {
                 put(found, *static_cast<Struct*>(into));
               }) {}

  /// The same of a struct that has all that Base has.
  template <typename Base>
  Row(const Row<Base>& row)  // NOLINT(google-explicit-constructor)
      : AnyRow(row_at(place_of_base<Struct, Base>(), row)) {}

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

/// What a kind reads, put into a member.
template <typename Member, typename T>
AnyRow::Read put_into(const Kind<T>& kind) {
  return [read = kind.read](const nlohmann::json& value, void* member) {
    *static_cast<Member*>(member) = read(value);
  };
}

/// A setting that may be left out.
template <typename Struct, typename Member, typename T>
Row<Struct> row(std::string_view key, Member Struct::*member, const Kind<T>& kind,
                std::string_view sentence = "") {
  return Row<Struct>(row_at(place_of(member), AnyRow(key, kind, sentence, put_into<Member>(kind))));
}

/// The same of a struct within the struct.
template <typename Struct, typename Inner, typename Member, typename T>
Row<Struct> row(std::string_view key, Inner Struct::*inner, Member Inner::*member,
                const Kind<T>& kind, std::string_view sentence = "") {
  return Row<Struct>(row_at(place_of(inner) + place_of(member),
                            AnyRow(key, kind, sentence, put_into<Member>(kind))));
}

/// A setting that every file has.
template <typename... Arguments>
auto required(const Arguments&... arguments) {
  return row(arguments...).in_every_file();
}

/// A key of the file that the program does not read.
template <typename Struct>
Row<Struct> unread(std::string_view key, const Form& form, std::string_view sentence = "") {
  return Row<Struct>(AnyRow(key, form, sentence, nullptr));
}

/// Settings of whatever struct; RowList says of which.
class AnyRowList {
 public:
  [[nodiscard]] Form form(const std::string& sentence) const;

  /// What of `value` the rows say, put into the struct.
  void read(const nlohmann::json& value, void* into) const;

  [[nodiscard]] auto begin() const { return rows_.begin(); }
  [[nodiscard]] auto end() const { return rows_.end(); }

 protected:
  void append_row(const AnyRow& row);
  void append_rows(const AnyRowList& rows, std::ptrdiff_t place = 0);

 private:
  std::vector<AnyRow> rows_;
};

/// Settings of a Struct.
template <typename Struct>
class RowList : public AnyRowList {
 public:
  RowList(std::initializer_list<Row<Struct>> rows = {}) {
    for (const Row<Struct>& each : rows) {
      append_row(each);
    }
  }

  RowList& append(const Row<Struct>& row) {
    append_row(row);
    return *this;
  }

  RowList& append(const RowList& rows) {
    append_rows(rows);
    return *this;
  }

  /// The rows of what the Struct is besides.
  template <typename Base>
  RowList& append_base(const RowList<Base>& rows) {
    append_rows(rows, place_of_base<Struct, Base>());
    return *this;
  }

  /// The rows of a struct within the Struct.
  template <typename Inner>
  RowList& append_within(Inner Struct::*inner, const RowList<Inner>& rows) {
    append_rows(rows, place_of(inner));
    return *this;
  }
};

/// An object with these keys and no others.
template <typename Struct>
Kind<Struct> object(const std::string& sentence, const RowList<Struct>& rows) {
  return {rows.form(sentence), [rows](const nlohmann::json& value) {
            Struct result;
            rows.read(value, &result);
            return result;
          }};
}

/// An object of the file alone: what its rows say belongs to the struct as its other settings do.
template <typename Struct>
Row<Struct> group(std::string_view key, const RowList<Struct>& rows,
                  std::string_view sentence = "") {
  return {key, rows.form(""), sentence,
          [rows](const nlohmann::json& value, Struct& into) { rows.read(value, &into); }};
}

/// The schema of a whole file.
OrderedJson file_schema(const std::string& title, const std::string& sentence, const Form& object);

/// The rows that every file begins with: which schema it goes by, and for people its title and
/// where it comes from. `first` may have the title among rows of the struct.
template <typename Struct>
RowList<Struct> rows_of_file(const RowList<Struct>& more,
                             const RowList<Struct>& first = {
                                 unread<Struct>("title", text()).in_every_file()}) {
  RowList<Struct> rows{
      unread<Struct>("$schema", any_text()),
      unread<Struct>("schema_version", {OrderedJson{{"const", 1}}}).in_every_file()};
  return rows.append(first).append(unread<Struct>("source", any_text())).append(more);
}

}  // namespace impetus::inline settings
