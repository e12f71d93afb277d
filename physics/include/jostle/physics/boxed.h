// SPDX-License-Identifier: MIT
//
// A value that lies elsewhere, so that what holds it stays small. Copied, compared and destroyed
// with its holder, as if it lay within. It is always there.
#pragma once

#include <memory>
#include <utility>

namespace jostle::physics {

template <class T>
class Boxed {
public:
    Boxed() : value_(std::make_unique<T>()) {}
    Boxed(T value) : value_(std::make_unique<T>(std::move(value))) {}  // implicit: it is a T
    Boxed(const Boxed& other) : value_(std::make_unique<T>(*other)) {}
    // What was moved from is as good as new.
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
