// SPDX-License-Identifier: MIT
//
// The keys that verify tokens: a JWKS file (RFC 7517), which the operator of the login service
// replaces while the server runs. If a new file is invalid, the previous keys stay in force. keys()
// may be called from any thread; poll() and reload() from the maintenance thread.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "server/auth/json_web_token.h"
#include "server/util/clock.h"
#include "server/util/watched_file.h"

namespace jostle::server {

struct ParsedKeySet {
    VerifyKeys keys;
    std::vector<std::string> warnings;  // why keys were skipped
};

// Reads EC keys on P-256 that have a kid. Keys of other types are skipped with a warning; a set
// without any usable key, or with a duplicate kid, is an error.
Result<ParsedKeySet> read_key_set(std::string_view text);

class KeySet {
public:
    // The file must be valid at the first load.
    static Result<std::unique_ptr<KeySet>> open(std::string path);

    std::shared_ptr<const VerifyKeys> keys() const;

    // Checks for a change at most once per second, and reloads the file if it has changed. Returns
    // false if the new file is invalid; each change is logged once.
    bool poll(Clock::time_point now);
    // Reloads now (SIGHUP). Returns false if the file is invalid, which is logged.
    bool reload();

private:
    explicit KeySet(std::string path) : path_(std::move(path)) {}

    Status read();

    const std::string path_;
    mutable std::mutex mutex_;  // guards keys_
    std::shared_ptr<const VerifyKeys> keys_;
    std::mutex reading_;  // guards the members below
    FileStamp stamp_;     // of the file at the last read, valid or not
    Clock::time_point next_poll_ = Clock::time_point::min();
};

}  // namespace jostle::server
