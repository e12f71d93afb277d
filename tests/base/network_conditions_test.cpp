// SPDX-License-Identifier: MIT
#include "jostle/base/network_conditions.h"

#include <gtest/gtest.h>

namespace jostle {

TEST(NetworkConditions, parses_a_list_of_parameters) {
    const auto conditions =
        parse_network_conditions("latency_ms=80,jitter_ms=20.5,stall_ms=250,loss=0.02,seed=9");
    ASSERT_TRUE(conditions.ok());
    EXPECT_EQ(conditions->latency_ms, 80);
    EXPECT_EQ(conditions->jitter_ms, 20.5);
    EXPECT_EQ(conditions->stall_ms, 250);
    EXPECT_EQ(conditions->stall_interval_ms, 5000) << "the default";
    EXPECT_EQ(conditions->loss, 0.02);
    EXPECT_EQ(conditions->seed, 9u);
    EXPECT_TRUE(conditions->impaired());
    EXPECT_FALSE(parse_network_conditions("")->impaired());
    EXPECT_FALSE(parse_network_conditions("stall_interval_ms=1,seed=3")->impaired());
}

TEST(NetworkConditions, rejects_unknown_names_and_values_out_of_range) {
    for (const char* wrong : {"latency_ms", "latency_ms=", "latency_ms=-1", "latency_ms=nan",
                              "latency_ms=99999", "latency_ms=inf", "loss=2", "loss_burst=0",
                              "speed=3", "latency_ms=5ms", "seed=5000000000", "seed=1.5"}) {
        const auto read = parse_network_conditions(std::string("jitter_ms=1,") + wrong);
        ASSERT_FALSE(read.ok()) << wrong;
        EXPECT_EQ(read.error().code, ErrorCode::invalid_argument);
        EXPECT_NE(read.error().message.find("'" + std::string(wrong) + "'"), std::string::npos);
    }
    EXPECT_EQ(parse_network_conditions("loss_burst=0").error().message,
              "network condition 'loss_burst=0': must be a number from 1 to 1000");
}

}  // namespace jostle
