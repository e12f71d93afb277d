// SPDX-License-Identifier: MIT
//
// The keys that tokens are believed by: a JWKS file (RFC 7517) that the login service's operator
// puts there and replaces while the server runs. A broken new file leaves the old keys in force.
// keys() from any thread; poll() and reload() from whoever keeps time.
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
    std::vector<std::string> warnings;  // of keys that were left out, and why
};

// EC keys on P-256 that have a kid. Keys of other kinds are left out with a warning; a text without
// any key that can be used, or with one kid twice, is an error.
Result<ParsedKeySet> read_key_set(std::string_view text);

class KeySet {
public:
    // The file must be good the first time.
    static Result<std::unique_ptr<KeySet>> open(std::string path);

    std::shared_ptr<const VerifyKeys> keys() const;

    // Looks at most once a second whether the file has changed, and reads it if so. False: it is
    // broken, which was logged; said once for each change.
    bool poll(Clock::time_point now);
    // Reads it now (SIGHUP). False: it is broken, which was logged.
    bool reload();

private:
    explicit KeySet(std::string path) : path_(std::move(path)) {}

    Status read();

    const std::string path_;
    mutable std::mutex mutex_;  // of keys_
    std::shared_ptr<const VerifyKeys> keys_;
    std::mutex reading_;  // of what follows
    FileStamp stamp_;     // of the file when it was last read, good or not
    Clock::time_point next_poll_ = Clock::time_point::min();
};

}  // namespace jostle::server
