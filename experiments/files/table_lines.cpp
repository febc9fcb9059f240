// SPDX-License-Identifier: MIT
#include "experiments/files/table_lines.hpp"

#include <csv.h>

#include <algorithm>
#include <new>
#include <utility>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline files {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBlanks = " \t";

/// The lines of a table. Each is given to libcsv on its own, which knows no numbers of lines and
/// would look for the end of a quotation in all that follows.
class Lines {
 public:
  /// Those that are not blank, with the same number of cells each.
  static std::vector<TableLine> of(const std::string& file, std::string_view text) {
    Lines lines(file);
    text.remove_prefix(text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
    while (!text.empty()) {
      const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
      lines.take(text.substr(0, end));
      text.remove_prefix(end);
      text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(text.size(), 1));
    }
    return std::move(lines.all_);
  }

  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;
  ~Lines() { csv_free(&parser_); }

 private:
  explicit Lines(const std::string& file) : file_(file) {
    csv_init(&parser_, CSV_STRICT | CSV_STRICT_FINI);
  }

  void take(std::string_view text) {
    ++number_;
    if (text.find('\0') != std::string_view::npos) {
      refuse("text in UTF-8, got a byte that is zero");
    }
    if (all_.empty()) {
      csv_set_delim(&parser_, static_cast<unsigned char>(separator_of(text)));
    }
    take_apart(text);
    if (cells_.empty()) {
      return;
    }
    if (!all_.empty() && cells_.size() != all_[0].cells.size()) {
      refuse(std::to_string(all_[0].cells.size()) + " cells, one for each name, got " +
             std::to_string(cells_.size()));
    }
    all_.push_back({number_, std::move(cells_)});
    cells_.clear();
  }

  void take_apart(std::string_view text) {
    const std::size_t taken =
        csv_parse(&parser_, text.data(), text.size(), take_cell, nullptr, this);
    if (taken < text.size() && csv_error(&parser_) != CSV_EPARSE) {
      throw std::bad_alloc();
    }
    if (taken < text.size()) {
      refuse("quotation marks only around whole cells, or doubled within one, got one at byte " +
             std::to_string(text.rfind('"', taken) + 1) + " of the line");
    }
    if (csv_fini(&parser_, take_cell, nullptr, this) != 0) {
      refuse("a quotation mark that ends its cell in the same line, got none");
    }
  }

  /// Of comma, tab and semicolon, the one that the line of names has most of.
  static char separator_of(std::string_view names) {
    const auto count = [&](char one) { return std::count(names.begin(), names.end(), one); };
    return std::max({',', '\t', ';'}, [&](char a, char b) { return count(a) < count(b); });
  }

  /// Without the blanks around it, which libcsv leaves within quotation marks.
  static void take_cell(void* cell, std::size_t size, void* lines) {
    std::string_view text(static_cast<const char*>(cell), size);
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    text = text.substr(0, text.find_last_not_of(kBlanks) + 1);
    static_cast<Lines*>(lines)->cells_.emplace_back(text);
  }

  [[noreturn]] void refuse(const std::string& expected) const {
    refuse_table_line(file_, number_, expected);
  }

  const std::string& file_;
  csv_parser parser_;
  std::vector<TableLine> all_;
  std::size_t number_{0};  ///< of the line that is taken apart
  std::vector<std::string> cells_;
};

}  // namespace

void refuse_table_line(const std::string& file, std::size_t number, const std::string& expected) {
  throw InputError(file + ":" + std::to_string(number) + ": expected " + expected);
}

std::vector<TableLine> table_lines(const std::string& file, std::string_view text) {
  return Lines::of(file, text);
}

}  // namespace impetus::inline files
