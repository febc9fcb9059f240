// A value that is rarely there, kept elsewhere: whoever does without pays for a pointer.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

namespace impetus::inline world {

/// Copies what it points to.
template <typename Value>
class ValuePointer {
 public:
  ValuePointer() = default;
  explicit ValuePointer(Value value) : value_(std::make_unique<Value>(std::move(value))) {}
  ValuePointer(const ValuePointer& other)
      : value_(other.value_ ? std::make_unique<Value>(*other.value_) : nullptr) {}
  ValuePointer(ValuePointer&&) noexcept = default;
  ValuePointer& operator=(const ValuePointer& other) {
    *this = ValuePointer(other);
    return *this;
  }
  ValuePointer& operator=(ValuePointer&&) noexcept = default;
  ~ValuePointer() = default;

  explicit operator bool() const { return value_ != nullptr; }
  Value& operator*() { return *value_; }
  const Value& operator*() const { return *value_; }
  Value* operator->() { return value_.get(); }
  const Value* operator->() const { return value_.get(); }

 private:
  std::unique_ptr<Value> value_;
};

}  // namespace impetus::inline world
