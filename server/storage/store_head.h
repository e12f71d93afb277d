// SPDX-License-Identifier: MIT
//
// The head of a database: the number of its commits and a digest of all its rows. It is stored in
// the database by each commit, and after the commit in a second file (HeadFile). A database that
// ends before its second file has lost acknowledged commits: SQLite ends a write-ahead log at the
// first corrupt frame without an error, and a disk can lose writes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "jostle/base/result.h"
#include "server/storage/journal_chain.h"

namespace jostle::server {

// Combines digests of rows regardless of their order; adding a digest twice removes it.
class DigestTotal {
public:
    DigestTotal() = default;
    explicit DigestTotal(const Digest& value) : value_(value) {}

    // Bytes of another size than a digest count as their own digest.
    void add(std::string_view digest);
    const Digest& value() const { return value_; }

    bool operator==(const DigestTotal&) const = default;

private:
    Digest value_{};
};

struct StoreHead {
    std::string id;             // 16 random bytes, chosen when the database is created
    std::uint64_t commits = 0;  // since it was created
    std::uint64_t written = 0;  // time of the last commit, in seconds since 1970
    DigestTotal total;          // of all rows

    static constexpr std::size_t id_bytes = 16;
    bool operator==(const StoreHead&) const = default;
};

// The second place of the head: a file with two slots that are written alternately, so that a torn
// write leaves the previous head readable. One thread.
class HeadFile {
public:
    // `sync`: a written head survives a power failure. Creates nothing.
    HeadFile(std::string path, bool sync) : path_(std::move(path)), sync_(sync) {}
    ~HeadFile();
    HeadFile(const HeadFile&) = delete;
    HeadFile& operator=(const HeadFile&) = delete;

    struct Content {
        bool exists = false;
        std::optional<StoreHead> head;  // the newest intact slot
        bool has_corrupt_slot = false;
    };
    Result<Content> read() const;
    // Creates the file with mode 0600 if it does not exist. unavailable, resource_exhausted: not
    // written.
    Status write(const StoreHead& head);

    const std::string& path() const { return path_; }

private:
    Status open_for_writing();

    const std::string path_;
    const bool sync_;
    int file_ = -1;
};

// Why the database with head `stored` is not what the head file says was written last; empty: it is
// as new or newer. `is_backup`: a finished backup has no head file of its own yet.
std::string head_conflict(const StoreHead& stored, bool is_backup, const HeadFile::Content& file,
                          const std::string& file_path);

// "2026-11-28 10:11:02 UTC".
std::string utc_text(std::uint64_t seconds_since_1970);

}  // namespace jostle::server
