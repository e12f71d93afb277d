// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/solve_continuous.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/impact_points.h"
#include "physics/src/collision/narrowphase/time_of_impact.h"
#include "physics/src/constraints/impact.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/contacts/call_contact_listeners.h"
#include "physics/src/stages/contacts/find_clusters.h"
#include "physics/src/stages/continuous/bounce_events.h"
#include "physics/src/stages/continuous/ccd_candidates.h"
#include "physics/src/stages/continuous/ccd_policy.h"
#include "physics/src/stages/continuous/find_sweep_candidates.h"
#include "physics/src/stages/continuous/parabola.h"
#include "physics/src/stages/continuous/project_joints.h"
#include "physics/src/stages/continuous/swept_motions.h"
#include "physics/src/stages/continuous/toi_body.h"
#include "physics/src/stages/continuous/toi_dependents.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/contact_modifiers.h"
#include "physics/src/state/joint_graph.h"
#include "physics/src/state/pair_size.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {
namespace {

// A body of so many shapes knows which of them are near what it may meet.
constexpr std::size_t many_shapes = 12;

class ToiSolver {
public:
    explicit ToiSolver(StepContext& step)
        : step_(step), world_(step.world), finalize_(step.scratch.finalize) {}

    void run() {
        ASSERT(finalize_.fast.size() == world_.bodies.awake.size());
        std::vector<std::uint32_t> known;
        for (std::uint32_t i = 0; i < finalize_.fast.size(); i++) {
            if (is_fast(i)) fast_.push_back(i);
            if (is_fast(i) || finalize_.deflected[i] != 0) known.push_back(i);
        }
        any_bounces_ = !step_.scratch.contacts.bouncing.empty();
        motions_.note(step_, known, [&](std::uint32_t awake) { return known_sweep(awake); });
        note_passes();
        start_toi_bodies();
        if (bodies_.empty()) return;
        // Every impact uses up one of somebody's, and between two there are so many legs: this
        // ends.
        while (!is_stopped(step_)) {
            find_impacts();
            const std::size_t first = next_to_come();
            if (next_[first] > 1) break;
            if (bodies_[first].fraction <= bodies_[first].sweep.until)
                impact(first);
            else
                begin_leg(first);
        }
        report_bounces(world_.events, bounces_);
        // They are placed when whom they met is awake: move_toi_bodies().
        for (ToiBody& t : bodies_)
            if (t.changed) step_.scratch.continuous.changed.push_back(std::move(t));
    }

private:
    static constexpr std::uint32_t no_index = 0xffffffff;

    // What next happens to a TOI body. Impacts of one moment go on through what touches, the
    // hardest first: so a row of balls hands a push on from one to the next.
    struct Event {
        double at = 0, closing = 0;  // fraction of the step, m/s
        std::size_t toi_index = 0;
        friend bool operator>(const Event& x, const Event& y) {
            if (x.at != y.at) return x.at > y.at;
            if (x.closing != y.closing) return x.closing < y.closing;
            return x.toi_index > y.toi_index;
        }
    };

    // Index of the TOI body that a body is, or nobody.
    std::uint32_t toi_body_of(std::uint32_t body) const {
        return where_.empty() ? no_index : where_[body];
    }
    std::size_t add(std::uint32_t body, bool fast) {
        if (where_.empty()) where_.resize(world_.bodies.cold.size(), no_index);
        ASSERT(where_[body] == no_index);
        where_[body] = static_cast<std::uint32_t>(bodies_.size());
        ToiBody t;
        t.body = body;
        t.fast = fast;
        if (!fast && any_bounces_) {
            const BodyCold& cold = world_.bodies.cold[body];
            t.held = is_supported(cold);
            if (!t.held) t.gain = gain_in_free_fall(world_, cold, step_.dt);
        }
        bodies_.push_back(std::move(t));
        next_.push_back(Impact::never);
        enqueue_check(bodies_.size() - 1);
        return bodies_.size() - 1;
    }

    // Whether contacts or joints hold a body, or sleep does.
    bool is_supported(const BodyCold& cold) const {
        if (cold.set != BodySet::awake || cold.asleep_in_place || cold.first_joint != none)
            return true;
        if (cold.constraints == 0) return false;
        bool borne = false;
        for_each_manifold(world_.contacts, cold, [&](std::uint32_t contact) {
            borne = borne || world_.contacts.contacts[contact].touching;
        });
        return borne;
    }
    // What a step adds to the velocity of a body that nobody follows, m/s.
    Vec3 gain_of(const BodyCold& cold) const {
        return any_bounces_ && !is_supported(cold) ? gain_in_free_fall(world_, cold, step_.dt)
                                                   : Vec3{};
    }
    // Whether a velocity takes a body away from all that bore it.
    bool leaves_its_support(std::uint32_t body, Vec3 v, double at) const {
        const double least = 0.05;  // m/s
        bool leaves = true;
        for_each_manifold(world_.contacts, world_.bodies.cold[body], [&](std::uint32_t contact) {
            const Contact& c = world_.contacts.contacts[contact];
            if (!leaves || !c.touching) return;
            const bool is_a = c.body_a == body;
            const Vec3 u = speed_of(is_a ? c.body_b : c.body_a, at).v - v;
            const ContactLaneRef lane_ref = lane_ref_of(world_.graph, c);
            leaves = dot(normal_of(lane_ref), u) * (is_a ? 1 : -1) > least;
        });
        return leaves;
    }

