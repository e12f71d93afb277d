// SPDX-License-Identifier: MIT
//
// Kills a server repeatedly while bots play, and then reads its database: each input with a result
// must be stored exactly once, and the world must equal the world of an uninterrupted replay.
#include <grpcpp/create_channel.h>

#include <CLI/CLI.hpp>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <thread>
#include <vector>

#include "bench/processes/server_process.h"
#include "jostle/client/client.h"
#include "jostle/physics/serialization.h"
#include "jostle/v1/admin.grpc.pb.h"
#include "jostle/v1/world.grpc.pb.h"
#include "server/recovery/recover_world.h"
#include "server/storage/compression.h"
#include "server/storage/sqlite_storage.h"

namespace jostle {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

struct Plan {
    int kills = 200, bots = 20;
    unsigned seed = 1;
    std::string scene = "sandbox", level = "process";
    std::vector<std::string> settings;
    bool gently = false, rewinds = false, verbose = false;
};

// Client id and input sequence.
using InputId = std::pair<std::uint32_t, std::uint32_t>;

// One player: throws balls, pushes and deletes bodies, and records the results of its inputs.
class Bot {
public:
    Bot(client::Loop& loop, const std::string& target, unsigned seed)
        : random_(seed),
          client_(client::Client::connect(loop, {.target = target, .name = "killed"})) {}

    void play() {
        const client::ClientStats stats = client_->stats();
        if (stats.connected && stats.client_id != id_) {
            if (id_ != 0) new_sessions_++;
            id_ = stats.client_id;
        }
        for (const v1::InputResult& result : client_->take_results()) {
            if (result.code() == v1::INPUT_CODE_UNAVAILABLE)
                refused_++;
            else
                results_.emplace(id_, result.sequence());
        }
        if (random_() % 4 != 0) return;
        client_->send(any_input());
    }
    bool was_acknowledged() const { return !results_.empty(); }
    bool is_connected() const { return client_->stats().connected; }
    const std::set<InputId>& results() const { return results_; }
    int new_sessions() const { return new_sessions_; }
    int refused() const { return refused_; }
    std::uint64_t resumed() const { return client_->stats().resumed; }
    std::string last_error() const { return client_->stats().last_error; }

private:
    double real(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    v1::Input any_input() {
        v1::Input input;
        const auto kind = random_() % 10;
        const auto entity = static_cast<std::uint32_t>(1 + random_() % 300);
        if (kind < 4) {
            auto& spawn = *input.mutable_spawn();
            spawn.mutable_shape()->mutable_sphere()->set_radius(real(0.1, 0.4));
            auto& at = *spawn.mutable_position();
            at.set_x(real(-5, 5)), at.set_y(real(3, 9)), at.set_z(real(-5, 5));
        } else if (kind < 8) {
            auto& impulse = *input.mutable_impulse();
            impulse.set_entity(entity);
            impulse.mutable_impulse()->set_y(real(0, 5));
            impulse.mutable_impulse()->set_x(real(-3, 3));
        } else {
            input.mutable_delete_()->set_entity(entity);
        }
        return input;
    }

    std::mt19937 random_;
    std::shared_ptr<client::Client> client_;
    std::uint32_t id_ = 0;
    std::set<InputId> results_;
    int new_sessions_ = 0, refused_ = 0;
};

// Results of the check of the database.
struct Findings {
    std::size_t results = 0, stored_inputs = 0, lost = 0, twice = 0, left = 0;
    int checkpoints = 0, other_hashes = 0;
    std::uint32_t ticks = 0;
    bool same_end = false;
    std::vector<std::string> warnings;

