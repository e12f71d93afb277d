// SPDX-License-Identifier: MIT
#include "bench/speed/server_row.h"

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <fstream>
#include <thread>

#include "bench/measure.h"
#include "bench/processes/server_process.h"
#include "bench/result_file.h"
#include "bench/speed/field_json.h"

namespace jostle::bench {

namespace {

void write_identity(const ServerRow& row, const FieldWriter& field) {
    field("scene", row.scene);
    field("name", row.name);
    field("threads", row.threads);
    field("clients", row.clients);
    field("seconds", row.seconds);
    field("failed", row.failed);
}

void write_figures(const ServerRow& row, const FieldWriter& field) {
    field("bodies", row.bodies);
    field("hz", row.hz);
    field("ticks", row.ticks);
    field("late_ticks", row.late_ticks);
    field("late_share", row.late_share);
    field("ticks_over_period", row.ticks_over_period);
    field("ms_mean", row.ms_mean);
    field("ms_p99", row.ms_p99);
    field("ms_worst", row.ms_worst);
    field("begun_late_ms_worst", row.begun_late_ms_worst);
    field("verdict", row.verdict);
    field("connected", row.connected);
    field("snapshots_per_second_per_client", row.snapshots_per_second_per_client);
    field("kbit_per_second_per_client", row.kbit_per_second_per_client);
    field("age_ms_p50", row.age_ms_p50);
    field("age_ms_p99", row.age_ms_p99);
    field("errors", row.errors);
    field("server_cpu_percent", row.server_cpu_percent);
}

}  // namespace

const char* verdict_of(const ServerRow& row) {
    if (row.late_ticks > 0) return "late";
    return row.ticks_over_period > 0 ? "catches up" : "holds";
}

nlohmann::ordered_json to_json(const ServerRow& row) {
    nlohmann::ordered_json json;
    write_identity(row, FieldWriter{json});
    if (!row.failed) write_figures(row, FieldWriter{json});
    return json;
}

namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using Arguments = std::vector<std::string>;

constexpr auto join_timeout = 30s;  // for all clients
constexpr auto call_timeout = 30s;  // allows for a long step between two replies of the server
constexpr auto poll_period = 50ms;
constexpr double ramp_seconds = 1, seconds_without_end = 3600;
// Clients spawn nothing, so that the scene equals that of the other rows.
constexpr const char* usual_script = "push\n";

std::string beside_this_program(const char* name) {
    std::error_code none;
    return std::filesystem::read_symlink("/proc/self/exe", none).parent_path() / name;
}

Status check_programs() {
    for (const char* name : {"jostle-server", "jostle-load", "jostlectl"})
        if (const std::string path = beside_this_program(name); !std::filesystem::exists(path))
            return Error{ErrorCode::not_found, path + " not found; build the target " + name};
    return {};
}

std::string last_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

// A server with one world, and its clients. Destructors run in reverse order: clients first.
class Experiment {
public:
    explicit Experiment(const ServerRequest& request)
        : request_(request),
          world_(request.scene->name),
          server_(
              beside_this_program("jostle-server"),
              {"--scene", world_, "--listen", "127.0.0.1:0", "--http", "127.0.0.1:0", "--log-level",
               "warn", "--set", "tick.physics_threads=" + std::to_string(request.threads)},
              true) {}

    Status run(ServerRow& row);

private:
    Program start(const char* name, Arguments flags) const {
        return Program(beside_this_program(name), flags, server_.file(std::string(name) + ".log"));
    }
    Result<std::string> run_jostlectl(Arguments flags);
    Result<json> world();
    Program start_clients() const;
    Status wait_for_clients(Program& load);
    Status record();
    Status fill_ticks(ServerRow& row);
    Status fill_clients(ServerRow& row, Program& load);

