// SPDX-License-Identifier: MIT
#include "experiments/settings/setting_rows.hpp"

#include <cmath>

namespace impetus::inline settings {
namespace {

using nlohmann::json;

/// 5, where JSON would say 5.0.
OrderedJson bound(double number) {
  const bool is_whole = std::floor(number) == number && std::abs(number) < 1e15;
  return is_whole ? OrderedJson(static_cast<std::int64_t>(number)) : OrderedJson(number);
}

OrderedJson number_schema(const char* type, NumberRange range) {
  OrderedJson schema{{"type", type}};
  if (std::isfinite(range.least)) {
    schema[range.is_open ? "exclusiveMinimum" : "minimum"] = bound(range.least);
  }
  if (std::isfinite(range.most)) {
    schema["maximum"] = bound(range.most);
  }
  return schema;
}

Kind<std::string> string_kind(OrderedJson schema) {
  return {{std::move(schema)}, [](const json& value) { return value.get<std::string>(); }};
}

void put_below(const std::string& key, const Form& part, Form& whole) {
  whole.definitions.update(part.definitions);
  for (const WithKey& each : part.with) {
    whole.with.push_back({each.key, each.words, "/" + key + each.pointer});
  }
}

}  // namespace

Kind<double> number(NumberRange range) {
  return {{number_schema("number", range)}, [](const json& value) { return value.get<double>(); }};
}

Form whole_form(NumberRange range) { return {number_schema("integer", range)}; }

Kind<bool> flag() {
  return {{{{"type", "boolean"}}}, [](const json& value) { return value.get<bool>(); }};
}

Kind<std::string> text() { return string_kind({{"type", "string"}, {"minLength", 1}}); }

Kind<std::string> any_text() { return string_kind({{"type", "string"}}); }

Kind<std::string> text_like(const std::string& pattern) {
  return string_kind({{"type", "string"}, {"pattern", pattern}});
}

Kind<std::string> one_of(const std::vector<std::string>& names) {
  return string_kind({{"enum", names}});
}

Kind<Vector3> vector(NumberRange range) {
  return {list_form(number(range), {3, 3}), [](const json& values) {
            return Vector3(values[0].get<double>(), values[1].get<double>(),
                           values[2].get<double>());
          }};
}

Form list_form(const Form& item, ListLength length) {
  Form form{{{"type", "array"}}, item.definitions};
  if (length.least > 0) {
    form.schema["minItems"] = length.least;
  }
  if (length.most >= 0) {
    form.schema["maxItems"] = length.most;
  }
  if (length.is_set) {
    form.schema["uniqueItems"] = true;
  }
  form.schema["items"] = item.schema;
  return form;
}

Form by_name_form(const Form& value) {
  return {{{"type", "object"}, {"additionalProperties", value.schema}}, value.definitions};
}

Form described(const std::string& sentence, Form form) {
  if (!sentence.empty()) {
    OrderedJson schema{{"description", sentence}};
    schema.update(form.schema);
    form.schema = std::move(schema);
  }
  return form;
}

Form defined_form(const std::string& name, Form form, const std::string& sentence) {
  form.definitions[name] = described(sentence, form).schema;
  form.schema = {{"$ref", "#/definitions/" + name}};
  return form;
}

AnyRow::AnyRow(std::string_view key_, const Form& form_, std::string_view sentence, Read read_)
    : key(key_), form(described(std::string(sentence), form_)), read(std::move(read_)) {}

AnyRow row_at(std::ptrdiff_t place, AnyRow row) {
  if (row.read) {
    row.read = [place, read = row.read](const json& value, void* whole) {
      read(value, static_cast<char*>(whole) + place);
    };
  }
  return row;
}

Form AnyRowList::form(const std::string& sentence) const {
  Form form{{{"type", "object"}, {"additionalProperties", false}}};
  OrderedJson required = OrderedJson::array();
  OrderedJson properties = OrderedJson::object();
  for (const AnyRow& each : rows_) {
    if (each.is_required) {
      required.push_back(each.key);
    }
    properties[each.key] = each.form.schema;
    put_below(each.key, each.form, form);
  }
  if (!required.empty()) {
    form.schema["required"] = required;
  }
  form.schema["properties"] = properties;
  return described(sentence, form);
}

void AnyRowList::read(const json& value, void* into) const {
  for (const AnyRow& each : rows_) {
    const auto found = value.find(each.key);
    if (each.read && found != value.end()) {
      each.read(*found, into);
    }
  }
}

void AnyRowList::append_row(const AnyRow& row) { rows_.push_back(row); }

void AnyRowList::append_rows(const AnyRowList& rows, std::ptrdiff_t place) {
  for (const AnyRow& each : rows.rows_) {
    rows_.push_back(row_at(place, each));
  }
}

OrderedJson file_schema(const std::string& title, const std::string& sentence, const Form& object) {
  OrderedJson schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                     {"title", title},
                     {"description", sentence}};
  for (const char* key : {"type", "additionalProperties", "required"}) {
    schema[key] = object.schema[key];
  }
  if (!object.definitions.empty()) {
    schema["definitions"] = object.definitions;
  }
  schema["properties"] = object.schema["properties"];
  return schema;
}

}  // namespace impetus::inline settings
