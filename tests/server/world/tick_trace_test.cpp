// SPDX-License-Identifier: MIT
#include "server/world/tick_trace.h"

#include <gtest/gtest.h>

namespace jostle::server {

using namespace std::chrono_literals;

TEST(TickTrace, stages_are_adjacent_within_their_tick) {
    const Clock::time_point zero{1000s};
    TickProfile tick{.tick = 42,
                     .due = zero - 50us,
                     .begun = zero,
                     .ended = zero + 900us,
                     .step_begun = zero + 100us,
                     .bodies_awake = 7,
                     .late_ticks = 3};
    const auto ms_of = [&](physics::Stage stage) -> double& {
        return tick.stage_ms[static_cast<std::size_t>(stage)];
    };
    ms_of(physics::Stage::update_pairs) = 0.2;
    ms_of(physics::Stage::solve_constraints) = 0.5;
    const std::string trace = tick_trace("arena", std::vector{tick});
    for (
        const char* line :
        {R"("args":{"name":"world arena"})",
         R"("name":"tick","ts":0,"dur":900,"args":{"tick":42,"late_us":50,"inputs":0,"bodies_awake":7,)",
         R"("touching":0,"late_ticks":3})", R"("name":"inputs","ts":0,"dur":100})",
         R"("name":"update_pairs","ts":100,"dur":200})",
         R"("name":"solve_constraints","ts":300,"dur":500})",
         R"("name":"frame_and_results","ts":800,"dur":100})"})
        EXPECT_NE(trace.find(line), std::string::npos) << line << "\n" << trace;
    EXPECT_EQ(trace.find("wake_bodies"), std::string::npos)
        << "a stage that did not run is not there";
}

TEST(TickTrace, stopped_world_has_an_empty_trace) {
    EXPECT_NE(tick_trace("arena", {}).find("\"traceEvents\":["), std::string::npos);
}

}  // namespace jostle::server