    const ServerRequest& request_;
    std::string world_;
    ServerProcess server_;
};

Error ended(const std::string& what, const Program& program) {
    return {ErrorCode::internal, what + ": " + last_line(program.log())};
}

// --- requests to the server ---

// Returns the output of jostlectl.
Result<std::string> Experiment::run_jostlectl(Arguments flags) {
    flags.insert(flags.begin(), {"--server", server_.grpc_address()});
    const std::string log = server_.file("answer");
    std::filesystem::remove(log);
    Program ctl(beside_this_program("jostlectl"), flags, log);
    const auto timeout = call_timeout + std::chrono::duration_cast<std::chrono::milliseconds>(
                                            std::chrono::duration<double>(request_.seconds));
    if (ctl.wait(timeout) != 0) return ended("jostlectl " + flags[2], ctl);
    return ctl.log();
}

Result<json> Experiment::world() {
    const auto answer = run_jostlectl({"worlds", "--json"});
    if (!answer) return answer.error();
    const json worlds = json::parse(*answer, nullptr, false);
    if (worlds.is_discarded() || worlds["worlds"].empty())
        return Error{ErrorCode::not_found, "the server has no world"};
    return json(worlds["worlds"][0]);
}

// --- the run ---

Program Experiment::start_clients() const {
    std::string script = request_.script;
    if (script.empty()) {
        script = server_.file("push.bots");
        std::ofstream(script) << usual_script;
    }
    return start("jostle-load",
                 {"--server", server_.grpc_address(), "--world", world_, "--clients",
                  std::to_string(request_.clients), "--ramp", std::to_string(ramp_seconds),
                  "--seconds", std::to_string(seconds_without_end), "--script", script, "--json",
                  server_.file("load.json")});
}

Status Experiment::wait_for_clients(Program& load) {
    const auto deadline = std::chrono::steady_clock::now() + join_timeout;
    const auto ramp_end = std::chrono::steady_clock::now() +
                          std::chrono::milliseconds(static_cast<int>(1000 * ramp_seconds));
    for (;;) {
        if (!load.is_running()) return ended("jostle-load ended", load);
        const auto now = world();
        if (!now) return now.error();
        if (now->at("clients").get<int>() >= request_.clients) break;
        if (std::chrono::steady_clock::now() > deadline)
            return Error{ErrorCode::deadline_exceeded,
                         "of " + std::to_string(request_.clients) + " clients " +
                             std::to_string(now->at("clients").get<int>()) + " joined in " +
                             std::to_string(join_timeout.count()) + " s"};
        std::this_thread::sleep_for(poll_period);
    }
    std::this_thread::sleep_until(ramp_end);
    return {};
}

// Resumes the world and records its ticks.
Status Experiment::record() {
    Program profile =
        start("jostlectl", {"--server", server_.grpc_address(), "profile", world_,
                            server_.file("trace"), "--seconds", std::to_string(request_.seconds)});
    if (const auto resumed = run_jostlectl({"resume", world_}); !resumed) return resumed.error();
    if (profile.wait(call_timeout +
                     std::chrono::milliseconds(static_cast<int>(1000 * request_.seconds))) != 0)
        return ended("jostlectl profile", profile);
    const auto now = world();
    if (!now) return now.error();
    if (const std::string why = now->at("paused").get<std::string>(); !why.empty())
        return Error{ErrorCode::aborted, "the server paused the world: " + why};
    return {};
}

// --- results ---

Status Experiment::fill_ticks(ServerRow& row) {
    const auto times = read_tick_times(read_file(server_.file("trace")));
    if (!times) return times.error();
    if (times->ms.empty()) return Error{ErrorCode::deadline_exceeded, "no tick was recorded"};
    const double period_ms = 1000 / row.hz;
    row.ticks = static_cast<int>(times->ms.size());
    row.late_ticks = times->late;
    row.late_share = rounded(static_cast<double>(row.late_ticks) / (row.ticks + row.late_ticks));
    row.ticks_over_period = static_cast<int>(std::count_if(
        times->ms.begin(), times->ms.end(), [&](double ms) { return ms > period_ms; }));
    row.ms_mean = rounded(mean(times->ms));
    row.ms_p99 = rounded(percentile_99(times->ms));
    row.ms_worst = rounded(*std::max_element(times->ms.begin(), times->ms.end()));
    row.begun_late_ms_worst = rounded(times->begun_late_ms);
    row.verdict = verdict_of(row);
    return {};
}

Status Experiment::fill_clients(ServerRow& row, Program& load) {
    load.signal(SIGTERM);
    if (!load.wait(call_timeout)) return ended("jostle-load did not end", load);
    const json report = json::parse(read_file(server_.file("load.json")), nullptr, false);
    if (report.is_discarded()) return ended("jostle-load wrote no report", load);
    row.connected = report.at("connected").get<int>();
    row.snapshots_per_second_per_client =
        rounded(report.at("snapshots_per_second_per_client").get<double>());
    row.kbit_per_second_per_client = rounded(report.at("kbit_per_second_per_client").get<double>());
    row.age_ms_p50 = rounded(report.at("age_ms_p50").get<double>());
    row.age_ms_p99 = rounded(report.at("age_ms_p99").get<double>());
    row.errors = report.at("errors").get<int>();
    if (const json& cpu = report.at("server_cpu_percent"); !cpu.is_null())
        row.server_cpu_percent = rounded(cpu.get<double>());
    return {};
}

// The world is paused until all clients have joined, so that the measurement covers the scene from
// its start.
Status Experiment::run(ServerRow& row) {
    if (server_.grpc_port() == 0)
        return Error{ErrorCode::unavailable,
                     "jostle-server did not start: " + last_line(server_.log())};
    if (const auto paused = run_jostlectl({"pause", world_}); !paused) return paused.error();
    const auto hosted = world();
    if (!hosted) return hosted.error();
    row.bodies = hosted->at("bodies").get<int>();
    row.hz = hosted->at("hz").get<double>();
    Program load = start_clients();
    if (Status joined = wait_for_clients(load); !joined) return joined;
    if (Status recorded = record(); !recorded) return recorded;
    if (Status filled = fill_clients(row, load); !filled) return filled;
    return fill_ticks(row);
}

}  // namespace

ServerRow measure_server_row(const ServerRequest& request) {
    ServerRow row{.scene = request.scene->letter,
                  .name = request.scene->name,
                  .threads = request.threads,
                  .clients = request.clients,
                  .seconds = request.seconds};
    if (const Status status = check_programs(); !status) {
        row.failed = status.error().message;
        return row;
    }
    show_progress(row.name + ": a server with " + std::to_string(row.clients) + " clients");
    // The temporary folder could not be created, or the JSON of a program has an unexpected form.
    try {
        Experiment experiment(request);
        if (const Status status = experiment.run(row); !status) row.failed = status.error().message;
    } catch (const std::exception& error) {
        row.failed = error.what();
    }
    show_progress("");
    return row;
}

}  // namespace jostle::bench
