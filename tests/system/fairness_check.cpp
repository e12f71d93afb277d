// SPDX-License-Identifier: MIT
//
// Measures what honest players notice of one that takes as much of a world as the default limits
// allow: two honest players in the attacked world and one in another world of the same server.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <grpcpp/grpcpp.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "bench/processes/server_process.h"
#include "jostle/client/client.h"
#include "jostle/v1/query.grpc.pb.h"

namespace jostle {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

v1::Vec3 vector_of(double x, double y, double z) {
    v1::Vec3 v;
    v.set_x(x), v.set_y(y), v.set_z(z);
    return v;
}

// ---- attackers: in a process of their own, at a lower priority ----

// A hull with `count` vertices on a sphere.
void write_hull(v1::Hull& hull, int count, double radius) {
    for (int k = 0; k < count; k++) {
        const double height = 1 - 2 * (k + 0.5) / count, width = std::sqrt(1 - height * height);
        const double angle = std::numbers::phi * 2 * std::numbers::pi * k;
        *hull.add_points() = vector_of(radius * width * std::cos(angle), radius * height,
                                       radius * width * std::sin(angle));
    }
}

// The most expensive requests of one player that the limits allow, on a connection of its own.
class QueryFlood {
public:
    enum class Kind { shapes, debug };
    QueryFlood(const std::string& target, Kind kind) {
        grpc::ChannelArguments arguments;
        arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
        stub_ = v1::QueryService::NewStub(
            grpc::CreateCustomChannel(target, grpc::InsecureChannelCredentials(), arguments));
        if (kind == Kind::debug) {
            flood(&v1::QueryService::Stub::Debug, all_layers());
            flood(&v1::QueryService::Stub::Debug, all_layers());
            return;
        }
        flood(&v1::QueryService::Stub::CastRays, rays());
        flood(&v1::QueryService::Stub::CastShapes, sweeps());
        flood(&v1::QueryService::Stub::Overlap, overlap());
        flood(&v1::QueryService::Stub::ClosestPoints, points());
    }

private:
    static v1::CastRaysRequest rays() {
        v1::CastRaysRequest request;
        request.set_world("attacked");
        request.set_mode(v1::HIT_MODE_ALL);
        for (int k = 0; k < 1000; k++) {
            v1::Ray& ray = *request.add_rays();
            *ray.mutable_origin() = vector_of(-500, 0.5, 0.04 * (k - 500));
            *ray.mutable_motion() = vector_of(1000, 0, 0.01 * (k % 100));
        }
        request.mutable_view_time()->set_tick(1);
        return request;
    }
    static v1::CastShapesRequest sweeps() {
        v1::CastShapesRequest request;
        request.set_world("attacked");
        request.set_mode(v1::HIT_MODE_ALL);
        for (int k = 0; k < 100; k++) {
            v1::MovingShape& moving = *request.add_shapes();
            write_hull(*moving.mutable_shape()->mutable_hull(), 1000, 20);
            *moving.mutable_shape()->mutable_position() = vector_of(-500, 10, 0.1 * k);
            *moving.mutable_motion() = vector_of(1000, 0, k);
        }
        return request;
    }
    static v1::OverlapRequest overlap() {
        v1::OverlapRequest request;
        request.set_world("attacked");
        write_hull(*request.mutable_shape()->mutable_hull(), 1000, 500);
        return request;
    }
    static v1::ClosestPointsRequest points() {
        v1::ClosestPointsRequest request;
        request.set_world("attacked");
        request.set_max_distance(1e7);
        for (int k = 0; k < 1000; k++) *request.add_points() = vector_of(k, 1000, 0);
        return request;
    }
    static v1::DebugRequest all_layers() {
        v1::DebugRequest request;
        request.set_world("attacked");
        request.set_contacts(true);
        request.set_islands(true);
        request.set_bounds(true);
        request.set_joints(true);
        request.set_broad_phase(true);
        return request;
    }
    // Sends the request again as soon as it was answered, until the process ends.
    template <class Request, class Response>
    void flood(grpc::Status (v1::QueryService::Stub::*call)(grpc::ClientContext*, const Request&,
                                                            Response*),
               Request request) {
        threads_.emplace_back([this, call, request = std::move(request)] {
            for (;;) {
                grpc::ClientContext context;
                Response response;
                const grpc::Status status = (stub_.get()->*call)(&context, request, &response);
                if (!status.ok()) std::this_thread::sleep_for(1ms);
            }
        });
    }

    std::unique_ptr<v1::QueryService::Stub> stub_;
    std::vector<std::jthread> threads_;
};

class Attacker {
public:
    Attacker(client::Loop& loop, const std::string& target, unsigned seed)
        : target_(target),
          random_(seed),
          client_(client::Client::connect(
              loop, {.target = target, .world = "attacked", .name = "attacker"})) {}

    bool is_connected() const { return client_->stats().connected; }

