// SPDX-License-Identifier: MIT
#include "jostle/client/predictor.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "local_world.h"

namespace jostle::client {

using namespace physics;

namespace {

// A frame and a foresight that agree differ by what is lost in a frame's integers (1.7 mm, 5 mrad
// at the usual 512 a metre), and a little.
constexpr double agree_m = 0.003, agree_rad = 0.01;
// What a body did between two frames, against what was foreseen of it: up to this it is the
// integers' noise, beyond somebody pushed it.
constexpr double pushed_speed = 0.25, pushed_spin = 1;  // m/s, rad/s
constexpr double leave_factor = 1.5;  // of near_m: who came near stays until so far away
constexpr std::uint32_t slow_ticks = 15;
constexpr std::size_t inputs_max = 1024;
constexpr std::int64_t unseen_us = 250'000;

double gap(const Vec3& a, const Vec3& b) {
    return length(a - b);
}

// The rotation from a to b as an axis times an angle.
Vec3 turn_between(const Quat& a, const Quat& b) {
    Quat q = b * conjugate(a);
    if (q.w < 0) q = {-q.x, -q.y, -q.z, -q.w};
    const Vec3 v{q.x, q.y, q.z};
    const double sine = length(v);
    return sine == 0 ? Vec3{} : v * (2 * std::atan2(sine, q.w) / sine);
}

bool agrees(const Transform& a, const Transform& b) {
    return gap(a.position, b.position) <= agree_m &&
           length(turn_between(a.rotation, b.rotation)) <= agree_rad;
}

wire::Pose mix(const Motion& a, const Motion& b, double t) {
    const Vec3 turn = turn_between(a.pose.rotation, b.pose.rotation) * t;
    const double angle = length(turn);
    const Vec3 axis = angle == 0 ? Vec3{} : turn * (std::sin(angle / 2) / angle);
    const Quat q = Quat{axis.x, axis.y, axis.z, std::cos(angle / 2)} * a.pose.rotation;
    const Vec3 p = a.pose.position + (b.pose.position - a.pose.position) * t;
    return to_pose({.position = p, .rotation = q});
}

// A body of a frame.
struct Told {
    Transform pose;
    bool at_rest = false;
};

}  // namespace

struct Predictor::Impl {
    using Moment = LocalWorld::Moment;
    struct Sent {
        std::uint32_t sequence, tick;
        v1::Input input;
    };
    struct Shown {
        wire::Pose pose;
        PoseError error;
        bool foreseen;
    };

    PredictorOptions options;
    Stats stats;
    Vec3 gravity{0, -9.81, 0};
    double tick_s = 1.0 / 60;
    std::uint32_t entity = 0;
    std::optional<LocalWorld> world;
    std::deque<Moment> moments;  // one for each tick, the newest last: where the world is
    std::vector<Moment> spare;   // for their memory
    std::deque<Sent> inputs;     // by sequence
    std::uint32_t newest_frame = 0;
    std::map<std::uint32_t, Told> told;                // of that frame: who was near
    std::map<std::uint32_t, std::uint32_t> corrected;  // tick, by entity
    // The last picture.
    std::map<std::uint32_t, Shown> shown;
    double drawn_position = 0;
    std::int64_t drawn_us = 0;
    bool changed = false;  // since then, what had been foreseen

    void forget_world() {
        world.reset();
        moments.clear();
        told.clear();
        corrected.clear();
        newest_frame = 0;
    }
    std::uint32_t tick() const { return moments.back().tick; }
    Moment* find(std::uint32_t wanted) {
        if (moments.empty() || wanted < moments.front().tick || wanted > tick()) return nullptr;
        return &moments[wanted - moments.front().tick];
    }

    // --- ticks ---
    void keep(std::uint32_t at) {
        moments.emplace_back();
        if (!spare.empty()) {
            moments.back() = std::move(spare.back());
            spare.pop_back();
        }
        world->keep(moments.back(), at);
    }
    void drop_oldest() {
        spare.push_back(std::move(moments.front()));
        moments.pop_front();
    }
    void drop_newest() {
        spare.push_back(std::move(moments.back()));
        moments.pop_back();
    }
    void step() {
        const std::uint32_t next = tick() + 1;
        for (const Sent& sent : inputs)
            if (sent.tick == next) world->apply(sent.input);
        world->step(tick_s);
        stats.steps++;
        keep(next);
    }
    void step_to(std::uint32_t wanted) {
        while (tick() < wanted) step();
    }
    // The world as it was after that tick; later moments are gone.
    void go_back(std::uint32_t to) {
        world->go_back(*find(to));
        while (tick() > to) drop_newest();
        changed = true;
    }
    // Something is otherwise from that tick on.
    void again_from(std::uint32_t first) {
        if (moments.empty() || first > tick() || first == 0) return;
        const std::uint32_t now = tick();
        go_back(std::max(first - 1, moments.front().tick));
        step_to(now);
    }

