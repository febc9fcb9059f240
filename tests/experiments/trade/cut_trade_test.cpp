// What steps give up of which a phase was cut.
// SPDX-License-Identifier: MIT
#include "experiments/trade/crowds/cut_trade.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "tests/experiments/crowded_trade.hpp"

namespace impetus::cut_trade_test {

/// L-blocks that go so fast that they must be searched for entries.
const std::vector<CutCrowd>& cut_crowds() {
  static const std::vector<CutCrowd> crowds = [] {
    json scene = dense_crowd();
    scene["engine"]["tunnelling"] = "stop-at-entry";
    scene["crowd"]["speed_deg_s"] = 60;
    CutRequest request;
    request.orders = {{kOwnScheduler}, {kRandomScheduler}};
    request.courses = 2;
    return cut_trade(built(scene), request);
  }();
  return crowds;
}

double visible_error(const CutCrowd& crowd) {
  return std::accumulate(crowd.steps.begin(), crowd.steps.end(), 0.0,
                         [](double sum, const CutStep& step) { return sum + step.visible_error; });
}

TEST(CutTrade, EachPhaseIsCutToEachPart) {
  std::set<std::pair<std::string, std::int64_t>> tried;
  for (const CutCrowd& crowd : cut_crowds()) {
    tried.insert({crowd.phase->name, crowd.part});
    EXPECT_EQ(crowd.steps.size(), 6U) << "every half second of three";
    EXPECT_EQ(crowd.elsewhere.size(), 2U);
  }
  EXPECT_EQ(tried.size(), 3U * 7U);
}

TEST(CutTrade, LessOfAPhaseShowsMore) {
  int compared = 0;
  for (const CutCrowd& least : cut_crowds()) {
    for (const CutCrowd& all : cut_crowds()) {
      if (least.part == 64 && all.part == 1 && least.phase == all.phase &&
          least.order_place == all.order_place) {
        EXPECT_GT(visible_error(least), visible_error(all)) << least.phase->name;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 5) << "two phases in two orders, and the entry";
}

TEST(CutTrade, RowsNameThePhaseThePartAndTheOrder) {
  const std::vector<TradeRow> rows = cut_rows(cut_crowds(), {{"scene"}, {"random"}}, "crowd");
  EXPECT_EQ(rows.size(), 3 * cut_crowds().size());
  const TradeRow& first = rows.front();
  EXPECT_EQ(first.part, "cut");
  EXPECT_EQ(first.phase, "refinement");
  EXPECT_EQ(first.reference, "whole/64");
  EXPECT_EQ(first.scheduler, "scene");
  EXPECT_GT(first.value, 0.0);
  for (const TradeRow& row : rows) {
    EXPECT_EQ(row.scheduler.empty(), row.phase == "entry");
    EXPECT_GE(row.value, 0.0) << row.phase << " " << row.measure;
  }
}

TEST(CutTrade, ThePageHasAColumnForEachPart) {
  const std::string page = cut_page(cut_rows(cut_crowds(), {{"scene"}, {"random"}}, "crowd"));
  EXPECT_NE(page.find("| phase | order | measure | 1/64 | 1/32 | 1/16 | 1/8 | 1/4 | 1/2 | all |\n"),
            std::string::npos)
      << page;
  EXPECT_NE(page.find("\n| response | random | wrong_velocity, 1 | "), std::string::npos) << page;
  EXPECT_EQ(cut_page({}), "");
}

}  // namespace impetus::cut_trade_test
