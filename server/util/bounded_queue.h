// SPDX-License-Identifier: MIT
//
// A queue between threads with a fixed capacity: many writers, one reader. push() reports a full
// queue, so that the writer can inform its client; no item is dropped silently.
#pragma once

#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

#include "jostle/base/check.h"

namespace jostle::server {

template <class T>
class BoundedQueue {
public:
    explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) { items_.reserve(capacity); }

    // Any thread. Returns false if the queue is full; the item is then not queued.
    bool push(T item) {
        const std::lock_guard lock(mutex_);
        if (items_.size() >= capacity_) return false;
        items_.push_back(std::move(item));
        ASSERT(items_.size() <= capacity_);
        return true;
    }

    // The reader: moves all items to `out` in order of arrival. `out` is cleared first; its memory
    // is reused for the next items.
    void drain_into(std::vector<T>& out) {
        out.clear();
        const std::lock_guard lock(mutex_);
        items_.swap(out);
        ASSERT(out.size() <= capacity_);
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