    bool good() const {
        return lost == 0 && twice == 0 && left == 0 && other_hashes == 0 && same_end &&
               warnings.empty();
    }
};

// Counts how often each input is stored, and the clients that left; no client leaves.
std::map<InputId, int> inputs_in(server::WorldStorage& store, const std::string& world,
                                 std::size_t& left) {
    std::map<InputId, int> stored_inputs;
    for (std::uint64_t after = 0;;) {
        const auto entries = store.entries(world, after, 8 << 20).value();
        if (entries.empty()) return stored_inputs;
        for (const server::JournalEntry& entry : entries) {
            const std::string data = server::decompress(entry.data, 1 << 28).value();
            const server::JournalSegment batch = server::decode_journal(data).value();
            for (const server::JournaledTick& tick : batch.ticks)
                for (const server::JournaledCommand& command : tick.commands) {
                    if (command.sequence != 0) stored_inputs[{command.client, command.sequence}]++;
                    if (command.action &&
                        std::holds_alternative<server::LeaveCommand>(*command.action))
                        left++;
                }
        }
        after = entries.back().sequence;
    }
}

Findings read_store(const std::string& path, const std::vector<std::unique_ptr<Bot>>& bots) {
    Findings found;
    const auto store = server::SqliteStorage::open(path, {}).value();
    const server::StoredWorld stored = store->worlds().value().at(0);
    const auto record = server::decode_world_definition(stored.settings).value();
    const std::map<InputId, int> stored_inputs = inputs_in(*store, stored.id, found.left);
    found.stored_inputs = stored_inputs.size();
    for (const auto& [input, times] : stored_inputs) found.twice += times > 1 ? 1 : 0;
    for (const auto& bot : bots) {
        found.results += bot->results().size();
        for (const InputId& input : bot->results())
            if (!stored_inputs.contains(input)) {
                found.lost++;
                std::printf("lost: input %u of client %u\n", input.second, input.first);
            }
    }
    const auto ticks = store->checkpoint_ticks(stored.id).value();
    std::map<std::uint32_t, std::uint64_t> hashes;
    for (const std::uint32_t tick : ticks)
        hashes[tick] = store->checkpoint(stored.id, tick).value().hash;
    found.checkpoints = static_cast<int>(ticks.size());
    const auto newest = server::recover_world(*store, stored, record, {}).value();
    const auto whole =
        server::recover_world(
            *store, stored, record,
            {.checkpoint = ticks.back(),
             .after_tick =
                 [&](const server::HostedWorld& world, std::uint32_t tick) {
                     const auto at = hashes.find(tick);
                     if (at != hashes.end() && physics::state_hash(world.world()) != at->second)
                         found.other_hashes++;
                 }})
            .value();
    found.ticks = whole.tick - ticks.back();
    found.same_end = whole.tick == newest.tick && physics::state_hash(whole.world.world()) ==
                                                      physics::state_hash(newest.world.world());
    found.warnings = whole.warnings;
    return found;
}

class Check {
public:
    explicit Check(const Plan& plan) : plan_(plan), random_(plan.seed) {}

    int run() {
        for (int tries = 0; tries < 20 && (!server_ || !server_->is_running()); tries++) {
            // Ports below the ephemeral range: while the server is down, a client that connects to
            // an ephemeral port can connect to itself.
            port_ = static_cast<int>(20000 + random_() % 10000);
            start(port_, true);
        }
        const std::string target = "127.0.0.1:" + std::to_string(port_);
        for (int k = 0; k < plan_.bots; k++)
            bots_.push_back(
                std::make_unique<Bot>(loop_, target, plan_.seed * 1000 + static_cast<unsigned>(k)));
        if (!play_until(20s,
                        [&] { return all([](const Bot& bot) { return bot.was_acknowledged(); }); }))
            return fail("not every bot received a result within 20 s");
        for (int kill = 1; kill <= plan_.kills; kill++) {
            // Every fourth kill comes early, while the server may still recover from the previous
            // kill.
            const bool early = random_() % 4 == 0;
            play_for(std::chrono::milliseconds(early ? random_() % 120 : 300 + random_() % 900));
            if (plan_.rewinds && !rewind()) return fail("the rewind failed");
            server_->signal(plan_.gently ? SIGTERM : SIGKILL);
            if (!play_until(20s, [&] { return !server_->is_running(); }))
                return fail("the server is still running after the signal");
            start(port_);
            if (!server_->is_running()) return fail("the server did not restart");
            if (isatty(fileno(stderr)) || kill % 20 == 0)
                std::fprintf(stderr, "%d of %d kills\n", kill, plan_.kills);
        }
        if (!play_until(30s, [&] { return all([](const Bot& b) { return b.is_connected(); }); }))
            return fail("not every bot reconnected within 30 s: " + errors());
        play_for(2s);
        server_->signal(SIGTERM);
        const auto status = server_->wait(20s);
        if (!status || *status != 0)
            return fail("the server did not exit with status 0 within 20 s");
        return report(read_store(store(), bots_));
    }

private:
    std::string store() const { return folder_.path + "/worlds.db"; }

