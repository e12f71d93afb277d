// SPDX-License-Identifier: MIT
#include "tests/simulation/honest_client.h"

#include <algorithm>
#include <utility>

#include "jostle/snapshot/quantize.h"

namespace jostle::simulation {

namespace {

constexpr std::size_t frames_between_comparisons = 8;
// Answers go out thirty times a second, snapshots as often as the world ticks. In ticks.
constexpr std::uint64_t answer_comes_within = 60;

bots::ScriptLine random_conditions(Chance& chance) {
    bots::Script script = bots::default_script();
    return script[chance.below(script.size())];
}

client::ClientOptions options_of(const std::string& name, bool events) {
    client::ClientOptions options;
    options.name = name;
    options.events = events;
    return options;
}

wire::Pose pose_of(const server::EntityPose& entity) {
    const physics::Transform& at = entity.pose;
    return {{at.position.x, at.position.y, at.position.z},
            {at.rotation.x, at.rotation.y, at.rotation.z, at.rotation.w}};
}

}  // namespace

HonestClient::HonestClient(std::string name, std::uint64_t seed, Tally& tally, FailureHandler fail)
    : name_(std::move(name)),
      chance_(seed),
      tally_(tally),
      complain_(std::move(fail)),
      conversation_(options_of(name_, chance_.one_in(3))),
      behaviour_(random_conditions(chance_), static_cast<std::uint32_t>(chance_.bits())) {}

void HonestClient::connect(std::shared_ptr<NetworkLine> line, Clock::time_point now) {
    tally_.connections++;
    line_ = std::move(line);
    connected_at_ = now;
    is_new_line_ = true;
    conversation_.begin(now);
}

// The server knows which client it is: the one that it was, or a new one.
void HonestClient::on_welcome() {
    is_new_line_ = false;
    const std::uint64_t resumed = conversation_.stats().resumed;
    if (resumed != resumed_) {
        tally_.resumed++;
        resumed_ = resumed;
        return;
    }
    // Inputs that wait since before go first, under new numbers.
    carried_over_ = static_cast<std::uint32_t>(sends_ - conversation_.stats().inputs_sent);
    last_sequence_ = carried_over_;
    answered_ = 0;
    spawns_asked_.clear();
    spawned_.clear();
    unexplained_.clear();
}

void HonestClient::act(Clock::time_point now, const FrameOf& frame_of) {
    if (!line_) return;
    acts_++;
    receive_messages(now, frame_of);
    if (line_->is_over()) return end();
    if (conversation_.stats().connected && !conversation_.leaving()) {
        const double seconds = std::chrono::duration<double>(now - connected_at_).count();
        for (v1::Input& input :
             behaviour_.act(seconds, conversation_.view(), conversation_.stats().client_id)) {
            const bool is_spawn = input.has_spawn();
            const std::uint32_t sequence = conversation_.send(std::move(input));
            if (sequence == 0) continue;
            tally_.inputs++;
            sends_++;
            last_sequence_ = sequence;
            if (is_spawn) spawns_asked_.insert(sequence);
        }
    }
    send_messages(now);
}

void HonestClient::receive_messages(Clock::time_point now, const FrameOf& frame_of) {
    while (const std::optional<std::string> message = line_->receive(now))
        conversation_.receive(*message, now);
    if (is_new_line_ && conversation_.stats().connected) on_welcome();
    check_results(frame_of);
    for (const auto& [entity, since] : unexplained_)
        if (acts_ - since > answer_comes_within)
            complain_(name_ + " owns entity " + std::to_string(entity) + ", and no answer said so");
    const client::ClientStats& stats = conversation_.stats();
    tally_.snapshots += stats.snapshots - snapshots_;
    const bool fresh = stats.snapshots != snapshots_;
    snapshots_ = stats.snapshots;
    if (stats.decode_errors != decode_errors_)
        complain_(name_ + " could not decode what the server sent: " + stats.last_error);
    if (!fresh || snapshots_ % frames_between_comparisons != 0) return;
    const std::uint32_t tick = conversation_.view().frame().frame;
    if (const server::FramePtr truth = frame_of(tick)) compare(*truth);
}

// What is decoded is what the server's world was, to the last bit of what is sent of it.
void HonestClient::compare(const server::Frame& truth) {
    tally_.frames_compared++;
    for (const auto& entity : *truth.entity_list)
        if (entity->owner == conversation_.stats().client_id && !spawned_.contains(entity->id))
            unexplained_.emplace(entity->id, acts_);
    const client::WorldView& view = conversation_.view();
    const auto& decoded = view.frame().entities;
    if (decoded.size() != truth.entities.size())
        return complain_(name_ + " decoded " + std::to_string(decoded.size()) + " entities of " +
                         std::to_string(truth.entities.size()));
    for (std::size_t i = 0; i < decoded.size(); i++) {
        const server::EntityPose& entity = truth.entities[i];
        if (decoded[i] != wire::quantize(entity.id, pose_of(entity), !entity.awake, view.spec()))
            return complain_(name_ + " decoded entity " + std::to_string(entity.id) + " of tick " +
                             std::to_string(truth.tick) + " as another");
    }
}

// Each input has one answer, in their order; and what was applied was so in the tick that the
// answer names, and in no other.
void HonestClient::check_results(const FrameOf& frame_of) {
    for (const v1::InputResult& result : conversation_.take_results()) {
        if (result.sequence() <= answered_ || result.sequence() > last_sequence_)
            complain_(name_ + " got an answer to input " + std::to_string(result.sequence()) +
                      " after that to " + std::to_string(answered_));
        answered_ = result.sequence();
        const bool applied = result.code() == v1::INPUT_CODE_APPLIED;
        (applied ? tally_.applied : tally_.refused)++;
        const bool asked = spawns_asked_.erase(result.sequence()) != 0;
        if (asked && applied) check_spawn(result, frame_of);
        // What those were is not known any more: they may have been spawns.
        if (applied && result.sequence() <= carried_over_) {
            spawned_.insert(result.entity());
            unexplained_.erase(result.entity());
        }
    }
}

void HonestClient::check_spawn(const v1::InputResult& result, const FrameOf& frame_of) {
    tally_.spawned++;
    const std::string what = name_ + "'s entity " + std::to_string(result.entity());
    if (!spawned_.insert(result.entity()).second) complain_(what + " was spawned twice");
    unexplained_.erase(result.entity());
    const auto has_it = [&](std::uint32_t tick) -> std::optional<bool> {
        const server::FramePtr frame = frame_of(tick);
        if (!frame) return std::nullopt;
        return std::ranges::any_of(*frame->entity_list, [&](const auto& entity) {
            return entity->id == result.entity() &&
                   entity->owner == conversation_.stats().client_id;
        });
    };
    if (has_it(result.tick() - 1).value_or(false)) complain_(what + " was there too early");
    if (!has_it(result.tick()).value_or(true)) complain_(what + " is not there");
}

void HonestClient::send_messages(Clock::time_point now) {
    while (const std::optional<std::string> message = conversation_.take_message(now))
        line_->send(*message, now);
    if (conversation_.leave_sent()) line_->close_by_client(now);
}

void HonestClient::end() {
    conversation_.ended(line_->end_status());
    conversation_.take_events();
    conversation_.take_ages_ms();
    line_ = nullptr;
}

}  // namespace jostle::simulation
