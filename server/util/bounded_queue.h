// SPDX-License-Identifier: MIT
//
// A queue between threads with a fixed capacity: many writers, one reader. push() tells the truth
// when it is full, so that the writer can tell its client; nothing is ever dropped silently.
#pragma once

#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace jostle::server {

template <class T>
class BoundedQueue {
public:
    explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) { items_.reserve(capacity); }

    // Any thread. False: full, and the item was not taken.
    bool push(T item) {
        const std::lock_guard lock(mutex_);
        if (items_.size() >= capacity_) return false;
        items_.push_back(std::move(item));
        return true;
    }

    // The reader: all items in order of arrival. `out` is cleared first; its memory is reused for
    // the next ones.
    void drain_into(std::vector<T>& out) {
        out.clear();
        const std::lock_guard lock(mutex_);
        items_.swap(out);
    }

    std::size_t size() const {
        const std::lock_guard lock(mutex_);
        return items_.size();
    }

private:
    const std::size_t capacity_;
    mutable std::mutex mutex_;
    std::vector<T> items_;
};

}  // namespace jostle::server
