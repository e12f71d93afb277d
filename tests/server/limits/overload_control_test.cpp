// SPDX-License-Identifier: MIT
#include "server/limits/overload_control.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <random>
#include <vector>

#include "server/limits/flow_control.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

Clock::time_point at(double seconds) {
    return Clock::time_point{} + 1h + from_seconds(seconds);
}

// Periods of 0.25 s in which every snapshot has the same delay.
void send_for(OverloadControl& overload, double& now_s, double seconds, double delay_s) {
    for (const double end_s = now_s + seconds; now_s < end_s; now_s += 0.01)
        overload.on_sent(delay_s, 1 / 60.0, 1 / 60.0, at(now_s));
}

TEST(OverloadControl, rises_while_snapshots_are_late) {
    OverloadControl overload;
    double now_s = 0;
    send_for(overload, now_s, 1, 0.012);
    EXPECT_EQ(overload.level(), 0);
    send_for(overload, now_s, 0.3, 0.015);
    EXPECT_EQ(overload.level(), 0) << "one period";
    send_for(overload, now_s, 0.3, 0.015);
    EXPECT_EQ(overload.level(), 1);
    send_for(overload, now_s, 10, 0.015);
    EXPECT_EQ(overload.level(), 6) << "the slowest level";
    EXPECT_NEAR(overload.send_delay_s(), 0.015, 1e-9);
}

TEST(OverloadControl, one_stall_does_not_raise_the_level) {
    OverloadControl overload;
    // Ten clients at 60 Hz; at 1 s the thread stands still for 0.2 s.
    for (int tick = 0; tick < 120; tick++)
        for (int client = 0; client < 10; client++)
            overload.on_sent(tick == 60 ? 0.2 : 0.001, 1 / 60.0, 1 / 60.0, at(tick / 60.0));
    EXPECT_EQ(overload.level(), 0);
}

// A network thread that serves its clients one after the other, as PlayShard does. The clients
// acknowledge ten times per second.
class NetworkThread {
public:
    NetworkThread(int clients, std::uint32_t seed) : random_(seed) {
        for (int k = 0; k < clients; k++)
            clients_.push_back({std::make_unique<FlowControl>(StreamSettings{}, hz, 1, &overload_),
                                {},
                                0,
                                -0.1 * k / clients});
    }

    // `cost_s`: of one snapshot.
    void run_until(double end_s, double cost_s) {
        std::uniform_real_distribution<double> noise(0.9, 1.1);
        while (now_s_ < end_s) {
            take_acks();
            const auto newest = static_cast<std::uint32_t>(now_s_ * hz);
            first_ = (first_ + 7) % clients_.size();
            bool busy = false;
            for (std::size_t k = 0; k < clients_.size(); k++)
                busy |= serve(clients_[(first_ + k) % clients_.size()], newest,
                              cost_s * noise(random_));
            if (!busy) now_s_ = std::max(now_s_, (newest + 1) / hz + 1e-6);
        }
    }
    // Snapshots of each client between two times; sorted.
    std::vector<int> sent_between(double from_s, double until_s) const {
        std::vector<int> counts;
        for (const Client& client : clients_)
            counts.push_back(static_cast<int>(std::ranges::count_if(
                client.sent_s, [&](double sent) { return sent >= from_s && sent < until_s; })));
        std::ranges::sort(counts);
        return counts;
    }
    int level() const { return overload_.level(); }

private:
    static constexpr double hz = 60;
    struct Client {
        std::unique_ptr<FlowControl> flow;
        std::vector<double> sent_s;
        std::uint32_t last = 0, unacknowledged = 0;
        double last_ack_s = 0;
        double received_s = 0;

        Client(std::unique_ptr<FlowControl> control, std::vector<double> sent, std::uint32_t newest,
               double acked_s)
            : flow(std::move(control)),
              sent_s(std::move(sent)),
              last(newest),
              last_ack_s(acked_s) {}
    };

    bool serve(Client& client, std::uint32_t newest, double cost_s) {
        if (newest <= client.last) return false;
        const std::uint32_t step = client.flow->step();
        const std::uint32_t first = (client.last / step + 1) * step, due = newest / step * step;
        client.last = newest;
        if (due < first || !client.flow->may_send(due, at(now_s_))) return false;
        now_s_ += cost_s;
        client.flow->on_sent(newest, at(now_s_));
        client.flow->on_send_delay(now_s_ - first / hz, at(now_s_));
        client.sent_s.push_back(now_s_);
        client.unacknowledged = newest;
        client.received_s = now_s_;
        return true;
    }
    void take_acks() {
        for (Client& client : clients_) {
            if (client.unacknowledged == 0 || now_s_ - client.last_ack_s < 0.1) continue;
            client.last_ack_s = now_s_;
            client.flow->on_ack(client.unacknowledged,
                                from_seconds(std::max(0.0, now_s_ - client.received_s - 0.02)),
                                at(now_s_));
            client.unacknowledged = 0;
            now_s_ += 2e-6;
        }
    }

    OverloadControl overload_;
    std::vector<Client> clients_;
    std::mt19937 random_;
    std::size_t first_ = 0;
    double now_s_ = 1 / hz;
};

TEST(OverloadControl, all_clients_of_an_overloaded_thread_get_an_even_rate) {
    NetworkThread thread(1000, 1);
    thread.run_until(4, 25e-6);  // 25 ms a round: more than a tick
    EXPECT_EQ(thread.level(), 1);
    thread.run_until(9, 25e-6);
    EXPECT_EQ(thread.level(), 1) << "the level must not alternate";
    const std::vector<int> counts = thread.sent_between(4, 8);
    EXPECT_GE(counts.front(), 4 * 30 - 2);
    EXPECT_LE(counts.back(), 4 * 30 + 2);
}

TEST(OverloadControl, all_clients_recover_within_three_seconds_after_ten_seconds_of_overload) {
    for (std::uint32_t run = 1; run <= 20; run++) {
        NetworkThread thread(400, run);
        thread.run_until(5, 15e-6);
        EXPECT_EQ(thread.sent_between(3, 5).front(), 120) << "run " << run;
        thread.run_until(15, (60 + 10 * run) * 1e-6);
        EXPECT_GE(thread.level(), 1) << "run " << run;
        thread.run_until(20, 15e-6);
        EXPECT_EQ(thread.level(), 0) << "run " << run;
        EXPECT_GE(thread.sent_between(18, 20).front(), 119) << "run " << run;
    }
}

}  // namespace
}  // namespace jostle::server