    // --- frames ---
    bool is_member(std::uint32_t id) const { return world && world->members().moving.contains(id); }
    std::map<std::uint32_t, Told> near_bodies(const WorldView& view, const Vec3& around) const;
    void add_fixed(const WorldView& view);
    bool change_members(const WorldView& view, const std::map<std::uint32_t, Told>& near,
                        std::uint32_t frame);
    double seconds_of(const Told& before, std::uint32_t frame) const;
    Motion measured(std::uint32_t id, const Told& now, std::uint32_t frame);
    Motion put_right(std::uint32_t id, const Told& now, std::uint32_t frame);
    void start(const WorldView& view, const std::map<std::uint32_t, Told>& near);
    void compare(const WorldView& view, const std::map<std::uint32_t, Told>& near);
    void on_frame(const WorldView& view);

    // --- pictures ---
    std::optional<wire::Pose> foreseen(std::uint32_t id, double position, Pace* pace);
    std::vector<SmoothPose> sample(double position, std::int64_t now_us,
                                   std::vector<SmoothPose> poses);
};

// The dynamic bodies that are near, and those that were and are not yet far.
std::map<std::uint32_t, Told> Predictor::Impl::near_bodies(const WorldView& view,
                                                           const Vec3& around) const {
    struct Candidate {
        double distance;
        std::uint32_t id;
        Told told;
    };
    std::vector<Candidate> candidates;
    auto known = view.entities().begin();
    for (const wire::EntityState& state : view.frame().entities) {
        while (known != view.entities().end() && known->first < state.id) ++known;
        if (known == view.entities().end()) break;
        if (known->first != state.id || known->second.type() != v1::BODY_TYPE_DYNAMIC) continue;
        const Transform pose = to_transform(wire::dequantize(state, view.spec()));
        const double far = state.id == entity ? 0 : gap(pose.position, around);
        const double most = is_member(state.id) ? leave_factor * options.near_m : options.near_m;
        if (far <= most) candidates.push_back({far, state.id, {pose, state.at_rest}});
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return std::pair(a.distance, a.id) < std::pair(b.distance, b.id);
    });
    candidates.resize(std::min(candidates.size(), options.near_max));
    std::map<std::uint32_t, Told> near;
    for (const Candidate& c : candidates) near[c.id] = c.told;
    return near;
}

void Predictor::Impl::add_fixed(const WorldView& view) {
    for (const auto& [id, body] : view.entities()) {
        if (body.type() == v1::BODY_TYPE_DYNAMIC || world->members().fixed.contains(id)) continue;
        if (world->members().fixed.size() >= options.fixed_max) return;
        if (const auto pose = view.pose_of(id))
            world->add(view, body, {.pose = to_transform(*pose)}, true);
    }
}

// How long a body moved since the frame before. While nothing moves no frames are sent, so that
// what rested then began with this one.
double Predictor::Impl::seconds_of(const Told& before, std::uint32_t frame) const {
    return (before.at_rest ? 1 : frame - newest_frame) * tick_s;
}

// Of one that is new here: what it did since the frame before.
Motion Predictor::Impl::measured(std::uint32_t id, const Told& now, std::uint32_t frame) {
    Motion motion{.pose = now.pose};
    const auto before = told.find(id);
    if (now.at_rest || before == told.end() || frame <= newest_frame) return motion;
    const double seconds = seconds_of(before->second, frame);
    const Transform& was = before->second.pose;
    motion.linear = (now.pose.position - was.position) * (1 / seconds);
    motion.angular = turn_between(was.rotation, now.pose.rotation) * (1 / seconds);
    if (length(motion.linear) > 100 || length(motion.angular) > 100) return {.pose = now.pose};
    return motion;
}

