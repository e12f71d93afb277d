// SPDX-License-Identifier: MIT
//
// Persisted data: worlds, a journal for each world, and checkpoints. Strings and bytes are opaque
// in this layer; recovery/ defines their content.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>

namespace jostle::server {

// Hash of a journal up to an entry: of the previous chain value and the entry's data
// (journal_chain.h).
using Chain = std::array<std::uint8_t, 32>;

struct StoredWorld {
    std::string id, name;
    std::uint64_t epoch = 0;  // increases each time a process resumes the world
    std::string engine;       // arithmetic and version for which its checkpoints are exact
    std::string settings;     // encoded WorldDefinition: scene, limits

    bool operator==(const StoredWorld&) const = default;
};

// The commands of a range of ticks.
struct JournalEntry {
    std::uint64_t sequence = 0;  // consecutive, from 1
    std::uint64_t epoch = 0;     // of the writing process
    std::uint32_t first_tick = 0, last_tick = 0;
    Chain chain{};
    std::string data;

    bool operator==(const JournalEntry&) const = default;
};

// The state of a world after a tick.
struct Checkpoint {
    std::uint32_t tick = 0;
    std::uint64_t hash = 0;      // of the state
    std::uint64_t sequence = 0;  // last journal entry contained in it; 0: none
    std::string exact;           // readable by the same engine only
    std::string portable;        // readable by any engine

    bool operator==(const Checkpoint&) const = default;
};

// ---- changes ----

struct PutWorld {  // inserts a world, or updates it with another epoch
    StoredWorld world;
};
struct DropWorld {  // with its journal and checkpoints
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
// Deletes data that is no longer needed: checkpoints before the one of `tick`, and entries before
// the last entry contained in it.
struct Trim {
    std::string world;
    std::uint32_t tick = 0;
};
// The world resumes from an earlier point: deletes entries after `sequence` and checkpoints after
// `tick`.
struct TruncateJournal {
    std::string world;
    std::uint32_t tick = 0;
    std::uint64_t sequence = 0;
};
// A named value of the server as a whole.
struct PutNote {
    std::string name, value;
};
using StorageChange =
    std::variant<PutWorld, DropWorld, AppendEntry, PutCheckpoint, Trim, TruncateJournal, PutNote>;

// Approximate memory size.
std::size_t bytes_of(const StorageChange& change);

}  // namespace jostle::server
