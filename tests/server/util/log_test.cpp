// SPDX-License-Identifier: MIT
//
// The log as a reader of its pipe sees it.
#include "server/util/log.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <string>

namespace jostle::server {
namespace {

class LogTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_EQ(pipe(ends_), 0); }
    void TearDown() override {
        stop_log();
        close(ends_[0]);
        close(ends_[1]);
    }
    std::string read_all() {
        fcntl(ends_[0], F_SETFL, O_NONBLOCK);
        std::string all;
        char some[4096];
        for (ssize_t n = 0; (n = read(ends_[0], some, sizeof some)) > 0;)
            all.append(some, static_cast<std::size_t>(n));
        return all;
    }
    int ends_[2] = {-1, -1};
};

TEST_F(LogTest, escapes_client_text_to_one_line_per_event) {
    start_log({.descriptor = ends_[1]});
    log_info("client 3 {} joined", "eve\n2026-01-01T00:00:00.000 error all is lost");
    stop_log();
    const std::string all = read_all();
    EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 1);
    EXPECT_NE(all.find("info client 3 eve\\n2026"), std::string::npos) << all;
}

TEST_F(LogTest, json_lines_contain_time_level_and_message) {
    start_log({.json = true, .descriptor = ends_[1]});
    log_warn("a \"quoted\" word\t");
    stop_log();
    const std::string all = read_all();
    EXPECT_NE(all.find(R"("level": "warning", "message": "a \"quoted\" word\\t"})"),
              std::string::npos)
        << all;
    EXPECT_NE(all.find("Z\","), std::string::npos) << "UTC";
}

TEST_F(LogTest, tail_has_the_newest_lines_after_a_number) {
    start_log({.descriptor = ends_[1]});
    for (int i = 1; i <= 600; i++) log_info("line {}", i);
    log_warn("the last");
    stop_log();
    const std::vector<LogLine> all = log_tail(0);
    ASSERT_EQ(all.size(), log_tail_lines);
    EXPECT_EQ(all.back().number, 601u);
    EXPECT_EQ(all.back().level, "warning");
    EXPECT_EQ(all.back().text, "the last");
    EXPECT_EQ(all.front().number, 102u);
    EXPECT_EQ(log_tail(600).size(), 1u);
    EXPECT_TRUE(log_tail(601).empty());
}

TEST_F(LogTest, logging_never_blocks_and_counts_dropped_lines) {
    start_log({.descriptor = ends_[1]});
    const auto began = std::chrono::steady_clock::now();
    for (int i = 0; i < 20'000; i++) log_info("line {} of a pipe that is not read", i);
    const auto took = std::chrono::steady_clock::now() - began;
    EXPECT_LT(took, std::chrono::seconds(1));
    stop_log();
    EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(3))
        << "stop_log() must not wait for the reader";
    EXPECT_GT(log_lines_dropped(), 5'000u);
    EXPECT_NE(read_all().find(" of a pipe that is not read\n"), std::string::npos)
        << "the lines that fit must be written";
}

TEST_F(LogTest, closed_reader_does_not_terminate_the_process) {
    start_log({.descriptor = ends_[1]});
    close(ends_[0]);
    for (int i = 0; i < 10; i++) log_info("line {}", i);
    stop_log();
    EXPECT_EQ(log_lines_dropped(), 10u);
}

}  // namespace
}  // namespace jostle::server
