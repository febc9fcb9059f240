// SPDX-License-Identifier: MIT
#include "engine/dynamics/row_columns.hpp"

#include <cmath>

namespace impetus::inline dynamics {
namespace {

/// sums += x · y, lane by lane
void add_products(const LanesOf6& x, const LanesOf6& y, double (&sums)[kRowLanes]) {
  for (std::size_t i = 0; i < kRowLanes; ++i) {
    sums[i] += (x[0][i] * y[0][i] + (x[1][i] * y[1][i] + x[2][i] * y[2][i])) +
               (x[3][i] * y[3][i] + (x[4][i] * y[4][i] + x[5][i] * y[5][i]));
  }
}

/// sums += x · u, of one u for all lanes
void add_products(const LanesOf6& x, const Vector6& u, double (&sums)[kRowLanes]) {
  for (std::size_t i = 0; i < kRowLanes; ++i) {
    sums[i] += (x[0][i] * u[0] + (x[1][i] * u[1] + x[2][i] * u[2])) +
               (x[3][i] * u[3] + (x[4][i] * u[4] + x[5][i] * u[5]));
  }
}

void divide(const LanesOf6& lanes, const double (&by)[kRowLanes], LanesOf6& result) {
  for (std::size_t coordinate = 0; coordinate < 6; ++coordinate) {
    for (std::size_t i = 0; i < kRowLanes; ++i) {
      result[coordinate][i] = lanes[coordinate][i] / by[i];
    }
  }
}

/// |x|² of each lane.
void find_squares(const RowBlock& block, double (&squares)[kRowLanes]) {
  if (block.a >= 0) {
    add_products(block.of_a, block.of_a, squares);
  }
  if (block.a >= 0 && block.a == block.b) {  // the body twice: all four products
    add_products(block.of_a, block.of_b, squares);
    add_products(block.of_b, block.of_a, squares);
  }
  if (block.b >= 0) {
    add_products(block.of_b, block.of_b, squares);
  }
}

}  // namespace

void RowColumns::clear() {
  blocks_.clear();
  place_of_row_.clear();
}

RowBlock& RowColumns::add_block(std::int32_t a, std::int32_t b, std::size_t count) {
  RowBlock& block = blocks_.emplace_back();
  block.a = a;
  block.b = b;
  block.first_row = size();
  block.count = count;
  for (std::size_t lane = 0; lane < count; ++lane) {
    place_of_row_.push_back((blocks_.size() - 1) * kRowLanes + lane);
  }
  return block;
}

ConstraintRow RowColumns::row(std::size_t index) const {
  const RowBlock& block = blocks_[place_of_row_[index] / kRowLanes];
  const std::size_t lane = place_of_row_[index] % kRowLanes;
  ConstraintRow row;
  row.a.body = block.a;
  row.b.body = block.b;
  for (int i = 0; i < 6; ++i) {
    row.a.direction[i] = block.a >= 0 ? block.of_a[i][lane] : 0.0;
    row.b.direction[i] = block.b >= 0 ? block.of_b[i][lane] : 0.0;
  }
  return row;
}

void RowColumns::find_products(const std::vector<Vector6>& u, std::vector<double>& products) const {
  products.resize(size());
  for (const RowBlock& block : blocks_) {
    double sums[kRowLanes] = {};
    if (block.a >= 0) {
      add_products(block.of_a, u[static_cast<std::size_t>(block.a)], sums);
    }
    if (block.b >= 0) {
      add_products(block.of_b, u[static_cast<std::size_t>(block.b)], sums);
    }
    for (std::size_t i = 0; i < block.count; ++i) {
      products[block.first_row + i] = sums[i];
    }
  }
}

void RowColumns::make_unit(const RowColumns& of, std::vector<double>& lengths) {
  clear();
  lengths.resize(of.size());
  for (const RowBlock& block : of.blocks_) {
    double squares[kRowLanes] = {};
    find_squares(block, squares);
    double by[kRowLanes];
    for (std::size_t i = 0; i < kRowLanes; ++i) {
      squares[i] = std::sqrt(squares[i]);
      by[i] = squares[i] > 0.0 ? squares[i] : 1.0;
    }
    for (std::size_t i = 0; i < block.count; ++i) {
      lengths[block.first_row + i] = squares[i];
    }
    RowBlock& unit = add_block(block.a, block.b, block.count);
    if (block.a >= 0) {
      divide(block.of_a, by, unit.of_a);
    }
    if (block.b >= 0) {
      divide(block.of_b, by, unit.of_b);
    }
  }
}

}  // namespace impetus::inline dynamics
