// SPDX-License-Identifier: MIT
//
// Kills a server again and again while bots play, and then reads its store: each input that a bot
// was told of must be there, none twice, and the world must be what it would have been without a
// single kill.
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

// Which input of which client.
using Numbered = std::pair<std::uint32_t, std::uint32_t>;

// One player: throws balls, pushes things and deletes them, and writes down what it is told.
class Bot {
public:
    Bot(client::Loop& loop, const std::string& target, unsigned seed)
        : random_(seed),
          client_(client::Client::connect(loop, {.target = target, .name = "killed"})) {}

    void play() {
        const client::ClientStats stats = client_->stats();
        if (stats.connected && stats.client_id != id_) {
            if (id_ != 0) strangers_++;
            id_ = stats.client_id;
        }
        for (const v1::InputResult& result : client_->take_results()) {
            if (result.code() == v1::INPUT_CODE_UNAVAILABLE)
                refused_++;
            else
                told_.emplace(id_, result.sequence());
        }
        if (random_() % 4 != 0) return;
        client_->send(any_input());
    }
    bool was_acknowledged() const { return !told_.empty(); }
    bool is_connected() const { return client_->stats().connected; }
    const std::set<Numbered>& told() const { return told_; }
    int strangers() const { return strangers_; }
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
    std::set<Numbered> told_;
    int strangers_ = 0, refused_ = 0;
};

// What the store says in the end.
struct Findings {
    std::size_t told = 0, kept = 0, lost = 0, twice = 0, left = 0;
    int checkpoints = 0, other_hashes = 0;
    std::uint32_t ticks = 0;
    bool same_end = false;
    std::vector<std::string> remarks;

    bool good() const {
        return lost == 0 && twice == 0 && left == 0 && other_hashes == 0 && same_end &&
               remarks.empty();
    }
};

