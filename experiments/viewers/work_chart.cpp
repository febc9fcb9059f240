// SPDX-License-Identifier: MIT
#include "experiments/viewers/work_chart.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "experiments/drawing/palette.hpp"

namespace impetus::inline viewers {
namespace {

constexpr ImU32 kSpent = palette::kAccent;
constexpr ImU32 kFloor = palette::kHold;
constexpr ImU32 kBudget = palette::kWarning;

/// The next of 1, 2, 5, 10, 20, 50 ... from `value` up.
double round_up(double value) {
  double unit = 10.0;
  while (true) {
    for (const double step : {1.0, 2.0, 5.0}) {
      if (step * unit >= value) {
        return step * unit;
      }
    }
    unit *= 10.0;
  }
}

class WorkChart {
 public:
  WorkChart(const Gui& gui, const PreviewRun& run, ImVec2 from, ImVec2 to)
      : font_(gui.fonts().small),
        run_(run),
        draw_(*ImGui::GetWindowDrawList()),
        from_(from.x, from.y + 1.5F * font_->FontSize),
        to_(to),
        by_tests_(run.settings().budget == BudgetUnit::kTests) {
    double most = by_tests_ ? run.settings().tests_per_step : 0.0;
    for (const WorkOfStep& step : run.work()) {
      most = std::max(most, static_cast<double>(step.spent));
    }
    top_ = round_up(1.1 * most);
  }

  void draw() {
    draw_.AddRectFilled(from_, to_, palette::kSurface, 3.0F);
    columns();
    if (by_tests_) {
      const float budget = y(run_.settings().tests_per_step);
      draw_.AddLine(ImVec2(from_.x, budget), ImVec2(to_.x, budget), kBudget, 1.5F);
    }
    draw_.AddRect(from_, to_, palette::kLine, 3.0F);
    char text[32];
    std::snprintf(text, sizeof text, "%.0f", top_);
    draw_.AddText(font_, font_->FontSize, ImVec2(from_.x + 4, from_.y + 1), palette::kQuietText,
                  text);
  }

  void key() {
    const WorkOfStep last = run_.work().empty() ? WorkOfStep{} : run_.work().back();
    const double span_s = static_cast<double>(run_.work_span()) / run_.scene().step_hz;
    char title[80];
    std::snprintf(title, sizeof title, "Work per step, last %.0f s", span_s);
    float left = text(title, from_.x, palette::kText) + 1.4F * font_->FontSize;
    left = entry(left, kSpent, "spent", last.spent);
    left = entry(left, kFloor, "floor", last.floor);
    if (by_tests_) {
      entry(left, kBudget, "budget", last.granted);
    }
  }

 private:
  [[nodiscard]] float y(double tests) const {
    const double share = std::min(1.0, tests / top_);
    return to_.y - static_cast<float>(share) * (to_.y - from_.y - 2.0F) - 1.0F;
  }

  /// One column per pixel, the newest step at the right edge; the most of the steps it covers.
  void columns() {
    const auto& work = run_.work();
    const float width = to_.x - from_.x - 2.0F;
    const auto span = static_cast<double>(run_.work_span());
    const double empty = span - static_cast<double>(work.size());
    for (int column = 0; column < static_cast<int>(width); ++column) {
      const auto index_at = [&](int x) {
        const double index = span * x / static_cast<double>(width) - empty;
        return static_cast<std::int64_t>(std::floor(index));
      };
      const std::int64_t end = std::min(std::max(index_at(column + 1), index_at(column) + 1),
                                        static_cast<std::int64_t>(work.size()));
      WorkOfStep most;
      for (std::int64_t i = std::max<std::int64_t>(0, index_at(column)); i < end; ++i) {
        const WorkOfStep& step = work[static_cast<std::size_t>(i)];
        most.spent = std::max(most.spent, step.spent);
        most.floor = std::max(most.floor, step.floor);
      }
      if (end > 0 && most.spent > 0) {
        const float x = from_.x + 1.0F + static_cast<float>(column);
        bar(x, most.spent, kSpent);
        bar(x, most.floor, kFloor);
      }
    }
  }

  void bar(float x, std::int64_t tests, ImU32 colour) {
    draw_.AddRectFilled(ImVec2(x, y(static_cast<double>(tests))), ImVec2(x + 1, to_.y - 1), colour);
  }

  float text(const char* words, float left, ImU32 colour) {
    draw_.AddText(font_, font_->FontSize, ImVec2(left, from_.y - 1.35F * font_->FontSize), colour,
                  words);
    return left + font_->CalcTextSizeA(font_->FontSize, 1e6F, 0.0F, words).x;
  }

  float entry(float left, ImU32 colour, const char* name, std::int64_t tests) {
    const float side = std::round(0.7F * font_->FontSize);
    const float top = from_.y - 1.15F * font_->FontSize;
    draw_.AddRectFilled(ImVec2(left, top), ImVec2(left + side, top + side), colour, 2.0F);
    char words[60];
    std::snprintf(words, sizeof words, "%s %lld", name, static_cast<long long>(tests));
    return text(words, left + 1.5F * side, palette::kQuietText) + 1.2F * font_->FontSize;
  }

  ImFont* font_;
  const PreviewRun& run_;
  ImDrawList& draw_;
  ImVec2 from_;
  ImVec2 to_;
  bool by_tests_;
  double top_{1.0};
};

}  // namespace

void draw_work_chart(const Gui& gui, const PreviewRun& run, ImVec2 from, ImVec2 to) {
  WorkChart chart(gui, run, from, to);
  chart.draw();
  chart.key();
}

}  // namespace impetus::inline viewers
