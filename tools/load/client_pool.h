// SPDX-License-Identifier: MIT
//
// The clients of a load run, independent of their kind. They start to connect on construction.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "tools/load/load_metrics.h"
#include "tools/load/load_options.h"

namespace jostle::load {

class ClientPool {
public:
    struct Progress {
        int joined = 0;  // joined and still connected
        std::uint64_t snapshots = 0, inputs = 0;
    };

    virtual ~ClientPool() = default;
    virtual Progress progress() const = 0;
    // Resets the metrics; the measurement starts now.
    virtual void measure() = 0;
    // Disconnects all clients and returns their metrics; call it once.
    virtual LoadMetrics end() = 0;
};

// A client pool distributed over threads, each with every n-th client. A Thread is constructed with
// the arguments of the pool, the number of its first client, the step to the next one, and the
// start time of the run. It has progress(), measure() and end() like a ClientPool.
template <class Thread>
class ThreadedClientPool : public ClientPool {
public:
    template <class... More>
    explicit ThreadedClientPool(const LoadOptions& plan, const More&... more) {
        const Clock::time_point begun = Clock::now();
        const int threads = std::min(plan.threads, plan.clients);
        for (int k = 0; k < threads; k++)
            threads_.push_back(std::make_unique<Thread>(plan, more..., k, threads, begun));
    }

    Progress progress() const override {
        Progress all;
        for (const auto& thread : threads_) {
            const Progress one = thread->progress();
            all.joined += one.joined;
            all.snapshots += one.snapshots;
            all.inputs += one.inputs;
        }
        return all;
    }
    void measure() override {
        for (const auto& thread : threads_) thread->measure();
    }
    LoadMetrics end() override {
        LoadMetrics all;
        for (const auto& thread : threads_) all.merge(thread->end());
        return all;
    }

private:
    std::vector<std::unique_ptr<Thread>> threads_;
};

}  // namespace jostle::load