// How often each input is there; counts clients who left, too: none did.
std::map<Numbered, int> inputs_in(server::WorldStorage& store, const std::string& world,
                                  std::size_t& left) {
    std::map<Numbered, int> kept;
    for (std::uint64_t after = 0;;) {
        const auto entries = store.entries(world, after, 8 << 20).value();
        if (entries.empty()) return kept;
        for (const server::JournalEntry& entry : entries) {
            const std::string data = server::decompress(entry.data, 1 << 28).value();
            const server::JournalSegment batch = server::decode_journal(data).value();
            for (const server::JournaledTick& tick : batch.ticks)
                for (const server::JournaledCommand& command : tick.commands) {
                    if (command.sequence != 0) kept[{command.client, command.sequence}]++;
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
    const std::map<Numbered, int> kept = inputs_in(*store, stored.id, found.left);
    found.kept = kept.size();
    for (const auto& [input, times] : kept) found.twice += times > 1 ? 1 : 0;
    for (const auto& bot : bots) {
        found.told += bot->told().size();
        for (const Numbered& input : bot->told())
            if (!kept.contains(input)) {
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
    found.remarks = whole.remarks;
    return found;
}

class Check {
public:
    explicit Check(const Plan& plan) : plan_(plan), random_(plan.seed) {}

    int run() {
        for (int tries = 0; tries < 20 && (!server_ || !server_->is_running()); tries++) {
            // Below those that the system gives to who connects: to a server that is away, one of
            // these would be connected with itself.
            port_ = static_cast<int>(20000 + random_() % 10000);
            start(port_, true);
        }
        const std::string target = "127.0.0.1:" + std::to_string(port_);
        for (int k = 0; k < plan_.bots; k++)
            bots_.push_back(
                std::make_unique<Bot>(loop_, target, plan_.seed * 1000 + static_cast<unsigned>(k)));
        if (!play_until(20s,
                        [&] { return all([](const Bot& bot) { return bot.was_acknowledged(); }); }))
            return fail("not every bot could play at first");
        for (int kill = 1; kill <= plan_.kills; kill++) {
            // Every fourth time while it may still be busy with what the kill before left.
            const bool early = random_() % 4 == 0;
            play_for(std::chrono::milliseconds(early ? random_() % 120 : 300 + random_() % 900));
            if (plan_.rewinds && !rewind()) return fail("the world was not taken back");
            server_->signal(plan_.gently ? SIGTERM : SIGKILL);
            if (!play_until(20s, [&] { return !server_->is_running(); }))
                return fail("the server was ended and runs on");
            start(port_);
            if (!server_->is_running()) return fail("the server did not come back");
            if (isatty(fileno(stderr)) || kill % 20 == 0)
                std::fprintf(stderr, "%d of %d kills\n", kill, plan_.kills);
        }
        if (!play_until(30s, [&] { return all([](const Bot& b) { return b.is_connected(); }); }))
            return fail("not every bot came back in the end: " + errors());
        play_for(2s);
        server_->signal(SIGTERM);
        const auto status = server_->wait(20s);
        if (!status || *status != 0) return fail("the server did not end in order");
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
    // To any tick that is kept; bots play on meanwhile. Half of the times the server is killed
    // before they are all back.
    bool rewind() {
        const auto channel = grpc::CreateChannel("127.0.0.1:" + std::to_string(port_),
                                                 grpc::InsecureChannelCredentials());
        const auto ask = [](auto&& call) {
            grpc::ClientContext context;
            context.set_wait_for_ready(true);
            context.set_deadline(std::chrono::system_clock::now() + 20s);
            return call(context);
        };
        v1::ListWorldsResponse worlds;
        if (!ask([&](grpc::ClientContext& context) {
                 return v1::WorldService::NewStub(channel)->ListWorlds(&context, {}, &worlds);
             }).ok())
            return false;
        const v1::WorldInfo& world = worlds.worlds(0);
        // What nobody did anything in may be kept only a second later.
        const std::uint32_t last =
            std::max(world.oldest_restorable_tick(), std::max(world.tick(), 90u) - 90);
        v1::RewindWorldRequest request;
        request.set_world(world.id());
        request.set_tick(world.oldest_restorable_tick() +
                         static_cast<std::uint32_t>(random_()) %
                             (last - world.oldest_restorable_tick() + 1));
        grpc::Status status;
        std::atomic<bool> answered = false;
        std::jthread asker([&] {
            v1::RewindWorldResponse response;
            status = ask([&](grpc::ClientContext& context) {
                return v1::AdminService::NewStub(channel)->RewindWorld(&context, request,
                                                                       &response);
            });
            answered = true;
        });
        play_until(25s, [&] { return answered.load(); });
        asker.join();
        if (!status.ok())
            std::fprintf(stderr, "to tick %u of %u to %u: %s\n", request.tick(),
                         world.oldest_restorable_tick(), world.tick(),
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
        int strangers = 0, refused = 0;
        std::uint64_t resumed = 0;
        for (const auto& bot : bots_) {
            strangers += bot->strangers();
            refused += bot->refused();
            resumed += bot->resumed();
        }
        for (const std::string& remark : found.remarks) std::printf("%s\n", remark.c_str());
        std::printf(
            "%d kills, %d bots, %u ticks, %d checkpoints\n"
            "inputs told of %zu, kept %zu, lost %zu, applied twice %zu, refused for want "
            "of a store %d\n"
            "came back as who they were %llu times, as somebody else %d, were taken for gone %zu\n"
            "an uninterrupted replay: %d checkpoints of another hash, the end is %s\n",
            plan_.kills, plan_.bots, found.ticks, found.checkpoints, found.told, found.kept,
            found.lost, found.twice, refused, static_cast<unsigned long long>(resumed), strangers,
            found.left, found.other_hashes, found.same_end ? "the same" : "ANOTHER");
        const bool good = found.good() && strangers == 0;
        std::printf("%s\n", good ? "nothing that was accepted is lost" : "FAILED");
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
        "Kills a server time and again while bots play; nothing that was accepted may be "
        "lost.\nExit status: 0 nothing was, 1 something was, 2 wrong flags.");
    jostle::Plan plan;
    app.add_option("--kills", plan.kills, "How often")->check(CLI::Range(0, 100000));
    app.add_option("--bots", plan.bots, "How many play")->check(CLI::Range(1, 1000));
    app.add_option("--seed", plan.seed, "Of the instants, and of what bots do");
    app.add_option("--scene", plan.scene, "Where they play");
    app.add_option("--level", plan.level, "persistence.durability: process or machine");
    app.add_option("--set", plan.settings, "KEY=VALUE, another setting of the server");
    app.add_flag("--gently", plan.gently, "Ends it in order (SIGTERM) instead: an upgrade");
    app.add_flag("--rewind", plan.rewinds, "Before each kill an operator takes the world back");
    app.add_flag("--verbose", plan.verbose, "The server's log, too");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    return jostle::Check(plan).run();
}
