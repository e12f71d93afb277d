// SPDX-License-Identifier: MIT
#include "tests/simulation/honest_client.h"

#include <algorithm>
#include <utility>

#include "jostle/snapshot/quantize.h"

namespace jostle::simulation {

namespace {

constexpr std::size_t frames_between_comparisons = 8;
// Results are sent thirty times per second and snapshots with every tick. In ticks.
constexpr std::uint64_t result_ticks_max = 60;

bot::ScriptLine random_conditions(Chance& chance) {
    bot::Script script = bot::default_script();
    return script[chance.below(script.size())];
}

client::ClientOptions options_of(const std::string& name, bool events) {
    client::ClientOptions options;
    options.name = name;
    options.events = events;
    return options;
}

snapshot::Pose pose_of(const server::EntityPose& entity) {
    const physics::Transform& at = entity.pose;
    return {{at.position.x, at.position.y, at.position.z},
            {at.rotation.x, at.rotation.y, at.rotation.z, at.rotation.w}};
}

}  // namespace

HonestClient::HonestClient(std::string name, std::uint64_t seed, Tally& tally, FailureHandler fail)
    : name_(std::move(name)),
      chance_(seed),
      tally_(tally),
      fail_(std::move(fail)),
      protocol_(options_of(name_, chance_.one_in(3))),
      behaviour_(random_conditions(chance_), static_cast<std::uint32_t>(chance_.bits())) {}

void HonestClient::connect(std::shared_ptr<NetworkLine> line, Clock::time_point now) {
    tally_.connections++;
    line_ = std::move(line);
    connected_at_ = now;
    is_new_line_ = true;
    protocol_.begin(now);
}

// The server has decided whether the client resumed its session or is a new client.
void HonestClient::on_welcome() {
    is_new_line_ = false;
    const std::uint64_t resumed = protocol_.stats().resumed;
    if (resumed != resumed_) {
        tally_.resumed++;
        resumed_ = resumed;
        return;
    }
    // Inputs that waited for the connection are sent first, with new sequences.
    carried_over_ = static_cast<std::uint32_t>(sends_ - protocol_.stats().inputs_sent);
    last_sequence_ = carried_over_;
    last_result_ = 0;
    pending_spawns_.clear();
    spawned_.clear();
    unexplained_.clear();
}

void HonestClient::act(Clock::time_point now, const FrameOf& frame_of) {
    if (!line_) return;
    acts_++;
    receive_messages(now, frame_of);
    if (line_->is_over()) return end();
    if (protocol_.stats().connected && !protocol_.leaving()) {
        const double seconds = std::chrono::duration<double>(now - connected_at_).count();
        for (v1::Input& input :
             behaviour_.act(seconds, protocol_.view(), protocol_.stats().client_id)) {
            const bool is_spawn = input.has_spawn();
            const std::uint32_t sequence = protocol_.send(std::move(input));
            if (sequence == 0) continue;
            tally_.inputs++;
            sends_++;
            last_sequence_ = sequence;
            if (is_spawn) pending_spawns_.insert(sequence);
        }
    }
    send_messages(now);
}

void HonestClient::receive_messages(Clock::time_point now, const FrameOf& frame_of) {
    while (const std::optional<std::string> message = line_->receive(now))
        protocol_.receive(*message, now);
    if (is_new_line_ && protocol_.stats().connected) on_welcome();
    check_results(frame_of);
    for (const auto& [entity, since] : unexplained_)
        if (acts_ - since > result_ticks_max)
            fail_(name_ + " owns entity " + std::to_string(entity) + " without a result");
    const client::ClientStats& stats = protocol_.stats();
    tally_.snapshots += stats.snapshots - snapshots_;
    const bool fresh = stats.snapshots != snapshots_;
    snapshots_ = stats.snapshots;
    if (stats.decode_errors != decode_errors_)
        fail_(name_ + " cannot decode a message: " + stats.last_error);
    if (!fresh || snapshots_ % frames_between_comparisons != 0) return;
    const std::uint32_t tick = protocol_.view().frame().frame;
    if (const server::FramePtr truth = frame_of(tick)) compare(*truth);
}

// The decoded state must be bit-identical to the quantized state of the server's world.
void HonestClient::compare(const server::Frame& truth) {
    tally_.frames_compared++;
    for (const auto& entity : *truth.entity_list)
        if (entity->owner == protocol_.stats().client_id && !spawned_.contains(entity->id))
            unexplained_.emplace(entity->id, acts_);
    const client::WorldView& view = protocol_.view();
    const auto& decoded = view.frame().entities;
    if (decoded.size() != truth.entities.size())
        return fail_(name_ + " decoded " + std::to_string(decoded.size()) + " entities of " +
                     std::to_string(truth.entities.size()));
    for (std::size_t i = 0; i < decoded.size(); i++) {
        const server::EntityPose& entity = truth.entities[i];
        if (decoded[i] !=
            snapshot::quantize(entity.id, pose_of(entity), !entity.awake, view.spec()))
            return fail_(name_ + " decoded entity " + std::to_string(entity.id) + " of tick " +
                         std::to_string(truth.tick) + " as another");
    }
}

// Each input has one result, in order. An applied input took effect in the tick of its result and
// in no other tick.
void HonestClient::check_results(const FrameOf& frame_of) {
    for (const v1::InputResult& result : protocol_.take_results()) {
        if (result.sequence() <= last_result_ || result.sequence() > last_sequence_)
            fail_(name_ + " received a result for input " + std::to_string(result.sequence()) +
                  " after the result for input " + std::to_string(last_result_));
        last_result_ = result.sequence();
        const bool applied = result.code() == v1::INPUT_CODE_APPLIED;
        (applied ? tally_.applied : tally_.refused)++;
        const bool is_spawn = pending_spawns_.erase(result.sequence()) != 0;
        if (is_spawn && applied) check_spawn(result, frame_of);
        // The kinds of these inputs are unknown: they may have been spawns.
        if (applied && result.sequence() <= carried_over_) {
            spawned_.insert(result.entity());
            unexplained_.erase(result.entity());
        }
    }
}

void HonestClient::check_spawn(const v1::InputResult& result, const FrameOf& frame_of) {
    tally_.spawned++;
    const std::string what = name_ + "'s entity " + std::to_string(result.entity());
    if (!spawned_.insert(result.entity()).second) fail_(what + " was spawned twice");
    unexplained_.erase(result.entity());
    const auto has_it = [&](std::uint32_t tick) -> std::optional<bool> {
        const server::FramePtr frame = frame_of(tick);
        if (!frame) return std::nullopt;
        return std::ranges::any_of(*frame->entity_list, [&](const auto& entity) {
            return entity->id == result.entity() && entity->owner == protocol_.stats().client_id;
        });
    };
    if (has_it(result.tick() - 1).value_or(false)) fail_(what + " exists one tick too early");
    if (!has_it(result.tick()).value_or(true))
        fail_(what + " does not exist in the tick of its result");
}

void HonestClient::send_messages(Clock::time_point now) {
    while (const std::optional<std::string> message = protocol_.take_message(now))
        line_->send(*message, now);
    if (protocol_.leave_sent()) line_->close_by_client(now);
}

void HonestClient::end() {
    protocol_.ended(line_->end_status());
    protocol_.take_events();
    protocol_.take_ages_ms();
    line_ = nullptr;
}

}  // namespace jostle::simulation
