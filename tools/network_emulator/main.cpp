// SPDX-License-Identifier: MIT
//
// jostle-netem: a bad link between clients and a server on one machine.
#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <string>
#include <vector>

#include "tools/network_emulator/packet_forwarder.h"
#include "tools/network_emulator/tcp_proxy.h"

namespace {

std::atomic<bool> stop{false};

constexpr const char* footer = R"(
Prints the port it listens at, then runs until it is interrupted. Up, towards the server, has the same delay and jitter, no stalls
and no limit. Times are kept within a millisecond. The same seed gives the same link to the n-th connection.

With --tun-devices it makes two network devices instead, prints "ready", and hands on whole IP packets between them, of which --loss-percent percent are
lost each way: put each device into a network namespace, and what runs there loses packets, be it TCP or UDP. Needs root (scripts/bad-links).

Examples:
  jostle-netem --server 127.0.0.1:50051 --listen 127.0.0.1:6000 --delay-ms 30 --jitter-ms 20 --stall-interval-seconds 5 --stall-ms 300
  jostle-netem --tun-devices here0 there0 --loss-percent 2 --delay-ms 20

Exit status: 0 interrupted, 1 cannot listen or make devices, 2 wrong flags.)";

int forward_packets(const std::vector<std::string>& devices,
                    const jostle::network_emulator::NetworkConditions& path) {
    jostle::network_emulator::PacketForwarder relay(
        {.devices = {devices[0], devices[1]}, .path = path});
    if (const auto status = relay.open(); !status.ok()) {
        std::fprintf(stderr, "jostle-netem: %s\n", status.error().message.c_str());
        return 1;
    }
    std::printf("ready\n");
    std::fflush(stdout);
    relay.run(stop);
    std::printf("%llu packets handed on, %llu lost\n",
                static_cast<unsigned long long>(relay.forwarded()),
                static_cast<unsigned long long>(relay.lost()));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "Hands on TCP connections, or IP packets, as a bad link would: late, unsteadily, in "
        "stalls, slowly."};
    jostle::network_emulator::TcpProxySettings settings{.target = "127.0.0.1:50051"};
    std::string listen = "127.0.0.1:0";
    std::vector<std::string> between;
    double loss_percent = 0;
    const auto range = [](double most) { return CLI::Range(0.0, most); };
    app.add_option("--server", settings.target, "Server, HOST:PORT")->capture_default_str();
    app.add_option("--listen", listen, "Where clients connect, HOST:PORT")->capture_default_str();
    app.add_option("--delay-ms", settings.down.delay_ms, "One way")->check(range(1e5));
    app.add_option("--jitter-ms", settings.down.jitter_ms, "Up to so much more, uniformly")
        ->check(range(1e5));
    app.add_option("--stall-interval-seconds", settings.down.stall_every_s,
                   "Mean seconds between stalls; 0: none")
        ->check(range(1e5));
    app.add_option("--stall-ms", settings.down.stall_ms, "How long a stall is")
        ->capture_default_str()
        ->check(range(1e5));
    app.add_option("--kbit-per-second", settings.down.kbit_per_second,
                   "Limit of each connection, kbit/s; 0: none")
        ->check(range(1e7));
    CLI::Option* devices =
        app.add_option("--tun-devices", between, "Names of two network devices to make")
            ->expected(2);
    app.add_option("--loss-percent", loss_percent, "Percent of packets that are lost, each way")
        ->needs(devices)
        ->check(range(100));
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
    settings.down.loss = loss_percent / 100;
    if (!between.empty()) return forward_packets(between, settings.down);
    jostle::network_emulator::TcpProxy relay(settings);
    if (const auto status = relay.listen(listen); !status.ok()) {
        std::fprintf(stderr, "jostle-netem: %s\n", status.error().message.c_str());
        return 1;
    }
    std::printf("%d\n", relay.port());
    std::fflush(stdout);
    relay.run(stop);
    return 0;
}
