// SPDX-License-Identifier: MIT
//
// jostle-simulation: complete simulated servers, seeded, faster than real time.
#include <google/protobuf/stubs/logging.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fstream>

#include "base/command_line/command_line.h"
#include "tests/simulation/simulation.h"

namespace {

using jostle::simulation::Simulation;
using jostle::simulation::Tally;

constexpr const char* footer = R"(
Three honest clients and a hostile one play over slow and breaking connections. Meanwhile the
machine is suspended, worlds are paused and recreated, and the server process restarts. Checks:
- honest clients decode the exact state of the world;
- each input has one result, and a spawned body exists from the tick of its result;
- a client that leaves leaves nothing behind;
- memory does not grow.

A failure names its seed and tick. The same seed with --ticks up to that tick reproduces it.

Exit status: 0 all guarantees held, 1 a guarantee was violated, 2 invalid flags.)";

// Resident memory of this process in MB.
double resident_mb() {
    std::ifstream file("/proc/self/statm");
    double all = 0, resident = 0;
    file >> all >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

// Allowed growth in the second half of a run: memory that allocators retain.
constexpr double growth_mb_max = 16;

struct Flags {
    std::uint64_t seed = 1, ticks = 200'000;
    bool twice = false;
};

int run(const Flags& flags) {
    const auto began = std::chrono::steady_clock::now();
    Simulation simulation(flags.seed);
    const bool live = isatty(STDERR_FILENO) != 0;
    double half_mb = 0;
    constexpr std::uint64_t part = 10'000;
    while (simulation.ticks() < flags.ticks && simulation.failure().empty()) {
        simulation.run(std::min(part, flags.ticks - simulation.ticks()));
        if (half_mb == 0 && 2 * simulation.ticks() >= flags.ticks) half_mb = resident_mb();
        if (live)
            std::fprintf(stderr, "\r%llu of %llu ticks ",
                         static_cast<unsigned long long>(simulation.ticks()),
                         static_cast<unsigned long long>(flags.ticks));
    }
    if (live) std::fprintf(stderr, "\r");
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    const Tally& t = simulation.tally();
    const auto n = [](std::uint64_t x) { return static_cast<unsigned long long>(x); };
    std::printf("seed %llu: %llu ticks in %.1f s, %.0f per minute; fingerprint %016llx\n",
                n(flags.seed), n(simulation.ticks()), seconds,
                60 * static_cast<double>(simulation.ticks()) / seconds,
                n(simulation.fingerprint()));
    std::printf(
        "  %llu connections (%llu resumed), %llu snapshots decoded, %llu of them compared; %llu "
        "inputs, %llu applied, %llu rejected, %llu bodies spawned\n",
        n(t.connections), n(t.resumed), n(t.snapshots), n(t.frames_compared), n(t.inputs),
        n(t.applied), n(t.refused), n(t.spawned));
    std::printf("  %llu hostile messages, %llu faults; %.0f MB at half time, %.0f MB at the end\n",
                n(t.hostile_messages), n(t.faults), half_mb, resident_mb());
    if (!simulation.failure().empty()) {
        std::printf("FAILED: %s\n", simulation.failure().c_str());
        return 1;
    }
    if (resident_mb() > half_mb + growth_mb_max) {
        std::printf("FAILED: memory grows\n");
        return 1;
    }
    if (!flags.twice) return 0;
    Simulation again(flags.seed);
    again.run(flags.ticks);
    if (again.fingerprint() == simulation.fingerprint()) return 0;
    std::printf("FAILED: the same seed gave a different fingerprint\n");
    return 1;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Simulate complete servers with their clients, much faster than real time."};
    Flags flags;
    app.add_option("--seed", flags.seed, "Seed of the random numbers")->capture_default_str();
    app.add_option("--ticks", flags.ticks, "Number of ticks")
        ->capture_default_str()
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000'000}));
    app.add_flag("--twice", flags.twice, "Run twice; both runs must give the same fingerprint");
    app.footer(footer);
    if (const auto status =
            jostle::parse_command_line(app, {"jostle-simulation", JOSTLE_VERSION}, argc, argv))
        return *status;
    spdlog::set_level(spdlog::level::off);
    google::protobuf::SetLogHandler(nullptr);  // hostile clients provoke messages
    return run(flags);
}