// Where the frame says, at the velocity that explains how it came there.
Motion Predictor::Impl::put_right(std::uint32_t id, const Told& now, std::uint32_t frame) {
    const Motion& guess = find(frame)->motions.at(id);
    Motion right{now.pose, guess.linear, guess.angular};
    const Moment* before = find(newest_frame);
    const auto was = told.find(id);
    if (before && was != told.end() && before->motions.contains(id) && frame > newest_frame) {
        const Transform& from = before->motions.at(id).pose;
        const double seconds = seconds_of(was->second, frame);
        const Vec3 more =
            (now.pose.position - was->second.pose.position) - (guess.pose.position - from.position);
        const Vec3 turned = turn_between(was->second.pose.rotation, now.pose.rotation) -
                            turn_between(from.rotation, guess.pose.rotation);
        const auto last = corrected.find(id);
        const std::uint32_t since =
            last == corrected.end() ? slow_ticks : std::min(slow_ticks, frame - last->second);
        const double slow_seconds = std::max(1u, since) * tick_s;
        right.linear += length(more) > pushed_speed * seconds
                            ? more * (1 / seconds)
                            : (now.pose.position - guess.pose.position) * (1 / slow_seconds);
        right.angular +=
            length(turned) > pushed_spin * seconds
                ? turned * (1 / seconds)
                : turn_between(guess.pose.rotation, now.pose.rotation) * (1 / slow_seconds);
    }
    if (now.at_rest) right.linear = right.angular = {};
    corrected[id] = frame;
    return right;
}

// Whether anybody came or went.
bool Predictor::Impl::change_members(const WorldView& view,
                                     const std::map<std::uint32_t, Told>& near,
                                     std::uint32_t frame) {
    std::vector<std::uint32_t> gone;
    for (const auto& [id, body] : world->members().moving)
        if (!near.contains(id)) gone.push_back(id);
    for (const auto& [id, body] : world->members().fixed)
        if (!view.entities().contains(id)) gone.push_back(id);
    for (const std::uint32_t id : gone) world->remove(id);
    bool any = !gone.empty();
    for (const auto& [id, now] : near)
        if (!is_member(id))
            any |= world->add(view, view.entities().at(id), measured(id, now, frame), now.at_rest);
    return any;
}

void Predictor::Impl::start(const WorldView& view, const std::map<std::uint32_t, Told>& near) {
    moments.clear();
    world.emplace(gravity, options.substeps);
    const std::uint32_t frame = view.frame().frame;
    change_members(view, near, frame);
    add_fixed(view);
    keep(frame);
    changed = true;
}

void Predictor::Impl::compare(const WorldView& view, const std::map<std::uint32_t, Told>& near) {
    const std::uint32_t frame = view.frame().frame, now = tick();
    const Moment& guess = *find(frame);
    stats.frames++;
    stats.last_error_m = 0;
    std::map<std::uint32_t, Motion> wrong;
    bool others = false;  // came or went
    for (const auto& [id, body] : near) {
        const auto at = guess.motions.find(id);
        others |= at == guess.motions.end();
        if (at == guess.motions.end()) continue;
        stats.last_error_m =
            std::max(stats.last_error_m, gap(at->second.pose.position, body.pose.position));
        if (!agrees(at->second.pose, body.pose)) wrong[id] = put_right(id, body, frame);
    }
    others |= std::any_of(guess.motions.begin(), guess.motions.end(),
                          [&](const auto& one) { return !near.contains(one.first); });
    if (wrong.empty() && !others) return;
    stats.corrections += wrong.empty() ? 0 : 1;
    go_back(frame);
    drop_newest();
    for (const auto& [id, motion] : wrong)
        if (near.contains(id)) world->set_motion(id, motion, near.at(id).at_rest);
    change_members(view, near, frame);
    keep(frame);
    step_to(now);
}

void Predictor::Impl::on_frame(const WorldView& view) {
    const std::uint32_t frame = view.frame().frame;
    if (frame == newest_frame) return;
    const auto own = view.pose_of(entity);
    const auto about = view.entities().find(entity);
    if (entity == 0 || !own || about == view.entities().end() ||
        about->second.type() != v1::BODY_TYPE_DYNAMIC)
        return forget_world();
    const auto near = near_bodies(view, to_transform(*own).position);
    if (world && frame > newest_frame && find(frame))
        compare(view, near);
    else
        start(view, near);
    newest_frame = frame;
    told = near;
    while (moments.front().tick < frame) drop_oldest();
    while (!inputs.empty() && inputs.front().tick + 1 < frame) inputs.pop_front();
    std::erase_if(corrected, [&](const auto& one) { return !near.contains(one.first); });
}

std::optional<wire::Pose> Predictor::Impl::foreseen(std::uint32_t id, double position, Pace* pace) {
    if (moments.empty()) return std::nullopt;
    const double at = std::clamp(position, static_cast<double>(moments.front().tick),
                                 static_cast<double>(tick()));
    const auto before = static_cast<std::uint32_t>(std::floor(at));
    const Moment& a = *find(before);
    const Moment& b = before < tick() ? *find(before + 1) : a;
    const auto from = a.motions.find(id), to = b.motions.find(id);
    if (from == a.motions.end() || to == b.motions.end()) return std::nullopt;
    if (pace) *pace = {length(to->second.linear), length(to->second.angular)};
    return mix(from->second, to->second, at - before);
}

