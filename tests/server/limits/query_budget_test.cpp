// SPDX-License-Identifier: MIT
#include "server/limits/query_budget.h"

#include <gtest/gtest.h>

#include <chrono>

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

constexpr AccountId anna = 1, ben = 2;
const Clock::time_point first_query = Clock::time_point(1h);

TEST(QueryBudget, an_account_is_refused_until_its_debt_is_paid) {
    QueryBudget budget(0.25);
    ASSERT_TRUE(budget.admit(anna, first_query).ok());
    budget.charge(anna, 0.75, first_query);  // a full balance is 0.25 s
    const Status refused = budget.admit(anna, first_query);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::resource_exhausted);
    EXPECT_EQ(refused.error().retry_after_ms, 2000) << "0.5 s of debt at 0.25 s per second";
    EXPECT_NE(refused.error().message.find("retry after 2.0 s"), std::string::npos)
        << refused.error().message;
    EXPECT_FALSE(budget.admit(anna, first_query + 1990ms).ok());
    EXPECT_TRUE(budget.admit(anna, first_query + 2010ms).ok());
}

TEST(QueryBudget, the_debt_of_one_account_does_not_refuse_another) {
    QueryBudget budget(0.25);
    budget.charge(anna, 10, first_query);
    EXPECT_FALSE(budget.admit(anna, first_query).ok());
    EXPECT_TRUE(budget.admit(ben, first_query).ok());
    budget.charge(ben, 0.1, first_query);
    EXPECT_TRUE(budget.admit(ben, first_query).ok());
}

TEST(QueryBudget, accounts_share_the_processor_time_equally) {
    QueryBudget budget(0.25);
    double spent_by_anna = 0, spent_by_ben = 0;
    for (auto now = first_query; now < first_query + 100s; now += 10ms) {
        if (budget.admit(anna, now).ok()) budget.charge(anna, 0.050, now), spent_by_anna += 0.050;
        if (budget.admit(ben, now).ok()) budget.charge(ben, 0.005, now), spent_by_ben += 0.005;
    }
    EXPECT_NEAR(spent_by_anna, 12.5, 0.5);
    EXPECT_NEAR(spent_by_ben, 12.5, 0.5);
}

TEST(QueryBudget, many_accounts_together_take_little_more_than_the_share) {
    QueryBudget budget(0.25);
    double spent = 0;
    for (auto now = first_query; now < first_query + 20s; now += 10ms)
        for (AccountId account = 1; account <= 100; account++)
            if (budget.admit(account, now).ok()) budget.charge(account, 0.001, now), spent += 0.001;
    EXPECT_LT(spent, 20 * 0.25 + 6 * 0.25)
        << "the first balances sum to 0.25 s (1 + 1/2 + 1/3 ...)";
    EXPECT_GT(spent, 20 * 0.25);
}

TEST(QueryBudget, an_account_that_paid_its_debt_is_forgotten) {
    QueryBudget budget(0.25);
    budget.charge(anna, 0.2, first_query);
    EXPECT_EQ(budget.accounts(), 1U);
    EXPECT_TRUE(budget.admit(ben, first_query + 2s).ok());
    EXPECT_EQ(budget.accounts(), 0U);
}

TEST(QueryBudget, a_share_of_0_limits_nothing) {
    QueryBudget budget(0);
    budget.charge(anna, 1000, first_query);
    EXPECT_TRUE(budget.admit(anna, first_query).ok());
}

TEST(QueryBudget, a_query_is_charged_for_the_processor_time_of_its_thread) {
    QueryBudget budget(0.001);
    ThreadCpuTime cpu_time;
    cpu_time.use_this_thread();
    {
        const QueryBudget::Spending spending(budget, anna);
        ASSERT_TRUE(spending.status().ok());
        const auto end = *cpu_time.now() + 20ms;
        while (*cpu_time.now() < end) continue;
    }
    const QueryBudget::Spending next(budget, anna);
    ASSERT_FALSE(next.status().ok());
    EXPECT_GE(next.status().error().retry_after_ms, 15000) << "19 ms of debt at 1 ms per second";
}

}  // namespace
}  // namespace jostle::server
