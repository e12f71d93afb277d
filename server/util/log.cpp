// SPDX-License-Identifier: MIT
#include "server/util/log.h"

#include <poll.h>
#include <spdlog/async.h>
#include <spdlog/sinks/base_sink.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <deque>
#include <memory>
#include <mutex>

#include "jostle/base/check.h"
#include "server/util/text.h"

namespace jostle::server {

namespace {

constexpr std::size_t queue_lines = 8192;
// Maximum bytes per line. A pipe that is writable has room for PIPE_BUF (4096) bytes, so a write
// after poll() never blocks.
constexpr std::size_t message_bytes_max = 2000;
constexpr std::size_t json_message_bytes_max = 1500;
constexpr int reader_timeout_ms = 250;

std::string time_of(const spdlog::log_clock::time_point at, bool utc) {
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(at.time_since_epoch());
    const std::time_t seconds = static_cast<std::time_t>(ms.count() / 1000);
    std::tm parts{};
    utc ? gmtime_r(&seconds, &parts) : localtime_r(&seconds, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &parts);
    return fmt::format("{}.{:03}{}", text, ms.count() % 1000, utc ? "Z" : "");
}

// A printable message contains no other characters that JSON escapes.
std::string json_string(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

// Used by the writing thread only; close_soon(), dropped() and tail() by any thread.
class LineWriter final : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
public:
    LineWriter(int descriptor, bool json) : descriptor_(descriptor), json_(json) {}

    void close_soon() { closing_ = true; }
    std::uint64_t dropped() const { return dropped_; }
    // Any thread.
    std::vector<LogLine> tail(std::uint64_t after) const {
        const std::lock_guard lock(tail_mutex_);
        std::vector<LogLine> lines;
        for (const LogLine& line : tail_)
            if (line.number > after) lines.push_back(line);
        return lines;
    }

protected:
    void sink_it_(const spdlog::details::log_msg& message) override {
        const std::string_view level(spdlog::level::to_string_view(message.level).data(),
                                     spdlog::level::to_string_view(message.level).size());
        const std::string_view text(message.payload.data(), message.payload.size());
        remember(message.time, level, text);
        report_drops(message.time);
        if (!write(line(message.time, level, text))) dropped_++;
    }
    void flush_() override {}

private:
    void remember(spdlog::log_clock::time_point at, std::string_view level,
                  std::string_view message) {
        LogLine line{.number = ++lines_,
                     .time = time_of(at, true),
                     .level = std::string(level),
                     .text = printable(message, json_message_bytes_max)};
        const std::lock_guard lock(tail_mutex_);
        tail_.push_back(std::move(line));
        if (tail_.size() > log_tail_lines) tail_.pop_front();
    }
    std::string line(spdlog::log_clock::time_point at, std::string_view level,
                     std::string_view message) const {
        if (!json_)
            return fmt::format("{} {} {}\n", time_of(at, false), level,
                               printable(message, message_bytes_max));
        return fmt::format("{{\"time\": \"{}\", \"level\": \"{}\", \"message\": {}}}\n",
                           time_of(at, true), level,
                           json_string(printable(message, json_message_bytes_max)));
    }
    void report_drops(spdlog::log_clock::time_point at) {
        const std::uint64_t now = dropped_;
        ASSERT(now >= reported_drops_);
        if (now == reported_drops_) return;
        if (write(line(at, "warning",
                       fmt::format("dropped {} lines of this log", now - reported_drops_))))
            reported_drops_ = now;
    }
    bool write(const std::string& text) const {
        std::size_t done = 0;
        while (done < text.size()) {
            pollfd ready{descriptor_, POLLOUT, 0};
            if (::poll(&ready, 1, closing_ ? 0 : reader_timeout_ms) <= 0) return false;
            const ssize_t wrote = ::write(descriptor_, text.data() + done, text.size() - done);
            if (wrote < 0 && errno == EINTR) continue;
            if (wrote <= 0) return false;
            done += static_cast<std::size_t>(wrote);
            ASSERT(done <= text.size());
        }
        return true;
    }

    const int descriptor_;
    const bool json_;
    std::atomic<bool> closing_{false};
    std::atomic<std::uint64_t> dropped_{0};
    std::uint64_t reported_drops_ = 0;
    std::uint64_t lines_ = 0;
    mutable std::mutex tail_mutex_;
    std::deque<LogLine> tail_;
};

std::shared_ptr<LineWriter> writer;
std::uint64_t overruns_at_stop = 0;  // of the queue, when the log was stopped

}  // namespace

void start_log(const LogSettings& settings) {
    std::signal(SIGPIPE, SIG_IGN);
    spdlog::init_thread_pool(queue_lines, 1);
    writer = std::make_shared<LineWriter>(settings.descriptor, settings.json);
    overruns_at_stop = 0;
    const auto logger = std::make_shared<spdlog::async_logger>(
        "jostle", writer, spdlog::thread_pool(), spdlog::async_overflow_policy::overrun_oldest);
    logger->set_level(spdlog::level::from_str(settings.level));
    spdlog::set_default_logger(logger);
}

void stop_log() {
    const auto pool = spdlog::thread_pool();
    if (!pool) return;
    ASSERT(writer);
    writer->close_soon();
    overruns_at_stop = pool->overrun_counter();
    // Threads that still log do so without a queue; the last holder of the pool drains it.
    spdlog::drop("jostle");
    spdlog::set_default_logger(std::make_shared<spdlog::logger>(
        "late", std::make_shared<LineWriter>(STDOUT_FILENO, false)));
    spdlog::details::registry::instance().set_tp(nullptr);
}

std::vector<LogLine> log_tail(std::uint64_t after) {
    return writer ? writer->tail(after) : std::vector<LogLine>();
}

std::uint64_t log_lines_dropped() {
    const auto pool = spdlog::thread_pool();
    return (writer ? writer->dropped() : 0) + (pool ? pool->overrun_counter() : overruns_at_stop);
}

}  // namespace jostle::server