    void explode(std::uint32_t tick = 0) {
        v1::Input input;
        *input.mutable_explode()->mutable_center() = anywhere(0.5);
        input.mutable_explode()->set_radius(10);
        input.mutable_explode()->set_speed(5);
        input.set_tick(tick);
        client_->send(std::move(input));
    }
    // An impulse on what a ray through the whole world hits in the past.
    void aim() {
        v1::Input input;
        v1::Aim& aim = *input.mutable_impulse()->mutable_aim();
        *aim.mutable_origin() = vector_of(-60, 1, real(-20, 20));
        *aim.mutable_motion() = vector_of(120, 0, real(-10, 10));
        *aim.mutable_view_time() = client_->rendered_time();
        *input.mutable_impulse()->mutable_impulse() = vector_of(0, 0.1, 0);
        client_->send(std::move(input));
    }
    // A hull with 32 vertices onto a heap.
    void spawn_hull() {
        v1::Input input;
        write_hull(*input.mutable_spawn()->mutable_shape()->mutable_hull(), 32, 0.4);
        *input.mutable_spawn()->mutable_position() = anywhere(3 + real(0, 6));
        client_->send(std::move(input));
    }
    void query(QueryFlood::Kind kind) {
        if (!flood_) flood_ = std::make_unique<QueryFlood>(target_, kind);
    }
    std::uint32_t future_tick(int ticks) { return client_->input_tick(Clock::now()) + ticks; }

private:
    double real(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    v1::Vec3 anywhere(double y) { return vector_of(real(-3, 3), y, real(-3, 3)); }

    const std::string target_;
    std::mt19937 random_;
    std::shared_ptr<client::Client> client_;
    std::unique_ptr<QueryFlood> flood_;
};

struct Attack {
    const char* name;
    const char* help;
    int attackers;
    std::function<void(Attacker& attacker, int round)> act;  // 100 rounds a second
};

const std::vector<Attack>& attacks() {
    static const std::vector<Attack> all = {
        {"none", "no attack", 0, [](Attacker&, int) {}},
        {"explosions", "one player, 300 explosions a second", 1,
         [](Attacker& attacker, int) {
             for (int k = 0; k < 3; k++) attacker.explode();
         }},
        {"many-explosions", "eight players, 300 explosions a second each", 8,
         [](Attacker& attacker, int) {
             for (int k = 0; k < 3; k++) attacker.explode();
         }},
        {"one-tick", "twenty players whose explosions name the same ticks", 20,
         [](Attacker& attacker, int round) {
             const std::uint32_t now = attacker.future_tick(0);
             if (now == 0 || round % 2 != 0) return;
             for (int k = 0; k < 6; k++) attacker.explode((now / 60 + 1) * 60);
         }},
        {"aims", "four players, 300 aims at the past a second each", 4,
         [](Attacker& attacker, int) {
             for (int k = 0; k < 3; k++) attacker.aim();
         }},
        {"heap", "64 players with 50 hulls each on a heap", 64,
         [](Attacker& attacker, int round) {
             if (round % 10 == 0) attacker.spawn_hull();
         }},
        {"queries", "four players with four expensive queries in flight each", 4,
         [](Attacker& attacker, int) { attacker.query(QueryFlood::Kind::shapes); }},
        {"debug-layers", "four players that request all debug layers all the time", 4,
         [](Attacker& attacker, int) { attacker.query(QueryFlood::Kind::debug); }},
    };
    return all;
}

const Attack* find_attack(const std::string& name) {
    const auto at = std::ranges::find(
        attacks(), name, [](const Attack& attack) { return std::string(attack.name); });
    return at == attacks().end() ? nullptr : &*at;
}

[[noreturn]] void attack_until_killed(const Attack& attack, const std::string& target) {
    setpriority(PRIO_PROCESS, 0, 10);
    client::Loop loop;
    std::vector<std::unique_ptr<Attacker>> attackers;
    for (int k = 0; k < attack.attackers; k++)
        attackers.push_back(std::make_unique<Attacker>(loop, target, static_cast<unsigned>(k)));
    auto next = Clock::now();
    for (int round = 0;; round++) {
        for (const auto& attacker : attackers)
            if (attacker->is_connected()) attack.act(*attacker, round);
        std::this_thread::sleep_until(next += 10ms);
    }
}

// ---- honest players ----

class Honest {
public:
    Honest(client::Loop& loop, const std::string& target, const std::string& world)
        : client_(client::Client::connect(loop,
                                          {.target = target, .world = world, .name = "honest"})) {}

