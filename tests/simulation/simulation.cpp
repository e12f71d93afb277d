// SPDX-License-Identifier: MIT
#include "tests/simulation/simulation.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "tests/support/small_scene.h"

namespace jostle::simulation {

namespace {

using namespace std::chrono_literals;

constexpr double hz = 60;
constexpr std::size_t frames_retained = 900;  // 15 s: longer than any delay of a connection
constexpr std::uint64_t cycle = 20'000;       // ticks; then all clients leave

scenes::SceneDescription scene() {
    scenes::SceneDescription small = test::small_scene();
    small.hz = hz;
    small.world.substeps = 2;
    return small;
}

server::Config small_config() {
    server::Config config;
    config.world.worlds_max = 2;
    config.world.bodies_max = 60;
    config.client.bodies_owned_max = 4;
    config.auth.anonymous_role = "player";
    config.auth.audit_log = "/dev/null";
    // quotas use the real clock
    for (double* rate : {&config.quota.creates_per_minute, &config.quota.joins_per_minute,
                         &config.quota.queries_per_second})
        *rate = 1e9;
    config.quota.query_share = 0;  // depends on measured times
    return config;
}

}  // namespace

// A server process, from start to end.
struct Simulation::Server {
    explicit Server(server::Authorizer& opened) : authorizer(opened) {
        world = worlds.create("", scene()).value();
    }

    const server::Config config = small_config();
    server::Authorizer& authorizer;
    server::SessionDirectory sessions{5};
    server::WorldDirectory worlds{
        {.limits = {.scene = {.bodies_max = config.world.bodies_max, .first_step_seconds_max = 100},
                    .bodies_owned_max = config.client.bodies_owned_max},
         .command_queue_max = 512,
         .own_ticks = false},
        config.world.worlds_max};
    std::shared_ptr<server::WorldHost> world;
    server::PlayContext context{
        .config = config, .worlds = worlds, .sessions = sessions, .authorizer = authorizer};
};

Simulation::Simulation(std::uint64_t seed) : chance_(seed) {
    start_server();
    for (ClientSlot& slot : slots_)
        slot.again = now_ + std::chrono::milliseconds(chance_.below(3000));
    hostile_again_ = now_;
}

Simulation::~Simulation() {
    hostile_.reset();
    for (ClientSlot& slot : slots_) slot.client.reset();
    lines_.clear();
}

void Simulation::fail(const std::string& what) {
    if (failure_.empty()) failure_ = "tick " + std::to_string(ticks_) + ": " + what;
}

void Simulation::start_server() {
    // Its log has a thread, so all servers share one.
    static const std::unique_ptr<server::Authorizer> authorizer =
        server::Authorizer::open(small_config()).value();
    lines_.clear();
    frames_.clear();
    server_.reset();
    server_ = std::make_unique<Server>(*authorizer);
}

void Simulation::run(std::uint64_t ticks) {
    for (const std::uint64_t end = ticks_ + ticks; ticks_ < end && failure_.empty();) tick();
}

void Simulation::tick() {
    ticks_++;
    now_ += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / hz));
    faults();
    server_->world->tick(now_);
    server::remove_expired_clients(server_->context, now_);
    frames_.push_back(server_->world->frame());
    if (frames_.size() > frames_retained) frames_.pop_front();
    serve_lines();
    for (ClientSlot& slot : slots_) act_honest(slot);
    act_hostile();
    serve_lines();
    if (ticks_ % cycle == 0) emptying_ = true;
    if (emptying_) end_cycle();
}

server::FramePtr Simulation::frame_of(std::uint32_t tick) const {
    const auto found = std::ranges::find_if(
        frames_, [&](const server::FramePtr& frame) { return frame->tick == tick; });
    return found == frames_.end() ? nullptr : *found;
}

// ---- faults ----

