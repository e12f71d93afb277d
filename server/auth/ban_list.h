// SPDX-License-Identifier: MIT
//
// The bans of a server: subjects and networks that may neither join nor use the server, with an
// optional expiry and a reason. The authorizer evaluates them. With a file, every change is written
// before it takes effect, and the bans survive a restart; without one they end with the process.
// Any thread; changes wait for the disk.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "jostle/base/result.h"
#include "server/util/network.h"
#include "server/util/wall_time.h"

namespace jostle::server {

// The target of a ban: either a subject or a network.
struct BanTarget {
    std::string subject;
    std::optional<Network> network;

    auto operator<=>(const BanTarget&) const = default;
};

// "subject anna", "network 192.0.2.0/24"
std::string text_of(const BanTarget& target);

struct Ban {
    BanTarget target;
    std::string reason;                  // shown to the banned caller; empty: none
    std::string by;                      // subject of the administrator
    WallTime created{};                  // in whole seconds, as expires
    WallTime expires = WallTime::max();  // max: until it is removed

    bool operator==(const Ban&) const = default;
};

// "anna is banned until 2026-09-21T14:13:20.000Z: griefing"; without the name of the target.
std::string refusal_text(const Ban& ban);

// The content of a file. Errors name the entry and its fault.
std::string write_bans(const std::vector<Ban>& bans);
Result<std::vector<Ban>> read_bans(std::string_view text);

class BanList {
public:
    static constexpr std::size_t bans_max = 10000;
    static constexpr std::size_t reason_bytes_max = 100;

    // Reads the file; a missing one is empty. Empty path: memory only. Errors: the file cannot be
    // read or is damaged. It is not changed then.
    static Result<std::unique_ptr<BanList>> open(std::string path);

    // Adds a ban, or replaces the ban of the same target. Errors: the reason is invalid, the list
    // is full, or the file cannot be written; the list is then unchanged.
    Status add(Ban ban, WallTime now);
    // not_found: there is no such ban.
    Status remove(const BanTarget& target, WallTime now);
    // Without expired bans, subjects first.
    std::vector<Ban> list(WallTime now) const;

    // The ban of a caller; nothing: it is not banned. `subject`: empty for anonymous callers.
    std::optional<Ban> find(std::string_view subject, std::string_view address, WallTime now) const;

    bool is_persisted() const { return !path_.empty(); }
    // Increases with every change.
    std::uint64_t revision() const { return revision_.load(std::memory_order_acquire); }

private:
    using Bans = std::map<BanTarget, Ban>;

    explicit BanList(std::string path) : path_(std::move(path)) {}

    Status replace(Bans bans);

    const std::string path_;
    std::mutex changing_;       // held while the file is written; locked before mutex_
    mutable std::mutex mutex_;  // guards the members below
    Bans bans_;                 // replaced as a whole
    std::map<std::pair<bool, int>, int> prefixes_;  // number of bans by family and prefix
    std::atomic<std::uint64_t> revision_{0};
    std::atomic<bool> is_empty_{true};
};

}  // namespace jostle::server
