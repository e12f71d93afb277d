// SPDX-License-Identifier: MIT
//
// Worlds and journals for tests of storage.
#pragma once

#include <string>
#include <vector>

#include "server/storage/journal_chain.h"
#include "server/storage/storage_types.h"

namespace jostle::test {

inline server::StoredWorld stored_world(const std::string& id) {
    return {.id = id, .name = "The " + id, .epoch = 1, .engine = "1.2 fused", .settings = "scene"};
}

// Creates entries like a host: each entry follows the previous one.
class JournalMaker {
public:
    explicit JournalMaker(std::string world) : world_(std::move(world)) {}

    server::AppendEntry next(std::string data) {
        last_.sequence++;
        last_.epoch = 1;
        last_.first_tick = last_.last_tick + 1;
        last_.last_tick += 10;
        last_.chain = server::next_chain(last_.chain, data);
        last_.data = std::move(data);
        return {world_, last_};
    }

private:
    std::string world_;
    server::JournalEntry last_;
};

}  // namespace jostle::test