    bool is_connected() const { return client_->stats().connected; }
    // Once a second: the snapshots of the second, and one input.
    void end_second(bool counts) {
        const std::uint64_t now = client_->stats().snapshots;
        if (counts) seconds_.push_back(static_cast<int>(now - before_));
        before_ = now;
        v1::Input input;
        input.mutable_impulse()->set_entity(2);
        *input.mutable_impulse()->mutable_impulse() = vector_of(0, 0.01, 0);
        client_->send(std::move(input));
        if (counts) sent_++;
        for (const v1::InputResult& result : client_->take_results())
            if (counts && result.code() != v1::INPUT_CODE_LIMIT) applied_++;
    }
    double mean() const {
        double sum = 0;
        for (const int second : seconds_) sum += second;
        return sum / std::max<double>(1, static_cast<double>(seconds_.size()));
    }
    int worst() const { return seconds_.empty() ? 0 : *std::ranges::min_element(seconds_); }
    int sent() const { return sent_; }
    int applied() const { return applied_; }

private:
    std::shared_ptr<client::Client> client_;
    std::uint64_t before_ = 0;
    std::vector<int> seconds_;
    int sent_ = 0, applied_ = 0;
};

struct Plan {
    std::vector<std::string> only;
    std::string scene = "sandbox", server = JOSTLE_SERVER;
    std::vector<std::string> settings;
    int seconds = 20;
    bool verbose = false;
};

// Whether the honest players were served.
bool run(const Attack& attack, const Plan& plan) {
    std::vector<std::string> flags{"--listen",    "127.0.0.1:0",   "--http",
                                   "127.0.0.1:0", "--scene",       "attacked=" + plan.scene,
                                   "--scene",     "other=sandbox", "--log-level",
                                   "warn"};
    for (const std::string& setting : plan.settings) {
        flags.emplace_back("--set");
        flags.push_back(setting);
    }
    bench::ServerProcess server(plan.server, flags, true);
    if (!server.is_running()) {
        std::fprintf(stderr, "fairness-check: the server did not start: %s\n",
                     server.log().c_str());
        return false;
    }
    const std::string target = server.grpc_address();
    const pid_t attackers = attack.attackers > 0 ? fork() : 0;
    if (attack.attackers > 0 && attackers == 0) {
        // A new program, because gRPC does not support fork().
        execl("/proc/self/exe", "fairness-check", "--attack", attack.name, "--target",
              target.c_str(), nullptr);
        _exit(127);
    }
    bool ok = true;
    {
        client::Loop loop;
        std::vector<std::unique_ptr<Honest>> here;
        for (const char* world : {"attacked", "attacked", "other"})
            here.push_back(std::make_unique<Honest>(loop, target, world));
        auto next = Clock::now();
        constexpr int warm_up = 3;
        for (int second = 0; second < warm_up + plan.seconds; second++) {
            std::this_thread::sleep_until(next += 1s);
            for (const auto& honest : here) honest->end_second(second >= warm_up);
        }
        const double same = std::min(here[0]->mean(), here[1]->mean());
        const int worst = std::min(here[0]->worst(), here[1]->worst());
        const double other = here[2]->mean();
        ok = same >= 50 && other >= 58;
        std::printf("%-16s %6.1f %5d   %6.1f %5d   %3d of %-3d  %6.2f  %s\n", attack.name, same,
                    worst, other, here[2]->worst(), here[0]->applied() + here[1]->applied(),
                    here[0]->sent() + here[1]->sent(),
                    server.cpu_seconds() / (warm_up + plan.seconds), ok ? "holds" : "FAILS");
        std::fflush(stdout);
    }
    if (attackers > 0) {
        kill(attackers, SIGKILL);
        waitpid(attackers, nullptr, 0);
    }
    if (plan.verbose) std::fputs(server.log().c_str(), stderr);
    server.signal(SIGTERM);
    const auto status = server.wait(20s);
    if (!status || *status != 0) {
        std::printf("%-16s the server did not exit with status 0\n", attack.name);
        return false;
    }
    return ok;
}

}  // namespace
}  // namespace jostle

int main(int argc, char** argv) {
    CLI::App app{
        "Attack a world with the inputs and queries that the default limits allow, and count the "
        "snapshots "
        "that honest\n"
        "players receive: at least 50 a second in the same world, and 58 in another one."};
    jostle::Plan plan;
    std::string names;
    for (const jostle::Attack& attack : jostle::attacks())
        names += std::string("\n  ") + attack.name + ": " + attack.help;
    app.add_option("--only", plan.only, "Run these attacks [default: all]:" + names)
        ->type_name("NAME");
    app.add_option("--server", plan.server, "Test this server")->type_name("BINARY");
    app.add_option("--scene", plan.scene, "Scene of the attacked world [default: sandbox]");
    app.add_option("--seconds", plan.seconds, "Measure for this time [default: 20]");
    app.add_option("--set", plan.settings, "Override a setting of the server; repeatable");
    app.add_flag("--verbose", plan.verbose, "Print the log of the server");
    std::string attack, target;
    app.add_option("--attack", attack)->group("");  // runs the attackers only
    app.add_option("--target", target)->group("");
    CLI11_PARSE(app, argc, argv);
    if (const jostle::Attack* const chosen = jostle::find_attack(attack))
        jostle::attack_until_killed(*chosen, target);
    std::printf("%-16s %12s   %12s   %10s  %6s\n", "snapshots/s", "same world", "other world",
                "inputs", "CPUs");
    bool ok = true;
    for (const jostle::Attack& attack : jostle::attacks())
        if (plan.only.empty() || std::ranges::find(plan.only, attack.name) != plan.only.end())
            ok = jostle::run(attack, plan) && ok;
    return ok ? 0 : 1;
}
