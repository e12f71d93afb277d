// SPDX-License-Identifier: MIT
#include "server/auth/audit_log.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;

const WallTime time_of_entry = WallTime(1'790'000'000s + 7ms);

AuditEntry entry(std::string_view subject = "anna") {
    return {.time = time_of_entry,
            .what = "create",
            .outcome = "granted",
            .subject = subject,
            .role = "director",
            .token_id = "t-1",
            .address = "192.0.2.7",
            .call = "jostle.v1.WorldService/CreateWorld",
            .world = "w3"};
}

std::vector<json> lines_of(const std::string& text) {
    std::vector<json> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(json::parse(line));
    return lines;
}

TEST(AuditLine, is_one_json_object_with_millisecond_timestamp) {
    const std::string line = audit_line(entry());
    EXPECT_EQ(line, R"({"time":"2026-09-21T14:13:20.007Z","what":"create","outcome":"granted",)"
                    R"("subject":"anna","role":"director","token_id":"t-1","address":"192.0.2.7",)"
                    R"("call":"jostle.v1.WorldService/CreateWorld","world":"w3","reason":""})"
                    "\n");
}

TEST(AuditLine, escapes_newlines_and_terminal_control_sequences) {
    const std::string subject = "anna\"}\n{\"what\":\"admin\"\x1b[2J\u202e\xff\xfe";
    const std::string line = audit_line(entry(subject));
    EXPECT_EQ(std::ranges::count(line, '\n'), 1);
    for (const char c : line) EXPECT_TRUE((c >= ' ' && c < 0x7f) || c == '\n');
    EXPECT_EQ(json::parse(line)["subject"],
              "anna\"}\n{\"what\":\"admin\"\x1b[2J\u202e\ufffd\ufffd");
}

TEST(AuditLine, truncates_text_to_256_bytes_at_character_boundary) {
    EXPECT_EQ(json::parse(audit_line(entry(std::string(300, 'a'))))["subject"],
              std::string(256, 'a'));
    std::string euros = "a";
    for (int i = 0; i < 100; ++i) euros += "\u20ac";  // three bytes each
    EXPECT_EQ(json::parse(audit_line(entry(euros)))["subject"], euros.substr(0, 256));
    EXPECT_EQ(json::parse(audit_line(entry("a" + euros)))["subject"], "a" + euros.substr(0, 253));
    const std::string rubble(1000, '\x80');
    EXPECT_LT(audit_line(entry(rubble)).size(), 4096u);
}

TEST(AuditLog, creates_owner_only_file_and_appends_after_reopen) {
    const test::TempFolder folder;
    for (const char* subject : {"anna", "berta"}) {
        const auto log = AuditLog::open(folder / "audit").value();
        log->record(entry(subject));
        EXPECT_TRUE(log->flush(20s));
    }
    const std::vector<json> lines = lines_of(folder.read("audit"));
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[1]["subject"], "berta");
    struct stat s {};
    ASSERT_EQ(stat((folder / "audit").c_str(), &s), 0);
    EXPECT_EQ(s.st_mode & 0777u, 0600u);
}

TEST(AuditLog, flushes_recorded_lines_on_destruction) {
    const test::TempFolder folder;
    {
        const auto log = AuditLog::open(folder / "audit").value();
        for (int i = 0; i < 1000; ++i) log->record(entry());
    }
    EXPECT_EQ(lines_of(folder.read("audit")).size(), 1000u);
}

TEST(AuditLog, does_not_write_to_renamed_file_after_reopen) {
    const test::TempFolder folder;
    const auto log = AuditLog::open(folder / "audit").value();
    log->record(entry("first"));
    ASSERT_TRUE(log->flush(20s));
    std::filesystem::rename(folder / "audit", folder / "audit.1");
    log->record(entry("second"));
    ASSERT_TRUE(log->flush(20s));
    log->reopen();
    log->record(entry("third"));
    ASSERT_TRUE(log->flush(20s));
    EXPECT_EQ(lines_of(folder.read("audit.1")).size(), 2u);
    ASSERT_EQ(lines_of(folder.read("audit")).size(), 1u);
    EXPECT_EQ(lines_of(folder.read("audit"))[0]["subject"], "third");
}

TEST(AuditLog, error_names_file_that_cannot_be_opened) {
    const auto log = AuditLog::open("/no/such/folder/audit");
    ASSERT_FALSE(log.ok());
    EXPECT_NE(log.error().message.find("/no/such/folder/audit"), std::string::npos);
    const test::TempFolder folder;
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_FALSE(AuditLog::open(folder / "pipe").ok()) << "open() must not wait for a reader";
}

