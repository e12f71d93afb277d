// SPDX-License-Identifier: MIT
#include "server/util/work_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>

namespace jostle::server {
namespace {

TEST(WorkPool, rejects_work_when_the_queue_is_full) {
    WorkPool pool(1, 3, 0);
    std::promise<void> began, go_on;
    std::atomic<int> done{0};
    ASSERT_TRUE(pool.add([&] {
        began.set_value();
        go_on.get_future().wait();
    }));
    began.get_future().wait();
    for (int i = 0; i < 3; i++) EXPECT_TRUE(pool.add([&] { done++; }));
    EXPECT_FALSE(pool.add([&] { done++; })) << "three jobs wait and one runs";
    go_on.set_value();
    pool.stop();
    EXPECT_EQ(done, 3) << "accepted jobs must finish before the threads end";
    EXPECT_FALSE(pool.add([] {}));
}

TEST(WorkPool, exception_does_not_affect_other_tasks) {
    WorkPool pool(1, 10, 0);
    std::atomic<int> done{0};
    ASSERT_TRUE(pool.add([] { throw std::runtime_error("no memory"); }));
    ASSERT_TRUE(pool.add([&] { done++; }));
    pool.stop();
    EXPECT_EQ(done, 1);
}

}  // namespace
}  // namespace jostle::server