    void start(int port, bool wait = false) {
        std::vector<std::string> flags{"--listen", "127.0.0.1:" + std::to_string(port),
                                       "--http",   "127.0.0.1:0",
                                       "--scene",  plan_.scene,
                                       "--set",    "persistence.database=" + store(),
                                       "--set",    "persistence.durability=" + plan_.level,
                                       "--set",    "persistence.history_retention_hours=1000",
                                       "--set",    "persistence.replay_seconds_max=0.5",
                                       "--set",    "client.bodies_owned_max=8",
                                       "--set",    "drain_timeout_seconds=1"};
        for (const std::string& setting : plan_.settings) {
            flags.emplace_back("--set");
            flags.push_back(setting);
        }
        server_.reset();
        server_ = std::make_unique<bench::ServerProcess>(JOSTLE_SERVER, flags, wait);
        if (plan_.verbose) std::fputs(server_->log().c_str(), stderr);
    }
    // Rewinds to a random retained tick while the bots play. In half of the cases the server is
    // killed before all bots have reconnected.
    bool rewind() {
        const auto channel = grpc::CreateChannel("127.0.0.1:" + std::to_string(port_),
                                                 grpc::InsecureChannelCredentials());
        const auto call_with_deadline = [](auto&& call) {
            grpc::ClientContext context;
            context.set_wait_for_ready(true);
            context.set_deadline(std::chrono::system_clock::now() + 20s);
            return call(context);
        };
        v1::ListWorldsResponse worlds;
        if (!call_with_deadline([&](grpc::ClientContext& context) {
                 return v1::WorldService::NewStub(channel)->ListWorlds(&context, {}, &worlds);
             }).ok())
            return false;
        const v1::WorldInfo& world = worlds.worlds(0);
        // A tick without inputs may be persisted up to one second later.
        const std::uint32_t last =
            std::max(world.oldest_restorable_tick(), std::max(world.tick(), 90u) - 90);
        v1::RewindWorldRequest request;
        request.set_world(world.id());
        request.set_tick(world.oldest_restorable_tick() +
                         static_cast<std::uint32_t>(random_()) %
                             (last - world.oldest_restorable_tick() + 1));
        grpc::Status status;
        std::atomic<bool> answered = false;
        std::jthread rewinder([&] {
            v1::RewindWorldResponse response;
            status = call_with_deadline([&](grpc::ClientContext& context) {
                return v1::AdminService::NewStub(channel)->RewindWorld(&context, request,
                                                                       &response);
            });
            answered = true;
        });
        play_until(25s, [&] { return answered.load(); });
        rewinder.join();
        if (!status.ok())
            std::fprintf(stderr, "rewind to tick %u failed (retained: %u to %u): %s\n",
                         request.tick(), world.oldest_restorable_tick(), world.tick(),
                         status.error_message().c_str());
        if (random_() % 2 == 0)
            play_until(20s, [&] { return all([](const Bot& b) { return b.is_connected(); }); });
        return status.ok();
    }
    template <class Predicate>
    bool all(Predicate&& holds) const {
        for (const auto& bot : bots_)
            if (!holds(*bot)) return false;
        return true;
    }
    std::string errors() const {
        std::set<std::string> all;
        for (const auto& bot : bots_)
            if (!bot->is_connected()) all.insert(bot->last_error());
        std::string text;
        for (const std::string& error : all) text += error + "; ";
        return text;
    }
    template <class Predicate>
    bool play_until(Clock::duration patience, Predicate&& done) {
        for (const auto end = Clock::now() + patience; Clock::now() < end;) {
            for (const auto& bot : bots_) bot->play();
            if (done()) return true;
            std::this_thread::sleep_for(20ms);
        }
        return false;
    }
    void play_for(Clock::duration time) {
        play_until(time, [] { return false; });
    }
    int fail(const std::string& why) {
        std::fprintf(stderr, "kill-check: %s\n%s", why.c_str(), server_->log().c_str());
        return 1;
    }
    int report(const Findings& found) {
        int new_sessions = 0, refused = 0;
        std::uint64_t resumed = 0;
        for (const auto& bot : bots_) {
            new_sessions += bot->new_sessions();
            refused += bot->refused();
            resumed += bot->resumed();
        }
        for (const std::string& warning : found.warnings) std::printf("%s\n", warning.c_str());
        std::printf(
            "%d kills, %d bots, %u ticks, %d checkpoints\n"
            "inputs with a result %zu, stored %zu, lost %zu, stored twice %zu, rejected by a "
            "failed database %d\n"
            "bots resumed %llu times, reconnected as a new client %d times, left %zu times\n"
            "uninterrupted replay: %d checkpoints with another hash, the final state is %s\n",
            plan_.kills, plan_.bots, found.ticks, found.checkpoints, found.results,
            found.stored_inputs, found.lost, found.twice, refused,
            static_cast<unsigned long long>(resumed), new_sessions, found.left, found.other_hashes,
            found.same_end ? "equal" : "DIFFERENT");
        const bool good = found.good() && new_sessions == 0;
        std::printf("%s\n", good ? "no input was lost" : "FAILED");
        return good ? 0 : 1;
    }

    const Plan plan_;
    std::mt19937 random_;
    bench::TemporaryFolder folder_;
    client::Loop loop_;
    std::vector<std::unique_ptr<Bot>> bots_;
    std::unique_ptr<bench::ServerProcess> server_;
    int port_ = 0;
};

}  // namespace
}  // namespace jostle

int main(int argc, char** argv) {
    CLI::App app(
        "Kill a server repeatedly while bots play; no input with a result may be lost.\n"
        "Exit status: 0 no input was lost, 1 the check failed, 2 invalid flags.");
    jostle::Plan plan;
    app.add_option("--kills", plan.kills, "Number of kills")->check(CLI::Range(0, 100000));
    app.add_option("--bots", plan.bots, "Number of bots")->check(CLI::Range(1, 1000));
    app.add_option("--seed", plan.seed, "Seed of the kill times and of the inputs");
    app.add_option("--scene", plan.scene, "Scene of the world");
    app.add_option("--level", plan.level, "persistence.durability: process or machine");
    app.add_option("--set", plan.settings, "Additional setting of the server (KEY=VALUE)");
    app.add_flag("--gently", plan.gently, "Stop the server with SIGTERM instead, as in an upgrade");
    app.add_flag("--rewind", plan.rewinds, "Rewind the world before each kill");
    app.add_flag("--verbose", plan.verbose, "Print the log of the server");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    return jostle::Check(plan).run();
}