// An unread pipe holds 64 KiB. Further lines wait, then they are dropped and counted; callers do
// not block. When a reader reads, the waiting lines arrive complete, followed by the count.
TEST(AuditLog, blocked_pipe_does_not_block_callers_and_counts_dropped_lines) {
    const test::TempFolder folder;
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    const int reader = open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    const auto log = AuditLog::open(folder / "pipe").value();
    constexpr int count = 20000;
    Clock::duration slowest{};
    for (int i = 0; i < count; ++i) {
        const auto previous = Clock::now();
        log->record(entry(std::to_string(i)));
        slowest = std::max(slowest, Clock::now() - previous);
    }
    EXPECT_LT(slowest, 5s);
    EXPECT_FALSE(log->flush(50ms));
    EXPECT_GT(log->dropped(), 10000u);
    std::string text;
    std::vector<char> piece(65536);
    std::uint64_t dropped = 0, written = 0;
    int expected = 0;
    for (const auto end = Clock::now() + 20s; Clock::now() < end && written + dropped < count;) {
        const ssize_t got = read(reader, piece.data(), piece.size());
        if (got <= 0) std::this_thread::sleep_for(5ms);
        if (got > 0) text.append(piece.data(), static_cast<std::size_t>(got));
        const std::size_t whole = text.rfind('\n') + 1;  // 0: no complete line
        for (const json& line : lines_of(text.substr(0, whole))) {
            if (line["what"] == "unwritten") {
                dropped += line["dropped"].get<std::uint64_t>();
            } else {
                const int number = std::stoi(line["subject"].get<std::string>());
                EXPECT_GE(number, expected) << "lines are out of order";
                expected = number + 1;
                ++written;
            }
        }
        text.erase(0, whole);
    }
    close(reader);
    EXPECT_EQ(dropped, log->dropped());
    EXPECT_EQ(written + dropped, static_cast<std::uint64_t>(count))
        << "a line was lost without being counted";
}

TEST(AuditLog, blocked_pipe_does_not_delay_destruction) {
    const test::TempFolder folder;
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    const int reader = open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
    auto log = AuditLog::open(folder / "pipe").value();
    for (int i = 0; i < 5000; ++i) log->record(entry());
    const auto previous = Clock::now();
    log.reset();
    EXPECT_LT(Clock::now() - previous, 5s);
    close(reader);
}

// A file size limit has the same effect as a full disk.
TEST(AuditLog, writes_complete_lines_after_disk_was_full) {
    const test::TempFolder folder;
    signal(SIGXFSZ, SIG_IGN);
    rlimit previous{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &previous), 0);
    const auto log = AuditLog::open(folder / "audit").value();
    const std::size_t line = audit_line(entry()).size();
    const rlimit tight{.rlim_cur = 10 * line + line / 2, .rlim_max = previous.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &tight), 0);
    for (int i = 0; i < 100; ++i) log->record(entry());
    for (const auto end = Clock::now() + 20s;
         Clock::now() < end && folder.read("audit").size() < tight.rlim_cur;)
        std::this_thread::sleep_for(5ms);
    EXPECT_EQ(folder.read("audit").size(), tight.rlim_cur) << "10.5 lines fit";
    EXPECT_FALSE(log->flush(50ms));
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &previous), 0);
    EXPECT_TRUE(log->flush(20s));
    EXPECT_EQ(lines_of(folder.read("audit")).size(), 100u);
}

TEST(AuditLog, counts_muted_lines) {
    const test::TempFolder folder;
    {
        const auto log = AuditLog::open(folder / "audit").value();
        for (int i = 0; i < 500; ++i) log->mute();
    }
    std::uint64_t muted = 0;
    for (const json& line : lines_of(folder.read("audit"))) {
        EXPECT_EQ(line["what"], "unwritten");
        muted += line["muted"].get<std::uint64_t>();
    }
    EXPECT_EQ(muted, 500u);
}

TEST(AuditLog, supports_concurrent_recording) {
    const test::TempFolder folder;
    {
        const auto log = AuditLog::open(folder / "audit").value();
        std::vector<std::jthread> threads;
        for (int t = 0; t < 4; ++t)
            threads.emplace_back([&] {
                for (int i = 0; i < 500; ++i) log->record(entry());
            });
    }
    EXPECT_EQ(lines_of(folder.read("audit")).size(), 2000u);
}

}  // namespace
}  // namespace jostle::server
