// SPDX-License-Identifier: MIT
//
// Makes one copy of a world between two ticks. The thread that needs it first makes it: the reader,
// while the world waits for its next tick, or the tick thread before its next tick. Any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <new>
#include <optional>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/physics/restore_point.h"
#include "server/world/saved_host_state.h"

namespace jostle::server {

// The complete state of a world after a tick.
struct CheckpointCopy {
    std::uint32_t tick = 0;
    physics::RestorePoint bodies;
    SavedHostState host_state;
};

class CheckpointCopier {
public:
    explicit CheckpointCopier(std::function<CheckpointCopy()> copy) : copy_(std::move(copy)) {
        ASSERT(copy_);
    }

    // Makes the copy unless it exists, or waits for the thread that makes it. The world may change
    // afterwards.
    void finish() {
        const std::lock_guard lock(mutex_);
        copy_now();
    }
    // Call it once. Nothing: the copy ran out of memory.
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
    std::function<CheckpointCopy()> copy_;  // empty after its call
    std::optional<CheckpointCopy> copy_result_;
};

}  // namespace jostle::server
