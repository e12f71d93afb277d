// SPDX-License-Identifier: MIT
#include "bench/stream/stream_row.h"

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>

#include "bench/processes/server_process.h"
#include "bench/result_file.h"
#include "tools/common/socket_address.h"
#include "tools/load/load_run.h"
#include "tools/load/passive_client_pool.h"

namespace jostle::bench {
namespace {

constexpr double base_share = 0.5;  // share of the duration for the run with one client
constexpr double settle_s = 0.7;

std::string this_program() {
    std::error_code none;
    return std::filesystem::read_symlink("/proc/self/exe", none);
}

// ServerProcess adds --port-file.
ServerProcess start_minimal_server(StreamKind kind, const StreamRequest& request) {
    return {this_program(),
            {"stream", "--serve", name_of(kind), "--bytes", std::to_string(request.bytes)},
            true};
}

ServerProcess start_server(const StreamRequest& request) {
    const std::string many = std::to_string(request.clients + 10);
    std::vector<std::string> flags = {"--scene", request.scene, "--listen",    "127.0.0.1:0",
                                      "--http",  "127.0.0.1:0", "--log-level", "warn"};
    for (const char* limit : {"world.clients_max", "world.clients_per_address_max",
                              "connection.per_address_max", "connection.total_max"})
        flags.insert(flags.end(), {"--set", limit + ("=" + many)});
    for (const std::string& setting : request.server_settings)
        flags.insert(flags.end(), {"--set", setting});
    return {std::filesystem::path(this_program()).parent_path() / "jostle-server", flags, true};
}

bool is_minimal_server(StreamKind kind) {
    return kind != StreamKind::grpc && kind != StreamKind::websocket;
}

load::Transport transport_of(StreamKind kind) {
    switch (kind) {
        case StreamKind::raw:
            return load::Transport::raw;
        case StreamKind::grpc_minimal:
        case StreamKind::grpc:
            return load::Transport::grpc;
        case StreamKind::websocket_minimal:
        case StreamKind::websocket:
            break;
    }
    return load::Transport::websocket;
}

// VmRSS of another process, in kB; see proc(5).
double memory_kb(int pid) {
    std::ifstream in("/proc/" + std::to_string(pid) + "/status");
    for (std::string word; in >> word;) {
        double kb = 0;
        if (word == "VmRSS:" && in >> kb) return kb;
    }
    return 0;
}

struct Run {
    load::Report report;
    double memory_kb = 0;
};

Result<Run> run_passive_clients(StreamKind kind, const StreamRequest& request,
                                const ServerProcess& server, int clients, double seconds) {
    load::LoadOptions plan;
    plan.target = "127.0.0.1:" + std::to_string(transport_of(kind) == load::Transport::websocket
                                                    ? server.http_port()
                                                    : server.grpc_port());
    plan.clients = clients;
    plan.threads = 1;
    plan.ramp = clients / 500.0;
    plan.settle = settle_s;
    plan.seconds = seconds;
    plan.transport = transport_of(kind);
    plan.ack_every = request.ack_every;
    plan.decode_ratio = 0;
    const auto address = common::resolve(plan.target);
    if (!address.ok()) return address.error();
    load::PassiveClientPool pool(plan, *address);
    const std::atomic<bool> stop{false};
    Run run;
    run.report = load::run_load(plan, pool, server.pid(), stop,
                                [&] { run.memory_kb = memory_kb(server.pid()); });
    if (run.report.errors > 0 || run.report.connected < clients)
        return Error{ErrorCode::unavailable, std::string(name_of(kind)) + ": of " +
                                                 std::to_string(clients) + " clients " +
                                                 std::to_string(run.report.connected) +
                                                 " stayed: " + run.report.last_error};
    return run;
}

}  // namespace

const char* name_of(StreamKind kind) {
    switch (kind) {
        case StreamKind::raw:
            return "raw";
        case StreamKind::grpc_minimal:
            return "grpc-floor";
        case StreamKind::grpc:
            return "grpc";
        case StreamKind::websocket_minimal:
            return "websocket-floor";
        case StreamKind::websocket:
            break;
    }
    return "websocket";
}

std::optional<StreamKind> minimal_server_of(StreamKind kind) {
    if (kind == StreamKind::grpc) return StreamKind::grpc_minimal;
    if (kind == StreamKind::websocket) return StreamKind::websocket_minimal;
    return std::nullopt;
}

Result<StreamCost> measure_stream(StreamKind kind, const StreamRequest& request) {
    ServerProcess server =
        is_minimal_server(kind) ? start_minimal_server(kind, request) : start_server(request);
    if (server.grpc_port() == 0)
        return Error{ErrorCode::unavailable,
                     std::string(name_of(kind)) + " did not start: " + server.log()};
    const auto one = run_passive_clients(kind, request, server, 1, base_share * request.seconds);
    if (!one.ok()) return one.error();
    const auto all = run_passive_clients(kind, request, server, request.clients, request.seconds);
    if (!all.ok()) return all.error();
    const load::Report& r = all->report;
    StreamCost cost{.single_client_percent = one->report.server_cpu_percent.value_or(0),
                    .total_percent = r.server_cpu_percent.value_or(0),
                    .snapshots_per_second = r.snapshots_per_second_per_client,
                    .messages_per_second = r.messages_per_second_per_client,
                    .snapshot_bytes = r.snapshot_bytes,
                    .age_ms_p50 = r.age_ms.p50,
                    .age_ms_p99 = r.age_ms.p99,
                    .client_us_per_message = r.load_cpu_us};
    const double more = request.clients - 1;
    cost.us_per_message = 1e4 * (cost.total_percent - cost.single_client_percent) /
                          (more * cost.snapshots_per_second);
    cost.memory_kb_per_client = (all->memory_kb - one->memory_kb) / more;
    return cost;
}

Status write_turning_scene(const std::string& path, int bodies) {
    nlohmann::json list = nlohmann::json::array();
    const int side = std::max(1, static_cast<int>(std::ceil(std::cbrt(bodies))));
    for (int k = 0; k < bodies; k++) {
        const double turn = 2 + 0.01 * (k % 97);  // rad/s, about changing axes
        list.push_back(
            {{"position",
              {{"x", 3.0 * (k % side)},
               {"y", 3.0 * (k / side % side)},
               {"z", 3.0 * (k / side / side)}}},
             {"angular_velocity", {{"x", turn}, {"y", 0.5 * turn}, {"z", 0.01 * (k % 31)}}},
             {"may_sleep", false},
             {"shapes", {{{"box", {{"half_extents", {{"x", 0.5}, {"y", 0.4}, {"z", 0.3}}}}}}}}});
    }
    const nlohmann::json scene = {
        {"name", "turning"},
        {"description", "Rotating bodies."},
        {"world", {{"gravity", {{"x", 0}, {"y", 0}, {"z", 0}}}, {"hz", 60}, {"substeps", 1}}},
        {"bodies", list}};
    return write_text(path, scene.dump()) ? Status()
                                          : Status(invalid_argument("cannot write " + path));
}

nlohmann::ordered_json to_json(const StreamCost& c) {
    return {{"us_per_message", rounded(c.us_per_message)},
            {"single_client_percent", rounded(c.single_client_percent)},
            {"total_percent", rounded(c.total_percent)},
            {"snapshots_per_second", rounded(c.snapshots_per_second)},
            {"messages_per_second", rounded(c.messages_per_second)},
            {"snapshot_bytes", rounded(c.snapshot_bytes)},
            {"age_ms_p50", rounded(c.age_ms_p50)},
            {"age_ms_p99", rounded(c.age_ms_p99)},
            {"memory_kb_per_client", rounded(c.memory_kb_per_client)},
            {"client_us_per_message", rounded(c.client_us_per_message)}};
}

}  // namespace jostle::bench
