// SPDX-License-Identifier: MIT
//
// Who was let in, who was refused and why, and who changed what: one JSON object a line. Nothing
// secret comes in: there is no field for a token or a ticket.
//
// record() from any thread, and never waits: a thread of its own writes. When the disk is full or
// nobody reads the pipe, lines wait in a bounded queue; those that find no place are counted, and
// the count is written once writing works again.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "jostle/base/result.h"
#include "server/auth/clock_pair.h"

namespace jostle::server {

// Texts may come from strangers: each is escaped, and cut at 256 bytes.
struct AuditEntry {
    WallTime time;
    std::string_view what;     // "login", "ticket", or a name of CallKind
    std::string_view outcome;  // granted, refused, done, failed
    std::string_view subject, role, token_id;
    std::string_view address, call, world;
    std::string_view reason;  // of a refusal or a failure
};

// One line, with its end.
std::string audit_line(const AuditEntry& entry);

class AuditLog {
public:
    // A file, appended to and made with mode 0600; an empty path is standard error.
    static Result<std::unique_ptr<AuditLog>> open(std::string path);
    // Gives the writing of what waits a second.
    ~AuditLog();

    void record(const AuditEntry& entry);
    // A line was left out on purpose, as those of somebody who is refused all the time.
    void mute();

    // Opens the file anew (SIGHUP, after it was renamed). If that fails, the old one is written on.
    void reopen();
    // False: what was recorded is not written within that time.
    bool flush(Clock::duration timeout);

    std::uint64_t dropped() const;

private:
    struct Unwritten {
        std::uint64_t dropped = 0, muted = 0;

        bool any() const { return dropped + muted > 0; }
    };

    AuditLog(std::string path, int file) : path_(std::move(path)), file_(file) {}

    void run();
    bool wait_for_work(std::vector<std::string>& lines);
    void write_line(const std::string& line);
    bool write_some(const std::string& line, std::size_t& offset);
    void write_unwritten();
    void switch_file();
    bool wait_for_retry();
    void log_failure_once(int error);

    const std::string path_;
    int file_;              // of the writing thread
    bool failing_ = false;  // likewise
    Clock::time_point next_summary_{};

    mutable std::mutex mutex_;  // of all that follows
    std::condition_variable work_, idle_;
    std::vector<std::string> queue_;
    Unwritten unwritten_;
    std::uint64_t dropped_ = 0;
    bool writing_ = false, reopen_ = false, stop_ = false;
    Clock::time_point give_up_ = Clock::time_point::max();

    std::thread thread_;
};

}  // namespace jostle::server
