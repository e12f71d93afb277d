// SPDX-License-Identifier: MIT
//
// What outlives the process: worlds, the journal of what was done to each, and checkpoints. The
// texts and bytes are opaque here; host/ knows what they mean.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>

namespace jostle::server {

// Of a journal so far: the hash of the chain before and of the entry's data (journal_chain.h).
using Chain = std::array<std::uint8_t, 32>;

struct StoredWorld {
    std::string id, name;
    std::uint64_t epoch = 0;  // rises whenever a process takes the world up
    std::string engine;       // by whose arithmetic and version its checkpoints are exact
    std::string settings;     // what it is built of: scene, limits

    bool operator==(const StoredWorld&) const = default;
};

// What was done to a world in some ticks.
struct JournalEntry {
    std::uint64_t sequence = 0;  // from 1, each one more than the last
    std::uint64_t epoch = 0;     // of the process that wrote it
    std::uint32_t first_tick = 0, last_tick = 0;
    Chain chain{};
    std::string data;

    bool operator==(const JournalEntry&) const = default;
};

// A world after a tick.
struct Checkpoint {
    std::uint32_t tick = 0;
    std::uint64_t hash = 0;      // of its state
    std::uint64_t sequence = 0;  // the last journal entry that is in it; 0: none
    std::string exact;           // for the same engine
    std::string portable;        // for any

    bool operator==(const Checkpoint&) const = default;
};

// ---- changes ----

struct PutWorld {  // a new one, or the same with another epoch
    StoredWorld world;
};
struct DropWorld {  // with its journal and its checkpoints
    std::string id;
};
struct AppendEntry {
    std::string world;
    JournalEntry entry;
};
struct PutCheckpoint {
    std::string world;
    Checkpoint checkpoint;
};
// What nobody needs any more: checkpoints before the one of that tick, and entries before the last
// one that is in it.
struct Trim {
    std::string world;
    std::uint32_t tick = 0;
};
// The world is of another past: entries after that sequence, and checkpoints after that tick, are
// not its own.
struct TruncateJournal {
    std::string world;
    std::uint32_t tick = 0;
    std::uint64_t sequence = 0;
};
// Something of the server as a whole, under a name.
struct PutNote {
    std::string name, value;
};
using StorageChange =
    std::variant<PutWorld, DropWorld, AppendEntry, PutCheckpoint, Trim, TruncateJournal, PutNote>;

// About how much memory it takes.
std::size_t bytes_of(const StorageChange& change);

}  // namespace jostle::server
