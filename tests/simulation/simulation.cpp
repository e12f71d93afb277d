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
constexpr std::size_t frames_kept = 900;  // 15 s: longer than any line takes
constexpr std::uint64_t day = 20'000;     // ticks; then everybody leaves

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
    // They count by the real clock.
    for (double* rate : {&config.quota.creates_per_minute, &config.quota.joins_per_minute,
                         &config.quota.queries_per_second})
        *rate = 1e9;
    return config;
}

}  // namespace

// A process, from start to end.
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
         .own_thread = false},
        config.world.worlds_max};
    std::shared_ptr<server::WorldHost> world;
    server::PlayContext context{
        .config = config, .worlds = worlds, .sessions = sessions, .authorizer = gate};
};

Simulation::Simulation(std::uint64_t seed) : chance_(seed) {
    start_server();
    for (ClientSlot& seat : seats_)
        seat.again = now_ + std::chrono::milliseconds(chance_.below(3000));
    hostile_again_ = now_;
}

Simulation::~Simulation() {
    hostile_.reset();
    for (ClientSlot& seat : seats_) seat.client.reset();
    lines_.clear();
}

void Simulation::fail(const std::string& what) {
    if (complaint_.empty()) complaint_ = "tick " + std::to_string(ticks_) + ": " + what;
}

void Simulation::start_server() {
    // Its log has a thread, so there is one for all.
    static const std::unique_ptr<server::Authorizer> authorizer =
        server::Authorizer::open(small_config()).value();
    lines_.clear();
    frames_.clear();
    server_.reset();
    server_ = std::make_unique<Server>(*authorizer);
}

void Simulation::run(std::uint64_t ticks) {
    for (const std::uint64_t end = ticks_ + ticks; ticks_ < end && complaint_.empty();) tick();
}

void Simulation::tick() {
    ticks_++;
    now_ += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / hz));
    faults();
    server_->world->tick(now_);
    server::remove_expired_clients(server_->context, now_);
    frames_.push_back(server_->world->frame());
    if (frames_.size() > frames_kept) frames_.pop_front();
    serve_lines();
    for (ClientSlot& seat : seats_) act_honest(seat);
    act_hostile();
    serve_lines();
    if (ticks_ % day == 0) night_ = true;
    if (night_) restart_server();
}

server::FramePtr Simulation::frame_of(std::uint32_t tick) const {
    const auto found = std::ranges::find_if(
        frames_, [&](const server::FramePtr& frame) { return frame->tick == tick; });
    return found == frames_.end() ? nullptr : *found;
}

// ---- what goes wrong ----

void Simulation::faults() {
    if (chance_.one_in(5'000)) pause_of_machine();
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
        // The world is deleted under its clients, and one of the same scene takes its place.
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
        // Who is still there is told, and then the process ends.
        server_->context.closing = true;
        serve_lines();
        for (const auto& line : lines_) line->close_by_client(now_);
        restart_at_ = resume_at_ = {};
        start_server();
    }
}

// SIGSTOP, or a virtual machine that is moved: the server's clock goes on, and it does not.
void Simulation::pause_of_machine() {
    tally_.faults++;
    now_ += std::chrono::milliseconds(600 + chance_.below(15'000));
}

// ---- who plays ----

std::shared_ptr<NetworkLine> Simulation::new_line(const std::string& name, bool is_honest) {
    NetworkConditions quality{.delay = std::chrono::milliseconds(1 + chance_.below(80))};
    if (chance_.one_in(3)) quality.cuts_after = 500;
    const std::string address =
        (is_honest ? "192.0.2." : "198.51.100.") + std::to_string(1 + chance_.below(200));
    lines_.push_back(std::make_shared<NetworkLine>(server_->context,
                                                   name + " " + std::to_string(++lines_made_),
                                                   address, quality, chance_.bits(), now_));
    return lines_.back();
}

void Simulation::serve_lines() {
    for (const auto& line : lines_) line->serve(now_);
    std::erase_if(lines_, [](const auto& line) { return line->is_closed(); });
}

void Simulation::act_honest(ClientSlot& seat) {
    if (!seat.client) {
        if (night_ || now_ < seat.again) return;
        seat.client = std::make_unique<HonestClient>(
            "honest", chance_.bits(), tally_, [this](const std::string& what) { fail(what); });
    }
    HonestClient& client = *seat.client;
    if (!client.is_connected()) {
        if (client.has_left()) {
            seat.client.reset();
            seat.again = now_ + std::chrono::milliseconds(chance_.below(8000));
            return;
        }
        if (now_ < seat.again) return;
        client.connect(new_line("honest", true), now_);
    }
    if (night_ || chance_.one_in(2'000)) client.leave();
    client.act(now_, [this](std::uint32_t tick) { return frame_of(tick); });
    if (!client.is_connected()) seat.again = now_ + std::chrono::milliseconds(chance_.below(2000));
}

void Simulation::act_hostile() {
    if (hostile_ && hostile_->is_connected()) {
        hostile_->act(now_);
        return;
    }
    if (night_ || now_ < hostile_again_) return;
    hostile_ = std::make_unique<HostileClient>(chance_.bits(), tally_);
    hostile_->connect(new_line("hostile", false));
    hostile_again_ = now_ + std::chrono::milliseconds(chance_.below(1500));
}

// ---- what must be so when nobody is there ----

bool Simulation::all_clients_left() const {
    return server_->context.resume_registry.lost() == 0 &&
           (!hostile_ || !hostile_->is_connected()) &&
           std::ranges::all_of(seats_, [](const ClientSlot& seat) { return !seat.client; });
}

void Simulation::restart_server() {
    if (ticks_ % day == static_cast<std::uint64_t>(60 * 60)) fail("somebody does not leave");
    if (!all_clients_left() || !lines_.empty() || restart_at_ != Clock::time_point{} ||
        resume_at_ != Clock::time_point{})
        return;
    // The world hears of those who left with its next tick.
    server_->world->tick(now_);
    check_no_leaks();
    frames_.clear();
    night_ = false;
}

void Simulation::check_no_leaks() {
    if (server_->sessions.clients() != 0)
        fail(std::to_string(server_->sessions.clients()) + " clients are still counted");
    if (const auto sights = server_->context.records.check(now_); !sights.empty())
        fail("there is still a record of client " + std::to_string(sights.front().who.id));
    for (const auto& entity : *server_->world->frame()->entity_list)
        if (entity->owner != 0)
            fail("entity " + std::to_string(entity->id) + " of client " +
                 std::to_string(entity->owner) + " is still there");
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
