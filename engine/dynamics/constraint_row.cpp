// SPDX-License-Identifier: MIT
#include "engine/dynamics/constraint_row.hpp"

#include <algorithm>

namespace impetus {

double dot(const ConstraintRow& row, const std::vector<Vector6>& u) {
  double sum = 0.0;
  for (const RowPart* part : {&row.a, &row.b}) {
    if (part->body >= 0) {
      sum += part->direction.dot(u[static_cast<std::size_t>(part->body)]);
    }
  }
  return sum;
}

double dot(const ConstraintRow& x, const ConstraintRow& y) {
  double sum = 0.0;
  for (const RowPart* of_x : {&x.a, &x.b}) {
    for (const RowPart* of_y : {&y.a, &y.b}) {
      if (of_x->body >= 0 && of_x->body == of_y->body) {
        sum += of_x->direction.dot(of_y->direction);
      }
    }
  }
  return sum;
}

void add(std::vector<Vector6>& u, const ConstraintRow& row, double times) {
  for (const RowPart* part : {&row.a, &row.b}) {
    if (part->body >= 0) {
      u[static_cast<std::size_t>(part->body)] += times * part->direction;
    }
  }
}

void RowColumns::clear() {
  blocks_.clear();
  rows_ = 0;
}

void RowColumns::push_back(const ConstraintRow& row) {
  if (blocks_.empty() || blocks_.back().count == kLanes || blocks_.back().a != row.a.body ||
      blocks_.back().b != row.b.body) {
    Block block{};
    block.a = row.a.body;
    block.b = row.b.body;
    block.first_row = rows_;
    blocks_.push_back(block);
  }
  Block& block = blocks_.back();
  const std::size_t lane = block.count++;
  for (int i = 0; i < 6; ++i) {
    block.of_a[i][lane] = row.a.direction[i];
    block.of_b[i][lane] = row.b.direction[i];
  }
  block.bounds[lane] = row.bound;
  ++rows_;
}

void RowColumns::find_slacks(const std::vector<Vector6>& u, std::vector<double>& slacks) const {
  slacks.resize(rows_);
  for (const Block& block : blocks_) {
    double sums[kLanes] = {};
    // Two sums of three products, each from its end: the order in which Eigen adds six.
    const auto add_part = [&sums](const double(&d)[6][kLanes], const Vector6& v) {
      for (std::size_t i = 0; i < kLanes; ++i) {
        sums[i] += (d[0][i] * v[0] + (d[1][i] * v[1] + d[2][i] * v[2])) +
                   (d[3][i] * v[3] + (d[4][i] * v[4] + d[5][i] * v[5]));
      }
    };
    if (block.a >= 0) {
      add_part(block.of_a, u[static_cast<std::size_t>(block.a)]);
    }
    if (block.b >= 0) {
      add_part(block.of_b, u[static_cast<std::size_t>(block.b)]);
    }
    for (std::size_t i = 0; i < block.count; ++i) {
      slacks[block.first_row + i] = sums[i] - block.bounds[i];
    }
  }
}

}  // namespace impetus
