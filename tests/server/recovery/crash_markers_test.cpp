// SPDX-License-Identifier: MIT
#include "server/recovery/crash_markers.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

// Runs a process that a signal ends during tick 7 of "yard" and between two ticks of "field".
void end_by(const std::string& path, int signal) {
    const pid_t child = fork();
    if (child == 0) {
        auto marks = CrashMarkers::open(path).value();
        CrashMarkers::count_fatal_signals(marks.get());
        marks->of("field").begin(7);
        marks->of("field").end();
        marks->of("yard").begin(7);
        raise(signal);
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal) << "the process must end with the same signal";
}

TEST(CrashMarkers, counts_crashes_in_the_running_tick_but_not_kills) {
    const test::TempFolder folder;
    const std::string path = folder / "worlds.db.marks";
    end_by(path, SIGKILL);
    EXPECT_EQ(CrashMarkers::open(path).value()->of("yard").crashes(), 0u);
    end_by(path, SIGSEGV);
    end_by(path, SIGKILL);
    end_by(path, SIGABRT);
    const auto marks = CrashMarkers::open(path).value();
    EXPECT_EQ(marks->of("yard").crashes(), 2u);
    EXPECT_EQ(marks->of("yard").crashed_tick(), 7u);
    EXPECT_EQ(marks->of("field").crashes(), 0u);
}

TEST(CrashMarkers, crash_in_another_tick_resets_the_count) {
    const test::TempFolder folder;
    const auto marks = CrashMarkers::open(folder / "marks").value();
    const CrashMarker mark = marks->of("yard");
    for (const std::uint32_t tick : {5u, 5u, 6u}) {
        mark.begin(tick);
        marks->on_crash();
    }
    EXPECT_EQ(mark.crashed_tick(), 6u);
    EXPECT_EQ(mark.crashes(), 1u);
    marks->drop("yard");
    EXPECT_EQ(marks->of("yard").crashes(), 0u);
}

TEST(CrashMarkers, replaces_an_invalid_file) {
    const test::TempFolder folder;
    const std::string path = folder.write("marks", "another format");
    EXPECT_EQ(CrashMarkers::open(path).value()->of("yard").crashes(), 0u);
    EXPECT_FALSE(CrashMarkers::open(folder / "no/such/folder").ok());
}

}  // namespace
}  // namespace jostle::server
