// SPDX-License-Identifier: MIT
//
// A world as it is between two ticks, copied by who comes first: whoever wants it, on a thread of
// his own while the world waits for its next tick, or the world before it goes on. Any thread.
#pragma once

#include <functional>
#include <mutex>
#include <new>
#include <optional>
#include <utility>

#include "server/world/checkpoint_copy.h"

namespace jostle::server {

class CheckpointCopier {
public:
    explicit CheckpointCopier(std::function<CheckpointCopy()> copy) : copy_(std::move(copy)) {}

    // Copies, or waits for who does; what it is copied of may change afterwards.
    void finish() {
        const std::lock_guard lock(mutex_);
        copy_now();
    }
    // Once. Nothing: there was no memory for it.
    std::optional<CheckpointCopy> take() {
        const std::lock_guard lock(mutex_);
        copy_now();
        return std::exchange(copy_result_, std::nullopt);
    }

private:
    void copy_now() {
        if (!copy_) return;
        try {
            copy_result_ = std::exchange(copy_, nullptr)();
        } catch (const std::bad_alloc&) {
            copy_result_.reset();
        }
    }

    std::mutex mutex_;
    std::function<CheckpointCopy()> copy_;  // empty: it was called
    std::optional<CheckpointCopy> copy_result_;
};

}  // namespace jostle::server