    void note_next(std::size_t k) {
        const ToiBody& t = bodies_[k];
        next_[k] = t.fast ? std::min(t.fraction, t.sweep.until < 1 ? t.sweep.until : Impact::never)
                          : Impact::never;
    }
    // Enters the TOI body with what next_ says of it; entries that next_ contradicts are passed
    // over.
    void queue(std::size_t k) {
        const ToiBody& t = bodies_[k];
        if (t.fraction <= 1) dependents_.add(world_.shapes.shapes[t.other_shape].body, k);
        queue_.push_back({next_[k], t.fraction <= t.sweep.until ? t.closing : 0, k});
        std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
    }
    // The TOI body to which something happens first; of several the first.
    std::size_t next_to_come() {
        while (!queue_.empty() && queue_.front().at != next_[queue_.front().toi_index]) {
            std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
            queue_.pop_back();
        }
        return queue_.empty() ? 0 : queue_.front().toi_index;
    }
    // Whether it is a body that a TOI body meets next, as far as is known.
    bool hits_next(std::size_t k, std::uint32_t body) const {
        const ToiBody& t = bodies_[k];
        return t.fraction <= 1 && world_.shapes.shapes[t.other_shape].body == body;
    }
    // Whether it looks for impacts itself, whenever it goes another way.
    bool searches(std::size_t k) const { return bodies_[k].fast && !is_exhausted(bodies_[k]); }
    void recheck(std::size_t k) {
        bodies_[k].checked = false;
        enqueue_check(k);
    }
    void recheck_against(std::size_t k, std::uint32_t body) {
        bodies_[k].deflected_bodies.push_back(body);
        enqueue_check(k);
    }
    void enqueue_check(std::size_t k) {
        ToiBody& t = bodies_[k];
        if (t.fast && !t.queued) to_check_.push_back(k);
        t.queued = t.fast;
    }

    void begin_leg(std::size_t index) {
        next_leg(world_, bodies_[index], step_.dt);
        update_dependents(index);
    }

    bool is_fast(std::uint32_t awake) const {
        return finalize_.fast[awake] != 0 && finalize_.not_finite[awake] == 0;
    }
    Sweep known_sweep(std::uint32_t awake) const {
        return even_sweep(finalize_.previous[awake], world_.bodies.awake[awake], step_.dt);
    }

