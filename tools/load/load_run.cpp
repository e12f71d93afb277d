// SPDX-License-Identifier: MIT
#include "tools/load/load_run.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <thread>

#include "tools/load/load_metrics.h"

namespace jostle::load {

using namespace std::chrono_literals;

namespace {

constexpr auto poll_period = 20ms, progress_period = 500ms;
constexpr double join_timeout = 10;  // s, after the ramp
constexpr rlim_t reserved_descriptors = 100;

// Rewrites one line on a terminal; prints nothing elsewhere.
class ProgressLine {
public:
    void show(const char* phase, double seconds, int clients,
              const ClientPool::Progress& progress) {
        if (!live_ || Clock::now() < next_) return;
        next_ = Clock::now() + progress_period;
        std::fprintf(stderr, "\r\033[K%s %5.1f s  %d of %d joined  %llu snapshots  %llu inputs ",
                     phase, seconds, progress.joined, clients,
                     static_cast<unsigned long long>(progress.snapshots),
                     static_cast<unsigned long long>(progress.inputs));
    }
    ~ProgressLine() {
        if (live_) std::fputs("\n", stderr);
    }

private:
    const bool live_ = isatty(STDERR_FILENO) != 0;
    Clock::time_point next_ = Clock::now();
};

double seconds_since(Clock::time_point t) {
    return std::chrono::duration<double>(Clock::now() - t).count();
}

}  // namespace

Report run_load(const LoadOptions& plan, ClientPool& pool, std::optional<int> server_pid,
                const std::atomic<bool>& stop, const std::function<void()>& before_end) {
    ProgressLine line;
    const auto cpu = [&] { return server_pid ? cpu_seconds(*server_pid) : std::nullopt; };
    const auto wait_until = [&](const char* phase, Clock::time_point since, const auto& over) {
        while (!stop && !over(seconds_since(since))) {
            line.show(phase, seconds_since(since), plan.clients, pool.progress());
            std::this_thread::sleep_for(poll_period);
        }
    };
    const auto begun = Clock::now();
    wait_until("joining", begun, [&](double s) {
        return s >= plan.ramp &&
               (pool.progress().joined >= plan.clients || s >= plan.ramp + join_timeout);
    });
    const auto joined = Clock::now();
    wait_until("settling", joined, [&](double s) { return s >= plan.settle; });
    pool.measure();
    const auto measured = Clock::now();
    const auto cpu_before = cpu();
    wait_until("measuring", measured, [&](double s) { return s >= plan.seconds; });
    const auto cpu_after = cpu();
    const double duration = seconds_since(measured);
    if (before_end) before_end();
    const int connected = pool.progress().joined;
    Report report = make_report(pool.end(), plan.clients);
    report.connected = connected;
    if (cpu_before && cpu_after)
        report.server_cpu_percent = 100 * (*cpu_after - *cpu_before) / std::max(1e-3, duration);
    return report;
}

bool raise_socket_limit(int clients) {
    rlimit limit{};
    if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return true;
    const rlim_t required = static_cast<rlim_t>(clients) + reserved_descriptors;
    if (limit.rlim_cur >= required) return true;
    limit.rlim_cur = std::min(required, limit.rlim_max);
    return setrlimit(RLIMIT_NOFILE, &limit) == 0 && limit.rlim_cur >= required;
}

}  // namespace jostle::load
