// SPDX-License-Identifier: MIT
#include "server/auth/audit_log.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <nlohmann/json.hpp>

#include "jostle/base/check.h"
#include "server/util/log.h"
#include "server/util/text.h"

namespace jostle::server {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t text_bytes_max = 256;
constexpr std::size_t queue_max = 4096;  // lines
// a pipe that polls writable accepts this much without blocking
constexpr std::size_t chunk_bytes = 4096;
constexpr auto retry_interval = 100ms;  // after a failed write
constexpr auto summary_interval = 1s;

// Non-ASCII characters are escaped, so that a line cannot mislead a terminal or a reader.
std::string to_line(const nlohmann::ordered_json& json) {
    return json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
}

// Returns a negative value and sets errno on failure. Does not wait for a pipe without a reader.
int open_for_appending(const std::string& path) {
    if (path.empty()) return ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0);
    return ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC | O_NONBLOCK | O_NOCTTY,
                  0600);
}

}  // namespace

std::string audit_line(const AuditEntry& e) {
    nlohmann::ordered_json json = {{"time", rfc3339(e.time)}};
    for (const auto& [name, text] :
         {std::pair("what", e.what), std::pair("outcome", e.outcome),
          std::pair("subject", e.subject), std::pair("role", e.role),
          std::pair("token_id", e.token_id), std::pair("address", e.address),
          std::pair("call", e.call), std::pair("world", e.world), std::pair("reason", e.reason)})
        json[name] = std::string(clip_utf8(text, text_bytes_max));
    if (!e.target.empty()) json["target"] = std::string(clip_utf8(e.target, text_bytes_max));
    return to_line(json);
}

Result<std::unique_ptr<AuditLog>> AuditLog::open(std::string path) {
    const int file = open_for_appending(path);
    if (file < 0)
        return Error{ErrorCode::failed_precondition,
                     "cannot write the audit log " + path + ": " + std::strerror(errno) +
                         "; set auth.audit_log to a file in a folder that is writable"};
    std::unique_ptr<AuditLog> log(new AuditLog(std::move(path), file));
    log->thread_ = std::thread([raw = log.get()] { raw->run(); });
    return log;
}

AuditLog::~AuditLog() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
        give_up_ = Clock::now() + 1s;
    }
    work_.notify_all();
    ASSERT(thread_.joinable());
    thread_.join();
    ::close(file_);
}

void AuditLog::record(const AuditEntry& entry) {
    std::string line = audit_line(entry);
    {
        const std::lock_guard lock(mutex_);
        if (queue_.size() >= queue_max) {
            unwritten_.dropped++;
            dropped_++;
            return;
        }
        queue_.push_back(std::move(line));
        ASSERT(queue_.size() <= queue_max);
    }
    work_.notify_one();
}

void AuditLog::mute() {
    {
        const std::lock_guard lock(mutex_);
        unwritten_.muted++;
    }
    work_.notify_one();
}

void AuditLog::reopen() {
    {
        const std::lock_guard lock(mutex_);
        reopen_ = true;
    }
    work_.notify_one();
}

bool AuditLog::flush(Clock::duration timeout) {
    std::unique_lock lock(mutex_);
    return idle_.wait_for(lock, timeout, [&] { return queue_.empty() && !writing_ && !reopen_; });
}

std::uint64_t AuditLog::dropped() const {
    const std::lock_guard lock(mutex_);
    return dropped_;
}

// The writing thread. It blocks all signals: a SIGPIPE must not end the process.
void AuditLog::run() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    std::vector<std::string> lines;
    while (wait_for_work(lines)) {
        switch_file();
        for (const std::string& line : lines) write_line(line);
        write_unwritten();
    }
}

// Returns false if everything is written or the time to do so is over; the log then ends.
bool AuditLog::wait_for_work(std::vector<std::string>& lines) {
    lines.clear();
    std::unique_lock lock(mutex_);
    writing_ = false;
    idle_.notify_all();
    const auto is_work = [&] { return stop_ || reopen_ || !queue_.empty(); };
    if (unwritten_.any()) {
        work_.wait_until(lock, next_summary_, is_work);
    } else {
        work_.wait(lock, [&] { return is_work() || unwritten_.any(); });
    }
    lines.swap(queue_);
    ASSERT(queue_.empty() && lines.size() <= queue_max);
    writing_ = true;
    return !stop_ || ((!lines.empty() || unwritten_.any()) && Clock::now() < give_up_);
}

void AuditLog::write_line(const std::string& line) {
    for (std::size_t offset = 0; offset < line.size();) {
        if (write_some(line, offset)) continue;
        if (!wait_for_retry()) return;
        const int previous_file = file_;
        switch_file();
        if (file_ != previous_file) offset = 0;  // no partial lines in the new file
    }
    if (failing_) log_info("the audit log can be written again");
    failing_ = false;
}

// Returns false if nothing could be written.
bool AuditLog::write_some(const std::string& line, std::size_t& offset) {
    pollfd ready{.fd = file_, .events = POLLOUT, .revents = 0};
    if (::poll(&ready, 1, 0) <= 0) return false;
    ASSERT(offset < line.size());
    const std::size_t size = std::min(chunk_bytes, line.size() - offset);
    const ssize_t written = ::write(file_, line.data() + offset, size);
    if (written > 0) offset += static_cast<std::size_t>(written);
    ASSERT(offset <= line.size());
    if (written < 0 && errno != EAGAIN && errno != EINTR) log_failure_once(errno);
    return written > 0;
}

// At most once per second, so that a client that causes dropped lines cannot fill the log with
// summaries.
void AuditLog::write_unwritten() {
    Unwritten now;
    {
        const std::lock_guard lock(mutex_);
        if (!unwritten_.any() || (Clock::now() < next_summary_ && !stop_)) return;
        std::swap(now, unwritten_);
    }
    next_summary_ = Clock::now() + summary_interval;
    write_line(to_line({{"time", rfc3339(std::chrono::system_clock::now())},
                        {"what", "unwritten"},
                        {"dropped", now.dropped},
                        {"muted", now.muted}}));
}

void AuditLog::switch_file() {
    {
        const std::lock_guard lock(mutex_);
        if (!std::exchange(reopen_, false)) return;
    }
    const int fresh = open_for_appending(path_);
    if (fresh < 0) {
        log_error("cannot reopen the audit log {}: {}; writing continues to the old file", path_,
                  std::strerror(errno));
        return;
    }
    ASSERT(file_ >= 0);
    ::close(std::exchange(file_, fresh));
}

// Returns false if the log ends.
bool AuditLog::wait_for_retry() {
    std::unique_lock lock(mutex_);
    if (!stop_) {
        work_.wait_for(lock, retry_interval, [&] { return stop_ || reopen_; });
        return true;
    }
    if (Clock::now() >= give_up_) return false;
    lock.unlock();
    std::this_thread::sleep_for(retry_interval / 10);
    return true;
}

void AuditLog::log_failure_once(int error) {
    if (!std::exchange(failing_, true))
        log_error("cannot write the audit log: {}; entries are queued", std::strerror(error));
}

}  // namespace jostle::server
