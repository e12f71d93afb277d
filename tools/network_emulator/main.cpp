// SPDX-License-Identifier: MIT
//
// jostle-netem: network emulator between clients and a server on one machine.
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
The program prints the port on which it listens and runs until it is interrupted. The direction
towards the server has the same delay and jitter, but no stalls and no bandwidth limit. Times are
accurate to 1 ms. The same seed reproduces the impairments of the n-th connection.

With --tun-devices it creates two network devices instead, prints "ready", and forwards IP packets
between them with --loss-percent packet loss in each direction. Move each device into its own
network namespace to emulate TCP and UDP between programs there. Requires root; see
scripts/bad-links.

Examples:
  jostle-netem --server 127.0.0.1:50051 --listen 127.0.0.1:6000 --delay-ms 30 --jitter-ms 20
  jostle-netem --stall-interval-seconds 5 --stall-ms 300
  jostle-netem --tun-devices here0 there0 --loss-percent 2 --delay-ms 20

Exit status: 0 interrupted, 1 cannot listen or create devices, 2 invalid flags.)";

int forward_packets(const std::vector<std::string>& devices,
                    const jostle::network_emulator::NetworkConditions& path) {
    jostle::network_emulator::PacketForwarder forwarder(
        {.devices = {devices[0], devices[1]}, .path = path});
    if (const auto status = forwarder.open(); !status.ok()) {
        std::fprintf(stderr, "jostle-netem: %s\n", status.error().message.c_str());
        return 1;
    }
    std::printf("ready\n");
    std::fflush(stdout);
    forwarder.run(stop);
    std::printf("%llu packets forwarded, %llu lost\n",
                static_cast<unsigned long long>(forwarder.forwarded()),
                static_cast<unsigned long long>(forwarder.lost()));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "Emulate network conditions for TCP connections or IP packets: delay, jitter, stalls,\n"
        "bandwidth limit and packet loss."};
    jostle::network_emulator::TcpProxySettings settings{.target = "127.0.0.1:50051"};
    std::string listen = "127.0.0.1:0";
    std::vector<std::string> between;
    double loss_percent = 0;
    const auto range = [](double most) { return CLI::Range(0.0, most).description(""); };
    app.add_option("--server", settings.target,
                   "Forward connections to this server [default: 127.0.0.1:50051]")
        ->type_name("HOST:PORT");
    app.add_option("--listen", listen,
                   "Listen for clients; port 0 selects a free port [default: 127.0.0.1:0]")
        ->type_name("HOST:PORT");
    app.add_option("--delay-ms", settings.down.delay_ms,
                   "Delay data by MS in each direction [default: 0; 0 to 100000]")
        ->type_name("MS")
        ->check(range(1e5));
    app.add_option("--jitter-ms", settings.down.jitter_ms,
                   "Add a uniformly distributed delay up to MS [default: 0; 0 to 100000]")
        ->type_name("MS")
        ->check(range(1e5));
    app.add_option("--stall-interval-seconds", settings.down.stall_every_s,
                   "Mean time between stalls; 0 disables stalls [default: 0; 0 to 100000]")
        ->type_name("SECONDS")
        ->check(range(1e5));
    app.add_option("--stall-ms", settings.down.stall_ms,
                   "Duration of a stall [default: 200; 0 to 100000]")
        ->type_name("MS")
        ->check(range(1e5));
    app.add_option("--kbit-per-second", settings.down.kbit_per_second,
                   "Limit the bandwidth of each connection; 0 is unlimited\n"
                   "[default: 0; 0 to 10000000]")
        ->type_name("KBIT/S")
        ->check(range(1e7));
    CLI::Option* devices =
        app.add_option("--tun-devices", between, "Create two TUN devices and forward IP packets")
            ->type_name("NAME")
            ->expected(2);
    app.add_option("--loss-percent", loss_percent,
                   "Drop this percentage of packets per direction [default: 0; 0 to 100]")
        ->type_name("PERCENT")
        ->needs(devices)
        ->check(range(100));
    app.add_option("--queue-bytes", settings.queue_bytes,
                   "Buffer at most BYTES per direction of a connection\n"
                   "[default: 65536; 1460 to 100000000]")
        ->type_name("BYTES")
        ->check(CLI::Range(1460, 100'000'000).description(""));
    app.add_option("--seed", settings.down.seed, "Seed of the random number generator [default: 1]")
        ->type_name("N");
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
    jostle::network_emulator::TcpProxy proxy(settings);
    if (const auto status = proxy.listen(listen); !status.ok()) {
        std::fprintf(stderr, "jostle-netem: %s\n", status.error().message.c_str());
        return 1;
    }
    std::printf("%d\n", proxy.port());
    std::fflush(stdout);
    proxy.run(stop);
    return 0;
}
