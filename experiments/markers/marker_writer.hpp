// Sends markers on a thread of its own, and keeps when each was sent.
// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "experiments/markers/marker_line.hpp"
#include "experiments/record/ports.hpp"

namespace impetus::inline markers {

/// How many events were marked, and of how many nobody knows when their marker was sent.
struct MarkerCounts {
  std::size_t marked{0};
  std::size_t lost{0};
};

/// What is told here goes to the line in that order.
class MarkerWriter final : public Markers {
 public:
  /// `clock` stamps flips, and must outlive this.
  MarkerWriter(std::unique_ptr<MarkerLine> line, MarkerCodes codes, const Clock& clock);
  ~MarkerWriter() override;  ///< sends what is left
  MarkerWriter(const MarkerWriter&) = delete;
  MarkerWriter& operator=(const MarkerWriter&) = delete;

  void mark(MarkedEvent event, std::int64_t event_ns, std::int64_t interval) override;
  std::vector<MarkerRecord> take() override;

  /// Of all that take() has given.
  [[nodiscard]] MarkerCounts counts() const { return counts_; }

 private:
  void send_until_the_end();

  std::unique_ptr<MarkerLine> line_;
  MarkerCodes codes_;
  const Clock& clock_;
  std::mutex mutex_;  ///< of all below
  std::condition_variable told_;
  std::condition_variable sent_;
  std::deque<MarkerRecord> waiting_;   ///< to be sent; the first may be on its way
  std::vector<MarkerRecord> records_;  ///< since the last take()
  std::size_t sent_count_{0};          ///< markers that were sent or given up
  MarkerCounts counts_;
  bool ends_{false};
  std::thread thread_;
};

}  // namespace impetus::inline markers
