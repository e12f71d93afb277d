// SPDX-License-Identifier: MIT
//
// A queue of few items; a server has several per client. It allocates nothing until the first item
// and stays small for few items (an empty std::deque takes 576 bytes). References are valid until
// the next change.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "jostle/base/check.h"

namespace jostle::server {

template <class T>
class Fifo {
public:
    bool empty() const { return first_ == items_.size(); }
    std::size_t size() const { return items_.size() - first_; }
    T& front() {
        ASSERT(!empty());
        return items_[first_];
    }
    const T& front() const {
        ASSERT(!empty());
        return items_[first_];
    }
    T& back() {
        ASSERT(!empty());
        return items_.back();
    }
    const T& back() const {
        ASSERT(!empty());
        return items_.back();
    }
    const T& operator[](std::size_t index) const {
        ASSERT(index < size());
        return items_[first_ + index];
    }
    auto begin() { return items_.begin() + offset(); }
    auto end() { return items_.end(); }
    auto begin() const { return items_.begin() + offset(); }
    auto end() const { return items_.end(); }
    auto rbegin() const { return items_.rbegin(); }
    auto rend() const { return items_.rend() - offset(); }

    void push_back(T item) { items_.push_back(std::move(item)); }
    void pop_back() {
        ASSERT(!empty());
        items_.pop_back();
    }
    void pop_front(std::size_t count = 1) {
        ASSERT(count <= size());
        for (; count > 0; count--) items_[first_++] = T();  // releases what the item held at once
        if (empty())
            clear();
        else if (first_ >= items_.size() / 2)
            items_.erase(items_.begin(), std::exchange(first_, 0) + items_.begin());
    }
    void clear() {
        first_ = 0;
        items_.clear();
        if (items_.capacity() > retained_capacity) items_ = {};
    }

private:
    // Items. After a burst, the memory beyond this capacity is released.
    static constexpr std::size_t retained_capacity = 64;

    std::ptrdiff_t offset() const { return static_cast<std::ptrdiff_t>(first_); }

    std::vector<T> items_;  // items before first_ are popped
    std::size_t first_ = 0;
};

}  // namespace jostle::server
