// SPDX-License-Identifier: MIT
//
// In-memory storage that fails or delays on request. Any thread may control it.
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "server/storage/world_storage.h"

namespace jostle::test {

// Shared with the test, which gives up ownership of the storage.
struct FaultyState {
    std::atomic<int> delay_ms{0};  // per write
    std::mutex mutex;
    std::optional<Error> error;  // returned by every write
    std::vector<server::StorageChange> written;
    std::vector<std::size_t> groups;  // number of changes of each successful write

    void fail(std::optional<Error> with) {
        const std::lock_guard lock(mutex);
        error = std::move(with);
    }
    std::size_t size() {
        const std::lock_guard lock(mutex);
        return written.size();
    }
};

class FaultyStorage : public server::WorldStorage {
public:
    explicit FaultyStorage(std::shared_ptr<FaultyState> state) : state_(std::move(state)) {}

    Status write(std::span<const server::StorageChange> changes) override {
        std::this_thread::sleep_for(std::chrono::milliseconds(state_->delay_ms.load()));
        const std::lock_guard lock(state_->mutex);
        if (state_->error) return *state_->error;
        for (const server::StorageChange& change : changes)
            if (std::holds_alternative<server::DropWorld>(change))
                return Error{ErrorCode::not_found, "the world does not exist"};
        state_->written.insert(state_->written.end(), changes.begin(), changes.end());
        state_->groups.push_back(changes.size());
        return {};
    }
    Result<std::vector<server::StoredWorld>> worlds() override { return nothing(); }
    Result<std::vector<std::uint32_t>> checkpoint_ticks(const std::string&) override {
        return nothing();
    }
    Result<server::Checkpoint> checkpoint(const std::string&, std::uint32_t) override {
        return nothing();
    }
    Result<std::vector<server::JournalEntry>> entries(const std::string&, std::uint64_t,
                                                      std::size_t) override {
        return nothing();
    }
    Result<std::optional<std::string>> note(const std::string&) override { return nothing(); }

private:
    static Error nothing() { return {ErrorCode::unavailable, "this storage is write-only"}; }

    std::shared_ptr<FaultyState> state_;
};

}  // namespace jostle::test