    // Most fast bodies fly through nothing, or along with others that fall beside them: those need
    // no sweep. Whom one may meet on the way that was foreseen is among its contacts; a body that
    // was thrown off that way asks the trees.
    void start_toi_bodies() {
        find_sweep_candidates(step_, motions_, fast_);
        const std::vector<std::vector<std::uint32_t>>& sweep_candidates =
            step_.scratch.continuous.sweep_candidates;
        std::vector<std::size_t> starting;  // by TOI body: index of the fast body
        for (std::size_t k = 0; k < fast_.size(); k++)
            if (!sweep_candidates[k].empty() || finalize_.left_predicted_aabb[fast_[k]] != 0)
                starting.push_back(k);
        if (starting.empty()) return;
        bodies_.reserve(starting.size() + starting.size() / 4);
        for (const std::size_t k : starting) add(world_.bodies.awake[fast_[k]].body, true);
        step_.thread_pool.run(static_cast<int>(starting.size()), 8, [&](int begin, int end) {
            for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); k++) {
                start(bodies_[k], sweep_candidates[starting[k]]);
                note_manifolds(bodies_[k], step_.scratch.continuous.manifolds[starting[k]]);
            }
        });
        step_.thread_pool.finish();  // the trees: finalize.cpp
        world_.shapes.statics->flush();
        for (ToiBody& t : bodies_)
            if (has_left_predicted_aabb(t)) candidates_.find(t.body, t.swept, t.candidates);
    }
    bool has_left_predicted_aabb(const ToiBody& t) const {
        return finalize_.left_predicted_aabb[world_.bodies.cold[t.body].at] != 0;
    }
    // The shapes among a fast body's contacts that it may meet.
    void find_contacts_on_path(std::uint32_t awake, std::vector<std::uint32_t>& found) const {
        found.clear();
        const std::uint32_t body = world_.bodies.awake[awake].body;
        const BodyCold& cold = world_.bodies.cold[body];
        const SweptMotion motion = motions_.of(world_, body);
        const auto& contacts = world_.contacts.contacts;
        for (std::uint32_t edge = cold.first_edge; edge != none;) {
            const Contact& c = contacts[edge / 2];
            edge = c.next[edge % 2];
            if (c.parent != none) continue;
            const bool is_a = c.body_a == body;
            const std::uint32_t other = is_a ? c.shape_b : c.shape_a;
            const std::uint32_t hit_body = is_a ? c.body_b : c.body_a;
            if (motions_.may_collide(world_, motion, cold, hit_body, other,
                                     [&] { return bounces_alone(step_, c.shape_a, c.shape_b); }))
                found.push_back(other);
        }
    }

    // How a body goes on from its last impact or, without one, in the whole step.
    SweptMotion motion_now(std::uint32_t body) const {
        const std::uint32_t known = toi_body_of(body);
        if (known == no_index) return motions_.of(world_, body);
        const Sweep& sweep = bodies_[known].sweep;
        return {sweep.center, sweep.translation,
                length(sweep.rotation_vector) * world_.bodies.cold[body].radius};
    }

    void start(ToiBody& t, const std::vector<std::uint32_t>& hit_body) {
        begin_toi(world_, t, finalize_.previous[world_.bodies.cold[t.body].at], step_.dt);
        t.swept = swept_aabb_of(t);
        if (has_left_predicted_aabb(t)) return;
        t.candidates = hit_body;
        candidates_.tidy(t.body, t.candidates);
    }
    // How far before the surfaces of two shapes meet their sweep stops, m.
    double sweep_gap(std::uint32_t own, std::uint32_t other) const {
        const BodyCold &a = world_.bodies.cold[world_.shapes.shapes[own].body],
                       &b = world_.bodies.cold[world_.shapes.shapes[other].body];
        return tuning::sweep_gap * size_scale(size_of_pair(a, b));
    }
    Speed speed_of(std::uint32_t body, double fraction) const {
        const std::uint32_t known = toi_body_of(body);
        if (known != no_index) return speed_at(world_, bodies_[known], fraction, step_.dt);
        const BodyWarm& warm = warm_of(world_, body);
        return {warm.v - gain_of(world_.bodies.cold[body]) * (1 - fraction), warm.w};
    }
    Sweep sweep_of(std::uint32_t body) const {
        const std::uint32_t known = toi_body_of(body);
        return known != no_index ? bodies_[known].sweep : sweep_of_body(body);
    }
    // How a body moved in this step: as it did if that is known, else back from where it is, by its
    // velocity.
    Sweep sweep_of_body(std::uint32_t body) const {
        const BodyCold& cold = world_.bodies.cold[body];
        const BodyWarm& warm = warm_of(world_, body);
        if (cold.set != BodySet::awake || (warm.v == Vec3{} && warm.w == Vec3{}))
            return {0, warm.center, warm.rotation, {}, {}};
        if (motions_.knows(cold.at)) return motions_.sweep_of(cold.at);
        const Vec3 motion = (warm.v - gain_of(cold) * 0.5) * step_.dt, turn = warm.w * step_.dt;
        return {0, warm.center - motion, normalized(from_rotation_vector(-turn) * warm.rotation),
                motion, turn};
    }

    SweptShape swept(std::uint32_t shape, const Sweep& sweep) const {
        const ShapeRecord& s = world_.shapes.shapes[shape];
        return {&s.geometry, s.offset, s.axes, world_.bodies.cold[s.body].radius, sweep};
    }

    Aabb swept_aabb_of(const ToiBody& t) const {
        if (t.sweep.until < 1) {
            const Vec3 from = t.sweep.center, to = center_at(t.sweep, 1);
            return grow({min(from, to), max(from, to)},
                        world_.bodies.cold[t.body].radius + tuning::swept_margin);
        }
        Aabb box{};
        bool first = true;
        for (std::uint32_t s = world_.bodies.cold[t.body].first_shape; s != none;
             s = world_.shapes.shapes[s].next) {
            if (world_.shapes.shapes[s].trigger) continue;
            const Aabb own = swept_bounds(swept(s, t.sweep), t.sweep.from, 1);
            box = first ? own : unite(box, own);
            first = false;
        }
        return grow(box, tuning::swept_margin);
    }

    bool may_hit(std::uint32_t own, std::uint32_t other) const {
        const ShapeRecord &a = world_.shapes.shapes[own], &b = world_.shapes.shapes[other];
        if (a.body == b.body || a.trigger || b.trigger || !may_collide(a.filter, b.filter))
            return false;
        if (!passes_.empty() &&
            std::binary_search(passes_.begin(), passes_.end(), pair_key(own, other)))
            return false;
        const BodyType ta = world_.bodies.cold[a.body].type, tb = world_.bodies.cold[b.body].type;
        if (ta != BodyType::dynamic && tb != BodyType::dynamic) return false;
        return !joined_without_contact(world_.bodies, world_.joints, a.body, b.body);
    }

    // A body that goes another way from now on may meet others there, and they it.
    void refresh_candidates(std::size_t index) {
        ToiBody& t = bodies_[index];
        t.swept = swept_aabb_of(t);
        t.candidates.clear();
        if (t.fast) candidates_.find(t.body, t.swept, t.candidates);
        candidates_.set_swept_aabb(t.body, t.swept);
        recheck(index);
    }

    // Looking reads how the others go and writes down what one meets.
    void find_impacts() {
        round_++;
        for (const std::size_t k : to_check_) {
            ToiBody& t = bodies_[k];
            if (!t.checked) t.full_search_round = round_;
            world_.profile.sweeps +=
                static_cast<int>(t.checked ? t.deflected_bodies.size() : t.candidates.size());
        }
        step_.thread_pool.run(static_cast<int>(to_check_.size()), 1, [&](int begin, int end) {
            for (int k = begin; k < end; k++) find_impact(to_check_[static_cast<std::size_t>(k)]);
        });
        for (const std::size_t k : to_check_) queue(k);
        to_check_.clear();
    }
    // The first impact on the way that is left; of one that has checked, whether those that go
    // another way now are met before.
    void find_impact(std::size_t k) {
        ToiBody& t = bodies_[k];
        ASSERT(t.fast && t.queued);
        if (!t.checked) {
            t.fraction = Impact::never;
            if (searches(k))
                for (const std::uint32_t other : t.candidates)
                    if (!is_tested_by(k, world_.shapes.shapes[other].body))
                        find_impact_with(t, other);
        } else {
            for (const std::uint32_t body : t.deflected_bodies)
                for (std::uint32_t s = world_.bodies.cold[body].first_shape; s != none;
                     s = world_.shapes.shapes[s].next)
                    find_impact_with(t, s);
        }
        t.checked = true;
        t.queued = false;
        t.deflected_bodies.clear();
        note_next(k);
    }

    // Whether the other one looks at this TOI body in the same round: once is enough.
    bool is_tested_by(std::size_t k, std::uint32_t other) const {
        const std::uint32_t known = toi_body_of(other);
        if (known == no_index || known >= k || bodies_[known].full_search_round != round_)
            return false;
        const std::vector<std::uint32_t>& near = bodies_[known].candidates;
        for (std::uint32_t s = world_.bodies.cold[bodies_[k].body].first_shape; s != none;
             s = world_.shapes.shapes[s].next)
            if (!world_.shapes.shapes[s].trigger &&
                !std::binary_search(near.begin(), near.end(), s))
                return false;
        return searches(known);
    }

    // What hardly moves against the other is the contact solver's. After an impact less is left to
    // it: its contacts did not foresee the new way.
    bool moves_enough(const ToiBody& t, std::uint32_t other) const {
        const BodyCold &cold = world_.bodies.cold[t.body], &cold_other = world_.bodies.cold[other];
        if (left_to_contacts(world_, cold, cold_other)) return false;
        const std::uint32_t known = toi_body_of(other);
        const bool changed = t.changed || (known != no_index && bodies_[known].changed);
        if (changed && cold_other.type != BodyType::dynamic) return true;
        double least = motion_without_sweep(step_.scratch.contacts, cold, cold_other);
        // Of two that search one looks, for both.
        if (known != no_index && searches(known))
            least = minimum(least, motion_without_sweep(step_.scratch.contacts, cold_other, cold));
        least *= changed ? tuning::sweep_share_after_impact : tuning::sweep_share;
        const SweptMotion motion = motion_now(other);
        const double way = length(t.sweep.translation - motion.motion) +
                           length(t.sweep.rotation_vector) * cold.radius + motion.turning;
        return way * (1 - t.sweep.from) > least;
    }

    // Whether two that touch still hand on what an impact gives them: until a tenth of its speed is
    // left. Of more impacts, which in a crowd that does not bounce well would never end, the
    // contact solver sees the sum.
    bool passes_impact_on(const ToiBody& t, std::uint32_t known, std::uint32_t own,
                          std::uint32_t other) const {
        const double restitution = pair_restitution(world_.shapes.shapes[own].material,
                                                    world_.shapes.shapes[other].material);
        const int had = std::max(t.impact_chain_length,
                                 known == no_index ? 0 : bodies_[known].impact_chain_length);
        double left = 1;
        for (int k = 0; k < had; k++) left *= restitution;
        return left > tuning::min_impact_chain;
    }

    // Whether the balls around two bodies do not meet before what is met first: of most that is
    // cheap to see, before anybody asks how they go on.
    bool passes_by(const ToiBody& t, std::uint32_t other) const {
        const BodyCold &cold = world_.bodies.cold[t.body], &cold_other = world_.bodies.cold[other];
        if (cold_other.type != BodyType::dynamic) return false;
        const std::uint32_t known = toi_body_of(other);
        Vec3 center, translation;
        double from = 0, until = minimum(t.fraction, t.sweep.until);
        // What a body that nobody follows gains in the step bends its way by less than this.
        double reach = cold.radius + cold_other.radius + 2 * tuning::sweep_gap;
        if (known != no_index) {
            const Sweep& sweep = bodies_[known].sweep;
            center = sweep.center, translation = sweep.translation;
            from = sweep.from, until = minimum(until, sweep.until);
        } else {
            const SweptMotion motion = motions_.of(world_, other);
            center = motion.center, translation = motion.motion;
            reach += length(gain_in_free_fall(world_, cold_other, step_.dt)) * step_.dt;
        }
        const double start = maximum(t.sweep.from, from);
        if (start > until) return false;
        const Vec3 apart = (center + translation * (start - from)) - center_at(t.sweep, start);
        const Vec3 motion = translation - t.sweep.translation;
        const double nearest =
            clamp(-dot(apart, motion) / maximum(length_squared(motion), 1e-30), 0, until - start);
        return length_squared(apart + motion * nearest) > reach * reach;
    }

    // Whether one shape is met before all that are known.
    void find_impact_with(ToiBody& t, std::uint32_t other) {
        const std::uint32_t body = world_.shapes.shapes[other].body;
        if (passes_by(t, body)) return;
        const bool far = moves_enough(t, body);
        if (!far && !any_bounces_) return;
        const Sweep motion = sweep_of(body);
        const BodyCold &cold = world_.bodies.cold[t.body], &cold_other = world_.bodies.cold[body];
        const std::uint32_t known = toi_body_of(body);
        const bool turned = t.changed || (known != no_index && bodies_[known].changed);
        const bool of_other =
            cold_other.type == BodyType::dynamic && cold_other.inner_radius < cold.inner_radius;
        for_each_shape_near(t, other, motion, [&](std::uint32_t own) {
            if (!may_hit(own, other)) return;
            const bool bouncy = bounces_alone(step_, own, other);
            // Two that move little and have a manifold the contact solver has taken care of, unless
            // an impact has turned one of them since.
            if (!far && (!bouncy || (!turned && has_manifold(t, own, other)))) return;
            const double from = std::max(t.sweep.from, motion.from);
            const SweptShape a = swept(own, t.sweep), b = swept(other, motion);
            const bool held = !turned && is_held(t, own, other);
            const Impact hit = held ? Impact{.at_start = true}
                                    : time_of_impact(a, b, from, sweep_gap(own, other), t.fraction);
            const auto meet = [&](double fraction, const std::vector<ImpactPoint>& points,
                                  ClosesBy by = ClosesBy::velocity_or_sweep) {
                if (fraction > t.fraction) return true;
                const std::optional<double> closing =
                    closing_speed(own, other, points, motion, t, fraction, by);
                if (!closing) return false;
                if (fraction == t.fraction && *closing <= t.closing) return true;
                t.fraction = fraction;
                t.closing = *closing;
                t.at_start = fraction == from;
                t.own_shape = own;
                t.other_shape = other;
                t.points = points;
                return true;
            };
            bool touches = hit.at_start;
            if (hit.fraction < t.fraction)
                touches |= !meet(hit.fraction,
                                 points_touching(a, b, hit.fraction, 5 * sweep_gap(own, other)),
                                 far ? ClosesBy::velocity_or_sweep : ClosesBy::velocity);
            // What touches and bounces does so at once.
            if (hit.at_start && bouncy && !held && passes_impact_on(t, known, own, other)) {
                const std::vector<ImpactPoint> points =
                    points_touching(a, b, from, 5 * sweep_gap(own, other));
                if ((points.size() == 1 || !turned) && meet(from, points, ClosesBy::bouncing))
                    touches = false;
            }
            if (!far) return;
            // What touches without going in is the contact solver's, or was resolved just now. But
            // one end may rest while the other comes down, or solver and impact have left it going
            // inwards: then smaller and smaller parts of the shape, about its middle, stop where
            // the whole is in by what they lack. Of what it held only those by which it may yet go
            // through: a limb that is stopped here leaves its joints.
            SweptShape core_a = a, core_b = b;
            for (const double scale : tuning::swept_cores) {
                if (!touches) break;
                if (held && scale > tuning::held_core) continue;
                (of_other ? core_b : core_a).scale = scale;
                const Impact later =
                    time_of_impact(core_a, core_b, from, sweep_gap(own, other), t.fraction);
                touches = later.at_start;
                if (later.fraction < t.fraction)
                    touches |= !meet(later.fraction, points_along(a, b, later));
            }
            if (touches)
                meet(from, points_touching(a, b, from, 5 * sweep_gap(own, other)),
                     ClosesBy::velocity);
        });
    }

    // Where each shape of a body of many is on the rest of its way.
    const SweptShapes& swept_shapes_of(ToiBody& t) const {
        if (t.swept_shapes.known) return t.swept_shapes;
        t.swept_shapes = {.known = true, .shapes = {}, .tree = {}};
        std::size_t count = 0;
        const std::uint32_t first = world_.bodies.cold[t.body].first_shape;
        for (std::uint32_t s = first; s != none; s = world_.shapes.shapes[s].next) count++;
        if (count < many_shapes) return t.swept_shapes;
        std::vector<Aabb> boxes;
        for (std::uint32_t s = first; s != none; s = world_.shapes.shapes[s].next) {
            ASSERT(!is_plane(world_.shapes.shapes[s]));
            t.swept_shapes.shapes.push_back(s);
            boxes.push_back(swept_bounds(swept(s, t.sweep), t.sweep.from, t.sweep.until));
        }
        t.swept_shapes.tree = Bvh(boxes);
        return t.swept_shapes;
    }
    // Calls visit(own) for the body's shapes that may come near another one, in order: of few all.
    template <class Visit>
    void for_each_shape_near(ToiBody& t, std::uint32_t other, const Sweep& motion,
                             Visit&& visit) const {
        const SweptShapes& swept_shapes = swept_shapes_of(t);
        const double from = std::max(t.sweep.from, motion.from), until = motion.until;
        if (swept_shapes.tree.empty() || is_plane(world_.shapes.shapes[other]) || from > until) {
            for (std::uint32_t own = world_.bodies.cold[t.body].first_shape; own != none;
                 own = world_.shapes.shapes[own].next)
                visit(own);
            return;
        }
        const double margin =
            6 * sweep_gap(swept_shapes.shapes.front(), other) + tuning::swept_margin;
        std::vector<std::uint32_t> near;
        swept_shapes.tree.query(grow(swept_bounds(swept(other, motion), from, until), margin),
                                [&](std::uint32_t k) { near.push_back(k); });
        std::sort(near.begin(), near.end());
        for (const std::uint32_t k : near) visit(swept_shapes.shapes[k]);
    }

    // Whether the contact solver has resolved the impact of two shapes, which update_contacts
    // foresaw.
    bool is_held(ToiBody& t, std::uint32_t own, std::uint32_t other) const {
        return uses_speculative_contact(step_, own, other) && has_manifold(t, own, other);
    }
    bool has_manifold(ToiBody& t, std::uint32_t own, std::uint32_t other) const {
        const BodyCold& cold = world_.bodies.cold[t.body];
        if (cold.constraints == 0) return false;
        if (!t.manifolds_known) {
            std::vector<std::uint64_t> pairs;
            for_each_manifold(world_.contacts, cold, [&](std::uint32_t contact) {
                const Contact& c = world_.contacts.contacts[contact];
                pairs.push_back(pair_key(c.shape_a, c.shape_b));
            });
            note_manifolds(t, pairs);
        }
        return std::binary_search(t.manifolds.begin(), t.manifolds.end(), pair_key(own, other));
    }
    static void note_manifolds(ToiBody& t, const std::vector<std::uint64_t>& pairs) {
        t.manifolds_known = true;
        t.manifolds = pairs;
        std::sort(t.manifolds.begin(), t.manifolds.end());
    }

    // How two may go on inwards: by their velocities alone, or by those at a speed that bounces.
    // After the start their sweeps may do so as well: a gyroscopic body is where its sweep is, not
    // where its velocities point. Then there may be no impulse, but a new sweep from there.
    enum class ClosesBy : std::uint8_t { velocity_or_sweep, velocity, bouncing };
    // How fast they do, m/s; nothing if they do not.
    std::optional<double> closing_speed(std::uint32_t own, std::uint32_t other,
                                        const std::vector<ImpactPoint>& points, const Sweep& motion,
                                        const ToiBody& t, double fraction, ClosesBy by) const {
        const std::uint32_t body_a = world_.shapes.shapes[own].body,
                            body_b = world_.shapes.shapes[other].body;
        const Vec3 ca = center_at(t.sweep, fraction), cb = center_at(motion, fraction);
        const Speed sa = speed_of(body_a, fraction), sb = speed_of(body_b, fraction);
        const double least =
            by == ClosesBy::bouncing ? tuning::touching_impact_speed : 1e-3;  // m/s
        bool closes = false;
        double most = 0;
        for (const ImpactPoint& p : points) {
            const Vec3 ra = p.position - ca, rb = p.position - cb;
            const Vec3 u = (sb.v + cross(sb.w, rb)) - (sa.v + cross(sa.w, ra));
            const Vec3 swept = (motion.translation + cross(motion.rotation_vector, rb)) -
                               (t.sweep.translation + cross(t.sweep.rotation_vector, ra));
            most = maximum(most, -dot(u, p.normal));
            closes |= dot(u, p.normal) < -least;
            closes |= by == ClosesBy::velocity_or_sweep && dot(swept, p.normal) < -least * step_.dt;
        }
        if (!closes) return std::nullopt;
        return most;
    }

    // A body at the moment of an impact, with its masses as they stand there.
    ImpactBody end_of(std::uint32_t body, const Sweep& sweep, double fraction) {
        const BodyCold& cold = world_.bodies.cold[body];
        BodyWarm there = warm_of(world_, body);
        there.rotation = rotation_at(sweep, fraction);
        there.axes = to_matrix(there.rotation);
        const Speed speed = speed_of(body, fraction);
        ImpactBody e{
            .center = center_at(sweep, fraction), .inverse_mass = {}, .v = speed.v, .w = speed.w};
        if (cold.inverse_mass == 0) return e;
        e.inverse_mass = free_directions(cold) * cold.inverse_mass;
        e.inverse_inertia = world_inverse_inertia(there, cold);
        return e;
    }

    void impact(std::size_t index) {
        const double at = bodies_[index].fraction;
        ASSERT(at >= bodies_[index].sweep.from && at <= 1);
        ASSERT(searches(index));
        const std::uint32_t own = bodies_[index].own_shape, other = bodies_[index].other_shape;
        const std::uint32_t body_a = bodies_[index].body, body_b = world_.shapes.shapes[other].body;
        const Sweep sweep_a = bodies_[index].sweep, sweep_b = sweep_of(body_b);
        std::vector<ImpactPoint> points = std::move(bodies_[index].points);
        ASSERT(!points.empty());
        ImpactBody a = end_of(body_a, sweep_a, at), b = end_of(body_b, sweep_b, at);
        const ContactModifier modifier = modifier_for(own, other, a, b, points);
        if (!modifier.enabled) {
            passes_.push_back(pair_key(own, other));
            std::sort(passes_.begin(), passes_.end());
            return recheck(index);
        }
        world_.profile.impacts++;
        request_wake(body_a, body_b);
        if (modifier.restitution > 0 && !bodies_[index].at_start)
            put_on_parabolas(a, fall_of(body_a), b, fall_of(body_b), points, at, step_.dt);
        const HardestPoint hit =
            resolve_impact(a, b, points, modifier.restitution, modifier.friction);
        report(own, other, hit);
        report_impulse(world_, own, other, hit);
        if (modifier.restitution > 0 && hit.approach > tuning::restitution_speed)
            note_bounce(world_, own, other, hit, bounces_);
        // What stays does not go where its velocity points: nobody may follow it there.
        const std::uint32_t hit_body = toi_body_of(body_b);
        if (hit.approach <= 0 && hit_body != no_index && is_exhausted(bodies_[hit_body]))
            bodies_[index].impacts = tuning::sweep_impacts;
        else
            bodies_[index].impacts++;
        recheck(index);
        const bool bounced = modifier.restitution > 0;
        if (continue_after(body_a, a, sweep_a, at, bounced)) update_dependents(where_[body_a]);
        if (continue_after(body_b, b, sweep_b, at, bounced)) update_dependents(where_[body_b]);
    }

    Fall fall_of(std::uint32_t body) const {
        const std::uint32_t known = toi_body_of(body);
        if (known == no_index) return {gain_of(world_.bodies.cold[body]), 0};
        return {bodies_[known].gain, bodies_[known].flies_from};
    }

    // How two shapes touch that meet between sub-steps, and whether they do.
    ContactModifier modifier_for(std::uint32_t own, std::uint32_t other, const ImpactBody& a,
                                 const ImpactBody& b,
                                 const std::vector<ImpactPoint>& points) const {
        const ContactModifier modifier = material_modifier(world_, own, other);
        if (!has_pre_solve_listeners(world_.listeners) || points.empty()) return modifier;
        Vec3 point;
        for (const ImpactPoint& p : points)
            point += p.position * (1.0 / static_cast<double>(points.size()));
        const Vec3 va = a.v + cross(a.w, point - a.center), vb = b.v + cross(b.w, point - b.center);
        return call_contact_listeners(world_.listeners, world_,
                                      {own, other, points.front().normal, point, vb - va},
                                      modifier);
    }
    // What passes through each other by what listeners said before.
    void note_passes() {
        for (const ContactModifier& modifier : world_.contacts.modifiers) {
            const Contact* pair = &world_.contacts.contacts[modifier.contact];
            if (pair->parent != none) pair = &world_.contacts.contacts[pair->parent];
            if (pass_through(world_.contacts, *pair))
                passes_.push_back(pair_key(pair->shape_a, pair->shape_b));
        }
        std::sort(passes_.begin(), passes_.end());
    }

    // Who is met asleep wakes when all impacts are known, with as much around it as this one stirs.
    void request_wake(std::uint32_t body, std::uint32_t hit_body) {
        const BodyCold& cold = world_.bodies.cold[hit_body];
        if (cold.set != BodySet::sleeping && !cold.asleep_in_place) return;
        const double momentum = world_.bodies.cold[body].mass * length(warm_of(world_, body).v);
        world_.wake_requests.push_back({hit_body, mass_to_wake(momentum)});
    }

    // Who would have met a body that goes another way now looks anew, at everything. That body
    // looks at all the others itself, if it still does: of two the one that turned last knows when
    // they meet, or of something that comes before and makes it turn again. Else they look at it.
    void update_dependents(std::size_t index) {
        refresh_candidates(index);
        const std::uint32_t body = bodies_[index].body;
        if (!searches(index)) start_bodies_on(bodies_[index].swept);
        for (const std::size_t k : fast_toi_bodies_on(body, bodies_[index].swept)) {
            ToiBody& t = bodies_[k];
            if (!t.checked || is_exhausted(t)) continue;
            if (hits_next(k, body))
                recheck(k);
            else if (!searches(index))
                recheck_against(k, body);
        }
        // Those that would have met it where it no longer goes.
        dependents_.take(body, [&](std::size_t k) {
            if (next_[k] <= 1 && hits_next(k, body)) recheck(k);
        });
    }
    // Fast bodies that had nobody to meet so far, and whose way crosses a box.
    void start_bodies_on(const Aabb way) {
        std::vector<std::uint32_t> bodies;
        candidates_.for_each_swept(way, [&](std::uint32_t body) {
            if (toi_body_of(body) == no_index) bodies.push_back(body);
        });
        std::sort(bodies.begin(), bodies.end());
        std::vector<std::uint32_t> hit_body;
        for (const std::uint32_t body : bodies) {
            ToiBody& t = bodies_[add(body, true)];
            find_contacts_on_path(world_.bodies.cold[body].at, hit_body);
            start(t, hit_body);
            if (has_left_predicted_aabb(t)) candidates_.find(t.body, t.swept, t.candidates);
        }
    }
    // The other fast TOI bodies whose way crosses a box, in order. They know the body from now on.
    const std::vector<std::size_t>& fast_toi_bodies_on(std::uint32_t body, const Aabb& way) {
        hit_bodies_.clear();
        candidates_.for_each_swept(way, [&](std::uint32_t other) {
            const std::uint32_t known = toi_body_of(other);
            if (other == body) return;
            if (known != no_index && bodies_[known].fast) hit_bodies_.push_back(known);
        });
        std::sort(hit_bodies_.begin(), hit_bodies_.end());
        for (const std::size_t k : hit_bodies_) candidates_.insert(body, bodies_[k].candidates);
        return hit_bodies_;
    }

    void report(std::uint32_t own, std::uint32_t other, const HardestPoint& hit) {
        if (hit.approach < world_.def.hit_speed || hit.approach <= 0) return;
        world_.events.hits.push_back({shape_id(world_.shapes, own), shape_id(world_.shapes, other),
                                      body_id(world_.bodies, world_.shapes.shapes[own].body),
                                      body_id(world_.bodies, world_.shapes.shapes[other].body),
                                      hit.point.position, hit.point.normal, hit.approach});
    }

    // The rest of the step with the new velocity. What impulses cannot move keeps its way: false.
    bool continue_after(std::uint32_t body, const ImpactBody& end, const Sweep& old, double at,
                        bool bounced) {
        if (end.inverse_mass == Vec3{} && end.inverse_inertia == diagonal({0, 0, 0})) return false;
        const std::uint32_t known = toi_body_of(body);
        ToiBody& t = bodies_[known == no_index ? add(body, false) : known];
        const BodyCold& cold = world_.bodies.cold[body];
        if (bounced) {
            // It may bounce off the next as well.
            t.fast |= cold.continuous;
            t.impact_chain_length++;
            if (t.held && cold.first_joint == none && leaves_its_support(body, end.v, at)) {
                t.held = false;
                t.gain = gain_in_free_fall(world_, cold, step_.dt);
            }
        }
        depart(world_, t, at, {end.center, rotation_at(old, at), end.v, end.w}, step_.dt);
        return true;
    }

    StepContext& step_;
    WorldState& world_;
    const FinalizeScratch& finalize_;  // how this step moved the awake bodies
    std::vector<std::uint32_t> fast_;  // awake indices, rising
    SweptMotions motions_;             // in the whole step
    CcdCandidates candidates_{world_, finalize_.previous, fast_};
    ToiDependents dependents_;             // of TOI bodies, by whom they meet next
    std::vector<std::size_t> hit_bodies_;  // scratch
    std::vector<ToiBody> bodies_;
    std::vector<double> next_;  // by TOI body: when something next happens to it
    std::vector<std::size_t> to_check_;
    std::uint32_t round_ = 0;   // of looking
    std::vector<Event> queue_;  // heap of TOI bodies by what comes next
    bool any_bounces_ = false;
    std::vector<ContactBegin> bounces_;
    std::vector<std::uint64_t> passes_;  // pair_key() of shapes that do not hit each other; rising
    std::vector<std::uint32_t> where_;   // by body: its TOI body; empty before the first
};

}  // namespace

Skipped solve_continuous(StepContext& step) {
    step.scratch.continuous.changed.clear();
    if (step.world.bodies.awake.empty()) return no_awake_bodies;
    if (!step.world.def.continuous) return "continuous collision is off";
    if (step.scratch.finalize.any_fast == 0) return "no body moved further than half its thickness";
    ToiSolver(step).run();
    return ran;
}

Skipped move_toi_bodies(StepContext& step) {
    const std::vector<ToiBody>& changed = step.scratch.continuous.changed;
    if (changed.empty()) return "no impact between steps";
    std::vector<std::uint32_t> transformed_shape;
    for (const ToiBody& t : changed) {
        finish_toi(step.world, t, step.dt);
        transformed_shape.push_back(t.body);
    }
    std::sort(transformed_shape.begin(), transformed_shape.end());
    project_joints(step, transformed_shape);
    return ran;
}

}  // namespace jostle::physics
