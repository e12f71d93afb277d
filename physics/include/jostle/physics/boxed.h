// SPDX-License-Identifier: MIT
//
// Heap-allocated value with value semantics. It keeps a struct with a large, rarely used member
// small.
#pragma once

#include <memory>
#include <utility>

namespace jostle::physics {

/// Owns a T on the heap. Copy, move, comparison and destruction behave as for a T member. Never
/// null: a moved-from Boxed holds a default-constructed T.
template <class T>
class Boxed {
public:
    Boxed() : value_(std::make_unique<T>()) {}
    /// Implicit, so that a T initializes a Boxed<T>.
    Boxed(T value) : value_(std::make_unique<T>(std::move(value))) {}
    Boxed(const Boxed& other) : value_(std::make_unique<T>(*other)) {}
    /// Leaves a default-constructed T in `other`.
    // NOLINTNEXTLINE(performance-noexcept-move-constructor): it allocates
    Boxed(Boxed&& other) : value_(std::exchange(other.value_, std::make_unique<T>())) {}
    Boxed& operator=(const Boxed& other) {
        *value_ = *other;
        return *this;
    }
    Boxed& operator=(Boxed&& other) noexcept {
        std::swap(value_, other.value_);
        return *this;
    }
    ~Boxed() = default;

    T& operator*() { return *value_; }
    const T& operator*() const { return *value_; }
    T* operator->() { return value_.get(); }
    const T* operator->() const { return value_.get(); }

    bool operator==(const Boxed& other) const { return *value_ == *other; }

private:
    std::unique_ptr<T> value_;
};

}  // namespace jostle::physics