void Simulation::faults() {
    if (chance_.one_in(5'000)) pause_machine();
    if (chance_.one_in(6'000) && resume_at_ == Clock::time_point{}) {
        tally_.faults++;
        server_->world->pause("a fault of the simulation");
        resume_at_ = now_ + std::chrono::milliseconds(chance_.below(4000));
    }
    if (resume_at_ != Clock::time_point{} && now_ >= resume_at_) {
        server_->world->resume();
        resume_at_ = {};
    }
    if (chance_.one_in(30'000)) {
        // The world is deleted while clients play, and a new world of the same scene replaces it.
        tally_.faults++;
        server_->worlds.remove(server_->world->id());
        server_->world = server_->worlds.create("", scene()).value();
        frames_.clear();
        resume_at_ = {};
    }
    if (chance_.one_in(40'000)) {
        tally_.faults++;
        server_->context.draining = true;
        restart_at_ = now_ + 3s;
    }
    if (restart_at_ != Clock::time_point{} && now_ >= restart_at_) {
        // Connected clients are notified, then the process ends.
        server_->context.closing = true;
        serve_lines();
        for (const auto& line : lines_) line->close_by_client(now_);
        restart_at_ = resume_at_ = {};
        start_server();
    }
}

// Simulates SIGSTOP or the migration of a virtual machine: the clock advances while the server is
// suspended.
void Simulation::pause_machine() {
    tally_.faults++;
    now_ += std::chrono::milliseconds(600 + chance_.below(15'000));
}

// ---- clients ----

std::shared_ptr<NetworkLine> Simulation::new_line(const std::string& name, bool is_honest) {
    const auto latency_ms = static_cast<double>(1 + chance_.below(80));
    LineSettings settings{.conditions = {.latency_ms = latency_ms, .jitter_ms = latency_ms}};
    if (chance_.one_in(3)) settings.messages_to_break = 500;
    const std::string address =
        (is_honest ? "192.0.2." : "198.51.100.") + std::to_string(1 + chance_.below(200));
    lines_.push_back(std::make_shared<NetworkLine>(server_->context,
                                                   name + " " + std::to_string(++lines_made_),
                                                   address, settings, chance_.bits(), now_));
    return lines_.back();
}

void Simulation::serve_lines() {
    for (const auto& line : lines_) line->serve(now_);
    std::erase_if(lines_, [](const auto& line) { return line->is_closed(); });
}

void Simulation::act_honest(ClientSlot& slot) {
    if (!slot.client) {
        if (emptying_ || now_ < slot.again) return;
        slot.client = std::make_unique<HonestClient>(
            "honest", chance_.bits(), tally_, [this](const std::string& what) { fail(what); });
    }
    HonestClient& client = *slot.client;
    if (!client.is_connected()) {
        if (client.has_left()) {
            slot.client.reset();
            slot.again = now_ + std::chrono::milliseconds(chance_.below(8000));
            return;
        }
        if (now_ < slot.again) return;
        client.connect(new_line("honest", true), now_);
    }
    if (emptying_ || chance_.one_in(2'000)) client.leave();
    client.act(now_, [this](std::uint32_t tick) { return frame_of(tick); });
    if (!client.is_connected()) slot.again = now_ + std::chrono::milliseconds(chance_.below(2000));
}

void Simulation::act_hostile() {
    if (hostile_ && hostile_->is_connected()) {
        hostile_->act(now_);
        return;
    }
    if (emptying_ || now_ < hostile_again_) return;
    hostile_ = std::make_unique<HostileClient>(chance_.bits(), tally_);
    hostile_->connect(new_line("hostile", false));
    hostile_again_ = now_ + std::chrono::milliseconds(chance_.below(1500));
}

// ---- requirements when no client is connected ----

bool Simulation::all_clients_left() const {
    return server_->context.resume_registry.disconnected() == 0 &&
           (!hostile_ || !hostile_->is_connected()) &&
           std::ranges::all_of(slots_, [](const ClientSlot& slot) { return !slot.client; });
}

void Simulation::end_cycle() {
    if (ticks_ % cycle == static_cast<std::uint64_t>(60 * 60))
        fail("a client did not leave in time");
    if (!all_clients_left() || !lines_.empty() || restart_at_ != Clock::time_point{} ||
        resume_at_ != Clock::time_point{})
        return;
    // The world processes the departures in its next tick.
    server_->world->tick(now_);
    check_no_leaks();
    frames_.clear();
    emptying_ = false;
}

void Simulation::check_no_leaks() {
    if (server_->sessions.clients() != 0)
        fail(std::to_string(server_->sessions.clients()) +
             " clients are still counted after all left");
    if (const auto clients = server_->context.connected_clients.status(now_); !clients.empty())
        fail("client " + std::to_string(clients.front().who.id) + " is still listed after it left");
    for (const auto& entity : *server_->world->frame()->entity_list)
        if (entity->owner != 0)
            fail("entity " + std::to_string(entity->id) + " of client " +
                 std::to_string(entity->owner) + " still exists after the client left");
}

std::uint64_t Simulation::fingerprint() const {
    std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
    const auto add = [&](std::uint64_t value) { hash = (hash ^ value) * 0x100000001b3; };
    const server::FramePtr frame = server_->world->frame();
    add(frame->tick);
    for (const server::EntityPose& entity : frame->entities) {
        add(entity.id);
        for (const double x : {entity.pose.position.x, entity.pose.position.y,
                               entity.pose.position.z, entity.pose.rotation.w})
            add(std::bit_cast<std::uint64_t>(x));
    }
    for (const std::uint64_t count :
         {tally_.connections, tally_.resumed, tally_.snapshots, tally_.inputs, tally_.applied,
          tally_.refused, tally_.spawned, tally_.frames_compared, tally_.hostile_messages,
          tally_.faults})
        add(count);
    return hash;
}

}  // namespace jostle::simulation
