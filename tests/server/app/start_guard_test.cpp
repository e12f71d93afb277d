// SPDX-License-Identifier: MIT
#include "server/app/start_guard.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <new>
#include <system_error>
#include <thread>

namespace jostle::server {
namespace {

template <class Error>
void fail_on_another_thread(Error error) {
    std::thread([error] { throw error; }).join();
}

const std::system_error no_thread{std::make_error_code(std::errc::resource_unavailable_try_again)};

TEST(StartGuardDeathTest, failed_allocation_or_thread_exits_with_1_and_a_message) {
    const auto starting = [](auto error) {
        begin_start_guard();
        fail_on_another_thread(error);
    };
    EXPECT_EXIT(starting(std::bad_alloc()), testing::ExitedWithCode(1),
                "jostle-server: cannot start: out of memory: ");
    EXPECT_EXIT(starting(no_thread), testing::ExitedWithCode(1),
                "jostle-server: cannot start: cannot create a thread: ");
}

TEST(StartGuardDeathTest, message_names_the_memory_limit) {
    const auto limited = [] {
        rlimit limit{};
        ::getrlimit(RLIMIT_AS, &limit);
        limit.rlim_cur = rlim_t{1} << 46;  // 64 TiB
        ::setrlimit(RLIMIT_AS, &limit);
        begin_start_guard();
        fail_on_another_thread(std::bad_alloc());
    };
    EXPECT_EXIT(limited(), testing::ExitedWithCode(1),
                "out of memory: the address space is limited to 68719476736 kB .RLIMIT_AS, ulimit "
                "-v.; raise or remove the limit");
}

TEST(StartGuardDeathTest, other_failures_and_a_running_server_abort_as_usual) {
    const auto other = [] {
        begin_start_guard();
        fail_on_another_thread(std::runtime_error("a defect"));
    };
    EXPECT_EXIT(other(), testing::KilledBySignal(SIGABRT), "a defect");
    const auto running = [] {
        begin_start_guard();
        end_start_guard();
        fail_on_another_thread(std::bad_alloc());
    };
    EXPECT_EXIT(running(), testing::KilledBySignal(SIGABRT), "bad_alloc");
}

}  // namespace
}  // namespace jostle::server
