// SPDX-License-Identifier: MIT
#include "experiments/trade/trade_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace impetus::inline trade {
namespace {

std::string kind_words(TreeKind kind) {
  switch (kind) {
    case TreeKind::kOctree:
      return "an octree's spheres";
    case TreeKind::kMedial:
      return "medial spheres";
    case TreeKind::kVoxel:
      return "voxels";
    case TreeKind::kBox:
      return "oriented boxes";
    case TreeKind::kSwept:
      return "swept spheres";
    case TreeKind::kHeterogeneous:
      return "volumes of mixed kinds";
  }
  return name_of(kind);
}

std::string reduction_words(const std::string& reduction) {
  static const std::map<std::string, std::string> words{
      {"none", "all contacts"},       {"first", "the first contact"},
      {"average", "one average"},     {"groups", "grouped averages"},
      {"density", "density normals"}, {"weighted", "weighted averages"}};
  const auto known = words.find(reduction);
  return known == words.end() ? reduction : known->second;
}

}  // namespace

std::string two_digits(double value) {
  if (value == 0.0 || !std::isfinite(value)) {
    return value == 0.0 ? "0" : "?";
  }
  const int before_point = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  const double unit = std::pow(10.0, before_point - 2);
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.*f", std::max(0, 2 - before_point),
                std::round(value / unit) * unit);
  std::string text = digits;
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    text.erase(text.find_last_not_of('.') + 1);
  }
  return text;
}

std::string two_digits_from(double least, double value) {
  return value < least ? "< " + two_digits(least) : two_digits(value);
}

std::string words_for(const TradeOption& option) {
  return kind_words(option.kind) + " to level " + std::to_string(option.level) + " with " +
         reduction_words(option.reduction);
}

std::string error_words(const TradeOption& option) {
  const double normal_deg = option.normal_deg.value;
  return "median normal error " +
         (normal_deg < kLeastNormal_deg ? "below " + two_digits(kLeastNormal_deg)
                                        : two_digits(normal_deg)) +
         "°, 95 % of gaps below " +
         two_digits(std::max(kLeastGap_arcmin, option.gap_arcmin.value)) + " minutes of arc";
}

}  // namespace impetus::inline trade
