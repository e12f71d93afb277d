// SPDX-License-Identifier: MIT
//
// The audit log records granted and refused access with the reason, and every change with its
// author: one JSON object per line. It contains no secrets: there is no field for a token or a
// ticket.
//
// record() may be called from any thread and never waits: a separate thread writes. While the disk
// is full or a pipe has no reader, lines wait in a bounded queue. Lines that do not fit are
// counted, and the count is written once writing works again.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "jostle/base/result.h"
#include "server/util/wall_time.h"

namespace jostle::server {

// Text may come from clients: each field is escaped and clipped at 256 bytes.
struct AuditEntry {
    WallTime time;
    std::string_view what;     // "login", "ticket", or a name of CallKind
    std::string_view outcome;  // granted, refused, done, failed
    std::string_view subject, role, token_id;
    std::string_view address, call, world;
    std::string_view reason;  // of a refusal or a failure, or an operator's
    std::string_view target;  // what else a call refers to, such as "client 7"; empty: omitted
};

// One line, including the newline.
std::string audit_line(const AuditEntry& entry);

class AuditLog {
public:
    // Appends to a file, created with mode 0600; an empty path is standard error.
    static Result<std::unique_ptr<AuditLog>> open(std::string path);
    // Waits up to 1 s for queued lines to be written.
    ~AuditLog();

    void record(const AuditEntry& entry);
    // Counts a line that was suppressed on purpose, such as repeated refusals of one address.
    void mute();

    // Reopens the file (SIGHUP, after a rotation). If that fails, writing continues to the old
    // file.
    void reopen();
    // Returns false if the recorded entries are not written within `timeout`.
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
    int file_;              // used by the writing thread
    bool failing_ = false;  // used by the writing thread
    Clock::time_point next_summary_{};

    mutable std::mutex mutex_;  // guards all members below
    std::condition_variable work_, idle_;
    std::vector<std::string> queue_;
    Unwritten unwritten_;
    std::uint64_t dropped_ = 0;
    bool writing_ = false, reopen_ = false, stop_ = false;
    Clock::time_point give_up_ = Clock::time_point::max();

    std::thread thread_;
};

}  // namespace jostle::server
