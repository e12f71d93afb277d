// SPDX-License-Identifier: MIT
//
// jostle-relay: a bad link between clients and a server on one machine.
#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>

#include "relay/link_relay.h"

namespace {

std::atomic<bool> stop{false};

constexpr const char* footer = R"(
Prints the port it listens at, then runs until it is interrupted. Up, towards the server, has the same delay and jitter, no stalls
and no limit. Times are kept within a millisecond. The same seed gives the same link to the n-th connection.

Example:
  jostle-relay --target 127.0.0.1:50051 --listen 127.0.0.1:6000 --delay-ms 30 --jitter-ms 20 --stall-every 5 --stall-ms 300

Exit status: 0 interrupted, 1 cannot listen, 2 wrong flags.)";

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "Hands on TCP connections as a bad link would: late, unsteadily, in stalls, slowly."};
    jostle::relay::RelaySettings settings{.target = "127.0.0.1:50051"};
    std::string listen = "127.0.0.1:0";
    const auto range = [](double most) { return CLI::Range(0.0, most); };
    app.add_option("--target", settings.target, "Server, HOST:PORT")->capture_default_str();
    app.add_option("--listen", listen, "Where clients connect, HOST:PORT")->capture_default_str();
    app.add_option("--delay-ms", settings.down.delay_ms, "One way")->check(range(1e5));
    app.add_option("--jitter-ms", settings.down.jitter_ms, "Up to so much more, uniformly")
        ->check(range(1e5));
    app.add_option("--stall-every", settings.down.stall_every_s,
                   "Mean seconds between stalls; 0: none")
        ->check(range(1e5));
    app.add_option("--stall-ms", settings.down.stall_ms, "How long a stall is")
        ->capture_default_str()
        ->check(range(1e5));
    app.add_option("--kbit", settings.down.kbit_per_second,
                   "Limit of each connection, kbit/s; 0: none")
        ->check(range(1e7));
    app.add_option("--queue-bytes", settings.queue_bytes,
                   "On their way, each direction of a connection")
        ->capture_default_str()
        ->check(CLI::Range(1460, 100'000'000));
    app.add_option("--seed", settings.down.seed)->capture_default_str();
    app.footer(footer);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    std::signal(SIGINT, [](int) { stop = true; });
    std::signal(SIGTERM, [](int) { stop = true; });
    jostle::relay::LinkRelay relay(settings);
    if (const auto status = relay.listen(listen); !status.ok()) {
        std::fprintf(stderr, "jostle-relay: %s\n", status.error().message.c_str());
        return 1;
    }
    std::printf("%d\n", relay.port());
    std::fflush(stdout);
    relay.run(stop);
    return 0;
}