std::vector<SmoothPose> Predictor::Impl::sample(double position, std::int64_t now_us,
                                                std::vector<SmoothPose> poses) {
    const double seconds = static_cast<double>(std::max<std::int64_t>(0, now_us - drawn_us)) / 1e6;
    if (now_us - drawn_us > unseen_us) shown.clear();
    if (!moments.empty()) {
        const double most = newest_frame + options.ticks_max;
        step_to(static_cast<std::uint32_t>(std::ceil(std::min(std::max(0.0, position), most))));
    }
    std::map<std::uint32_t, Shown> now;
    for (SmoothPose& drawn : poses) {
        Pace pace;
        const auto ahead = foreseen(drawn.entity, position, &pace);
        const auto before = shown.find(drawn.entity);
        if (!ahead && before == shown.end()) continue;
        // Who was foreseen and is no longer, or the other way round, is walked over.
        const wire::Pose right = ahead ? *ahead : drawn.pose;
        const bool is_new = before == shown.end(), left = !ahead && !is_new;
        PoseError error;
        if (is_new)
            error = walkable(pose_error(drawn.pose, right), pace);
        else if (left && before->second.foreseen)
            error = walkable(pose_error(before->second.pose, right), pace);
        else if (ahead && changed)
            error = walkable(
                pose_error(before->second.pose,
                           foreseen(drawn.entity, drawn_position, nullptr).value_or(right)),
                pace);
        else
            error = before->second.error;
        if (!is_new) error = decayed(error, pace, seconds);
        drawn.pose = with_error(right, error);
        if (ahead || !error.none()) now[drawn.entity] = {drawn.pose, error, ahead.has_value()};
    }
    shown = std::move(now);
    drawn_position = position;
    drawn_us = now_us;
    changed = false;
    return poses;
}

Predictor::Predictor(PredictorOptions options) : impl_(std::make_unique<Impl>()) {
    impl_->options = options;
}
Predictor::~Predictor() = default;

void Predictor::begin(const v1::Welcome& welcome) {
    Impl& p = *impl_;
    p.forget_world();
    p.inputs.clear();
    p.shown.clear();
    p.gravity = {welcome.gravity().x(), welcome.gravity().y(), welcome.gravity().z()};
    if (welcome.tick_hz() >= 4 && welcome.tick_hz() <= 1e4) p.tick_s = 1 / welcome.tick_hz();
}

void Predictor::follow(std::uint32_t entity) {
    if (impl_->entity == entity) return;
    impl_->entity = entity;
    impl_->forget_world();
}

void Predictor::add_input(std::uint32_t sequence, const v1::Input& input) {
    if (sequence == 0 || input.tick() == 0) return;
    impl_->inputs.push_back({sequence, input.tick(), input});
    if (impl_->inputs.size() > inputs_max) impl_->inputs.pop_front();
    // What we do now is no mistake: it is seen at once.
    const bool changed = impl_->changed;
    const bool late = !impl_->moments.empty() && input.tick() < impl_->tick();
    impl_->again_from(input.tick());
    impl_->changed = changed || late;
}

void Predictor::on_results(const std::vector<v1::InputResult>& results) {
    for (const v1::InputResult& result : results) {
        auto& inputs = impl_->inputs;
        const auto sent = std::find_if(inputs.begin(), inputs.end(), [&](const Impl::Sent& s) {
            return s.sequence == result.sequence();
        });
        if (sent == inputs.end()) continue;
        const std::uint32_t meant = sent->tick;
        if (result.code() != v1::INPUT_CODE_APPLIED)
            inputs.erase(sent);
        else if (result.tick() != meant)
            sent->tick = result.tick();
        else
            continue;
        impl_->again_from(std::min(meant, std::max(1u, result.tick())));
    }
}

void Predictor::on_frame(const WorldView& view) {
    impl_->on_frame(view);
}

std::vector<SmoothPose> Predictor::sample(double position, std::int64_t now_us,
                                          std::vector<SmoothPose> interpolated) {
    return impl_->sample(position, now_us, std::move(interpolated));
}

const Predictor::Stats& Predictor::stats() const {
    return impl_->stats;
}

std::size_t Predictor::bodies() const {
    return impl_->world ? impl_->world->members().moving.size() : 0;
}

}  // namespace jostle::client
