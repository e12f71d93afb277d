// SPDX-License-Identifier: MIT
//
// jostle-netem: network emulator between clients and a server on one machine.
#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <string>
#include <vector>

#include "base/command_line/command_line.h"
#include "tools/network_emulator/packet_forwarder.h"
#include "tools/network_emulator/tcp_proxy.h"

namespace {

std::atomic<bool> stop{false};

constexpr const char* footer = R"(
The program prints the port on which it listens and runs until it is interrupted. The direction
towards the server has no stalls and no bandwidth limit. Times are accurate to 1 ms. The same seed
reproduces the impairments of the n-th connection.

With --tun-devices it creates two network devices instead, prints "ready", and forwards IP packets
between them with the same impairments in both directions. Move each device into its own network
namespace to emulate TCP and UDP between programs there. Requires root; see scripts/bad-links.

Examples:
  jostle-netem --server 127.0.0.1:50051 --listen 127.0.0.1:6000 --latency-ms 30 --jitter-ms 20
  jostle-netem --stall-interval-ms 5000 --stall-ms 300
  jostle-netem --tun-devices here0 there0 --loss 0.02 --latency-ms 20

Exit status: 0 interrupted, 1 cannot listen or create devices, 2 invalid flags.)";

int forward_packets(const std::vector<std::string>& devices,
                    const jostle::NetworkConditions& conditions) {
    jostle::network_emulator::PacketForwarder forwarder(
        {.devices = {devices[0], devices[1]}, .conditions = conditions});
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
        "Emulate network conditions for TCP connections or IP packets: latency, jitter, stalls,\n"
        "loss, duplication, reordering and a bandwidth limit."};
    jostle::network_emulator::TcpProxySettings settings{.target = "127.0.0.1:50051"};
    std::string listen = "127.0.0.1:0";
    std::vector<std::string> between;
    jostle::NetworkConditions& conditions = settings.down;
    const auto add = [&](const char* name, double& value, const char* type, double least,
                         double most, const char* text) {
        return app.add_option(name, value, text)
            ->type_name(type)
            ->check(CLI::Range(least, most).description(""));
    };
    app.add_option("--server", settings.target,
                   "Forward connections to this server [default: 127.0.0.1:50051]")
        ->type_name("HOST:PORT");
    app.add_option("--listen", listen,
                   "Listen for clients; port 0 selects a free port [default: 127.0.0.1:0]")
        ->type_name("HOST:PORT");
    app.add_option("--tun-devices", between, "Create two TUN devices and forward IP packets")
        ->type_name("NAME")
        ->expected(2);
    add("--latency-ms", conditions.latency_ms, "MS", 0, 60'000,
        "Delay data by MS in each direction [default: 0; 0 to 60000]");
    add("--jitter-ms", conditions.jitter_ms, "MS", 0, 60'000,
        "Add a uniformly distributed delay up to MS [default: 0; 0 to 60000]");
    add("--jitter-tail-ms", conditions.jitter_tail_ms, "MS", 0, 60'000,
        "Add an exponentially distributed delay with mean MS\n[default: 0; 0 to 60000]");
    add("--stall-ms", conditions.stall_ms, "MS", 0, 60'000,
        "Duration of a stall, during which nothing arrives\n[default: 0; 0 to 60000]");
    add("--stall-interval-ms", conditions.stall_interval_ms, "MS", 0, 1e9,
        "Mean time between the starts of stalls\n[default: 5000; 0 to 1000000000]");
    add("--loss", conditions.loss, "FRACTION", 0, 1,
        "Lose this fraction of IP packets, or delay this fraction of the data\n"
        "of a connection by a retransmission [default: 0; 0 to 1]");
    add("--loss-burst", conditions.loss_burst, "N", 1, 1000,
        "Mean number of consecutive losses [default: 1; 1 to 1000]");
    add("--retransmit-ms", conditions.retransmit_ms, "MS", 0, 60'000,
        "Delay of a retransmission [default: 200; 0 to 60000]");
    add("--duplicate", conditions.duplicate, "FRACTION", 0, 1,
        "Duplicate this fraction of IP packets [default: 0; 0 to 1]");
    add("--reorder", conditions.reorder, "FRACTION", 0, 1,
        "Let later packets overtake this fraction of IP packets\n[default: 0; 0 to 1]");
    add("--reorder-ms", conditions.reorder_ms, "MS", 0, 60'000,
        "Delay of an overtaken packet [default: 20; 0 to 60000]");
    add("--rate-kbps", conditions.rate_kbps, "KBIT/S", 0, 1e7,
        "Limit the bandwidth of each connection; 0 is unlimited\n"
        "[default: 0; 0 to 10000000]");
    const CLI::Option* queue =
        add("--queue-bytes", conditions.queue_bytes, "BYTES", 1460, 1e9,
            "Hold at most BYTES in transit per direction; IP packets beyond\n"
            "it are lost [default: 65536, with --tun-devices 30000000;\n"
            "1460 to 1000000000]");
    app.add_option("--seed", conditions.seed, "Seed of the random number generator [default: 1]")
        ->type_name("N");
    app.footer(footer);
    if (const auto status =
            jostle::parse_command_line(app, {"jostle-netem", JOSTLE_VERSION}, argc, argv))
        return *status;
    std::signal(SIGINT, [](int) { stop = true; });
    std::signal(SIGTERM, [](int) { stop = true; });
    if (queue->count() == 0) conditions.queue_bytes = between.empty() ? 65'536 : 30e6;
    if (!between.empty()) return forward_packets(between, conditions);
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
