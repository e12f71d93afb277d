// SPDX-License-Identifier: MIT
#include "stages/stop_fast_bodies.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "collision/narrowphase/collide.h"
#include "collision/narrowphase/collide_composite.h"
#include "collision/narrowphase/collide_convex.h"
#include "collision/narrowphase/time_of_impact.h"
#include "constraints/combine.h"
#include "constraints/free_motion.h"
#include "constraints/impact.h"
#include "jostle/physics/tuning.h"
#include "state/links.h"

namespace jostle::physics {
namespace {

// One end of an impact, or one body under way.
struct Traveller {
    std::uint32_t body = none;
    // A tumbling body does not turn evenly: its way is cut into legs, each from where it really is
    // to where it really will be.
    Sweep sweep;
    Vec3 velocity, gain;  // m/s at the start of the sweep, and what forces add over a whole step
    // The spin and the attitude at one moment of the step; at others Euler's equations give it.
    double spin_at = 1;  // fraction
    Vec3 spin;           // rad/s
    Quat spin_rotation;
    Quat end_rotation;  // at the end of the step, when it is not met before
    Vec3 end_spin;
    bool fast = false;     // looks for impacts itself
    bool changed = false;  // its pose or velocity is no longer what the step made it
    int impacts = 0;
    // The first impact that is known, if any.
    bool looked = false;
    double fraction = Impact::never;
    std::uint32_t own_shape = none, other_shape = none;
    std::vector<ImpactPoint> points;
    Aabb way;                         // holds all that is left of it
    std::vector<std::uint32_t> near;  // shapes that may be in it, in order and once each
};

constexpr double leg_error = 0.01;  // rad: by which an even turn may miss a tumbling body's

// An even turn from one attitude to the other, rad, of all that end there the one most like
// `wished`: so that the way ends where the body does, however often it went round.
Vec3 way_round(Quat from, Quat to, Vec3 wished) {
    const Quat turn = to * conjugate(from);
    const Vec3 v{turn.x, turn.y, turn.z};
    const double l = length(v);
    const Vec3 axis = l > 1e-12 ? v * (1 / l) : normalized(wished);
    const double angle = 2 * arc_tangent(l, turn.w), round = 2 * pi;
    return axis * (angle + round * std::floor((dot(wished, axis) - angle) / round + 0.5));
}

class Sweeper {
public:
    explicit Sweeper(StepContext& step) : step_(step), world_(step.world) {}

    void run() {
        for (std::uint32_t i = 0; i < world_.scratch.fast.size(); i++)
            if (world_.scratch.fast[i] != 0 && world_.scratch.not_finite[i] == 0) start(i);
        if (travellers_.empty()) return;
        world_.shapes.fixed->settle();
        world_.shapes.moving->settle();
        find_near_fast();
        for (Traveller& t : travellers_) find_near(t);
        // Every impact uses up one of somebody's, and between two there are so many legs: this
        // ends.
        for (;;) {
            std::size_t first = none;
            double soonest = 1.5;
            for (std::size_t k = 0; k < travellers_.size(); k++) {
                if (!travellers_[k].fast) continue;
                if (!travellers_[k].looked) look(k);
                if (next_of(travellers_[k]) < soonest) {
                    soonest = next_of(travellers_[k]);
                    first = k;
                }
            }
            if (first == none) break;
            if (travellers_[first].fraction <= travellers_[first].sweep.until)
                impact(first);
            else
                begin_leg(first);
        }
        for (Traveller& t : travellers_)
            if (t.changed) arrive(t);
    }

private:
    std::size_t add(std::uint32_t body, const Sweep& sweep, bool fast) {
        where_.emplace(body, travellers_.size());
        Traveller t;
        t.body = body;
        t.sweep = sweep;
        t.fast = fast;
        travellers_.push_back(std::move(t));
        return travellers_.size() - 1;
    }

    // When something next happens to it.
    static double next_of(const Traveller& t) {
        return std::min(t.fraction, t.sweep.until < 1 ? t.sweep.until : Impact::never);
    }

    // The leg that begins at sweep.from, for a body that nothing but forces acts on from there on.
    void aim(Traveller& t) {
        const BodyCold& cold = world_.bodies.cold[t.body];
        const double from = t.sweep.from, left = 1 - from;
        const bool even =
            !t.fast || cold.type != BodyType::dynamic || cold.isotropic || cold.locks != 0;
        t.sweep.until = 1;
        if (!even && t.spin != Vec3{}) {
            // The middle of an even turn over h is off by |dw/dt| h^2 / 8.
            const Mat3 axes = to_matrix(t.spin_rotation);
            const Vec3 w = transposed_times(axes, t.spin);
            const double bend = length(cold.inverse_inertia * cross(w, cold.inertia * w));
            const double legs = left * step_.dt * square_root(bend / (8 * leg_error));
            if (legs > 1) t.sweep.until = from + left / std::ceil(legs);
        }
        const Quat to = t.sweep.until < 1 ? free_from(t, t.sweep.until).rotation : t.end_rotation;
        const double part = t.sweep.until - from;
        t.sweep.turn =
            part > 0 ? way_round(t.sweep.rotation, to, t.spin * (part * step_.dt)) * (1 / part)
                     : Vec3{};
    }
    void begin_leg(std::size_t index) {
        Traveller& t = travellers_[index];
        const double at = t.sweep.until;
        const FreeSpin free = free_from(t, at);
        t.velocity += t.gain * (at - t.sweep.from);
        t.sweep.center = center_at(t.sweep, at);
        t.sweep.rotation = t.spin_rotation = free.rotation;
        t.sweep.from = t.spin_at = at;
        t.spin = free.w;
        aim(t);
        look_out_for(index);
    }
    FreeSpin free_from(const Traveller& t, double fraction) const {
        BodyWarm warm = warm_of(world_, t.body);
        warm.rotation = t.spin_rotation;
        warm.axes = to_matrix(warm.rotation);
        warm.w = t.spin;
        warm.torque = {};
        return free_spin(warm, world_.bodies.cold[t.body], (fraction - t.spin_at) * step_.dt);
    }

    void start(std::uint32_t awake) {
        const BodyWarm& now = world_.bodies.awake[awake];
        const BodyWarm& before = world_.scratch.before[awake];
        const Vec3 turn = way_round(before.rotation, now.rotation, now.w * step_.dt);
        const BodyCold& cold = world_.bodies.cold[now.body];
        Traveller& t = travellers_[add(
            now.body, {0, before.center, before.rotation, now.center - before.center, turn}, true)];
        t.end_rotation = now.rotation;
        t.end_spin = now.w;
        t.velocity = now.v;
        t.spin = now.w;
        t.spin_rotation = now.rotation;
        const bool flies =
            cold.type == BodyType::dynamic && cold.lanes == 0 && cold.first_joint == none;
        if (!flies) return;
        t.velocity = before.v;
        t.gain = now.v - before.v;
        t.spin_at = 0;
        t.spin = before.w;
        t.spin_rotation = before.rotation;
        aim(t);
    }

    // The velocities of a body at a fraction of the step.
    struct Speed {
        Vec3 v, w;
    };
    Speed speed_at(std::uint32_t body, const Sweep& sweep, double fraction) const {
        const auto known = where_.find(body);
        if (known == where_.end()) {
            const BodyWarm& warm = warm_of(world_, body);
            return {warm.v, warm.w};
        }
        const Traveller& t = travellers_[known->second];
        Speed s{t.velocity + t.gain * (fraction - t.sweep.from), t.spin};
        const BodyCold& cold = world_.bodies.cold[body];
        if (cold.type != BodyType::dynamic || cold.isotropic || cold.locks != 0) return s;
        // The sweep turns evenly, a tumbling body does not. Its spin is taken over in the body's
        // own axes: seen from a slightly wrong attitude the same angular momentum would be a
        // thousandfold spin about the thin axis of a rod.
        const FreeSpin free = free_from(t, fraction);
        s.w = rotate(rotation_at(sweep, fraction) * conjugate(free.rotation), free.w);
        return s;
    }

    // How a body that is not fast moves: back from where it is, by its velocity.
    Sweep sweep_of(std::uint32_t body) {
        const auto known = where_.find(body);
        if (known != where_.end()) return travellers_[known->second].sweep;
        const BodyCold& cold = world_.bodies.cold[body];
        const BodyWarm& warm = warm_of(world_, body);
        if (cold.set != BodySet::awake || (warm.v == Vec3{} && warm.w == Vec3{}))
            return {0, warm.center, warm.rotation, {}, {}};
        const Vec3 motion = warm.v * step_.dt, turn = warm.w * step_.dt;
        return {0, warm.center - motion, normalized(from_rotation_vector(-turn) * warm.rotation),
                motion, turn};
    }

    SweptShape swept(std::uint32_t shape, const Sweep& sweep) const {
        const ShapeRecord& s = world_.shapes.shapes[shape];
        return {&s.geometry, s.offset, s.axes, world_.bodies.cold[s.body].radius, sweep};
    }

    Aabb bounds_of_way(const Traveller& t) const {
        if (t.sweep.until < 1) {
            const Vec3 from = t.sweep.center, to = center_at(t.sweep, 1);
            return grow({min(from, to), max(from, to)}, world_.bodies.cold[t.body].radius + 0.01);
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
        return grow(box, 0.01);
    }

    bool may_hit(std::uint32_t own, std::uint32_t other) const {
        const ShapeRecord &a = world_.shapes.shapes[own], &b = world_.shapes.shapes[other];
        if (a.body == b.body || a.trigger || b.trigger || !may_meet(a.filter, b.filter))
            return false;
        const BodyType ta = world_.bodies.cold[a.body].type, tb = world_.bodies.cold[b.body].type;
        if (ta != BodyType::dynamic && tb != BodyType::dynamic) return false;
        return !joined_without_contact(world_, a.body, b.body);
    }

    void add_shapes(Traveller& to, std::uint32_t body) {
        for (std::uint32_t s = world_.bodies.cold[body].first_shape; s != none;
             s = world_.shapes.shapes[s].next)
            to.near.push_back(s);
    }
    // In order and once each: of two that are met at the same moment the first counts.
    void tidy_near(Traveller& t) {
        std::sort(t.near.begin(), t.near.end());
        t.near.erase(std::unique(t.near.begin(), t.near.end()), t.near.end());
        std::erase_if(t.near, [&](std::uint32_t s) {
            return world_.shapes.shapes[s].body == t.body || world_.shapes.shapes[s].trigger;
        });
    }

    // Two fast bodies may meet where neither is any more.
    void find_near_fast() {
        std::vector<std::size_t> order(travellers_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        for (Traveller& t : travellers_) t.way = bounds_of_way(t);
        std::sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
            const double lx = travellers_[x].way.low.x, ly = travellers_[y].way.low.x;
            return lx < ly || (lx == ly && x < y);
        });
        for (std::size_t i = 0; i < order.size(); i++) {
            Traveller& x = travellers_[order[i]];
            for (std::size_t j = i + 1; j < order.size(); j++) {
                Traveller& y = travellers_[order[j]];
                if (y.way.low.x > x.way.high.x) break;
                if (!overlap(x.way, y.way)) continue;
                add_shapes(x, y.body);
                add_shapes(y, x.body);
            }
        }
    }

    void find_near(Traveller& t) {
        world_.shapes.fixed->query(t.way, 0xffffffff, t.near);
        world_.shapes.moving->query(t.way, 0xffffffff, t.near);
        for (const std::uint32_t plane : world_.shapes.planes)
            if (reaches_plane(world_, world_.shapes.shapes[plane], t.way)) t.near.push_back(plane);
        tidy_near(t);
    }

    // A body that goes another way from now on may meet others there, and they it.
    void find_near_anew(std::size_t index) {
        Traveller& t = travellers_[index];
        t.way = bounds_of_way(t);
        t.looked = false;
        t.near.clear();
        for (std::size_t k = 0; k < travellers_.size(); k++) {
            Traveller& other = travellers_[k];
            if (k == index || !overlap(other.way, t.way)) continue;
            add_shapes(t, other.body);
            if (!other.fast) continue;
            add_shapes(other, t.body);
            tidy_near(other);
        }
        if (t.fast) find_near(t);
    }

    // The first impact on the way that is left.
    void look(std::size_t k) {
        Traveller& t = travellers_[k];
        t.looked = true;
        t.fraction = Impact::never;
        if (t.impacts >= tuning::sweep_impacts) return;
        for (const std::uint32_t other : t.near) look_at(t, other);
    }

    // Whether one shape is met before all that are known.
    void look_at(Traveller& t, std::uint32_t other) {
        const Sweep motion = sweep_of(world_.shapes.shapes[other].body);
        for (std::uint32_t own = world_.bodies.cold[t.body].first_shape; own != none;
             own = world_.shapes.shapes[own].next) {
            if (!may_hit(own, other)) continue;
            const double from = std::max(t.sweep.from, motion.from);
            const Impact hit =
                time_of_impact(swept(own, t.sweep), swept(other, motion), from, tuning::sweep_gap);
            const auto meet = [&](double fraction, const std::vector<ImpactPoint>& points,
                                  bool at_start = false) {
                if (fraction >= t.fraction) return true;
                if (!closes_in(own, other, points, motion, t, fraction, at_start)) return false;
                t.fraction = fraction;
                t.own_shape = own;
                t.other_shape = other;
                t.points = points;
                return true;
            };
            bool touches = hit.at_start;
            if (hit.fraction < t.fraction)
                touches |= !meet(hit.fraction, touching(own, other, t.sweep, motion, hit.fraction));
            // What touches without going in is the contact solver's, or was resolved just now. But
            // one end may rest while the other comes down, or solver and impact have left it going
            // inwards: then smaller and smaller parts of the shape, about its middle, stop where
            // the whole is in by what they lack.
            SweptShape core = swept(own, t.sweep);
            for (const double scale : {0.95, 0.9, 0.8, 0.65, 0.45, 0.25}) {
                if (!touches) break;
                core.scale = scale;
                const Impact later =
                    time_of_impact(core, swept(other, motion), from, tuning::sweep_gap);
                touches = later.at_start;
                if (later.fraction < t.fraction)
                    touches |= !meet(later.fraction, along(own, other, t.sweep, motion, later));
            }
            if (touches) meet(from, touching(own, other, t.sweep, motion, from), true);
        }
    }

    std::vector<ImpactPoint> touching(std::uint32_t own, std::uint32_t other, const Sweep& a,
                                      const Sweep& b, double fraction) const {
        const Placed pa = placed_at(swept(own, a), fraction),
                     pb = placed_at(swept(other, b), fraction);
        std::vector<PartManifold> parts;
        if (is_composite(kind_of(*pa.geometry)) || is_composite(kind_of(*pb.geometry))) {
            collide_composite(pa, pb, 5 * tuning::sweep_gap, parts);
        } else {
            PairCache cache;
            parts.push_back({0, collide(pa, pb, 5 * tuning::sweep_gap, cache)});
        }
        std::vector<ImpactPoint> points;
        for (const PartManifold& part : parts)
            for (int k = 0; k < part.manifold.count; k++)
                points.push_back({part.manifold.point[k], part.manifold.normal});
        return points;
    }

    // Where the whole shapes meet along the normal at which a part of one met the other.
    std::vector<ImpactPoint> along(std::uint32_t own, std::uint32_t other, const Sweep& a,
                                   const Sweep& b, const Impact& impact) const {
        const Placed pa = placed_at(swept(own, a), impact.fraction),
                     pb = placed_at(swept(other, b), impact.fraction);
        const ShapeKind kind_a = kind_of(*pa.geometry), kind_b = kind_of(*pb.geometry);
        std::vector<ImpactPoint> points;
        if (is_convex(kind_a) && kind_b == ShapeKind::plane) {
            const Convex ca = convex_of(pa, impact.point);
            const Feature feature = feature_along(ca, impact.normal);
            for (int k = 0; k < feature.count; k++) {
                const Vec3 corner = feature.corner[k] + impact.normal * ca.radius;
                if (dot(corner, impact.normal) >= 0)
                    points.push_back({impact.point + corner, impact.normal});
            }
        }
        if (!is_convex(kind_a) || !is_convex(kind_b)) {
            if (points.empty()) points.push_back({impact.point, impact.normal});
            return points;
        }
        const Convex ca = convex_of(pa, pa.position), cb = convex_of(pb, pa.position);
        const Vec3 middle = impact.point - pa.position;
        const double distance =
            dot(support(cb, -impact.normal) - support(ca, impact.normal), impact.normal);
        const ContactPoints found =
            contact_points(ca, cb, {impact.normal, distance, middle, middle}, 0);
        for (int k = 0; k < found.count; k++)
            points.push_back({pa.position + found.point[k], impact.normal});
        return points;
    }

    // Whether they go on inwards there: by their velocities or, after the start, by their sweeps.
    // (A tumbling body is where its sweep is, not where its velocities point: then there may be no
    // impulse, but a new sweep from there.)
    bool closes_in(std::uint32_t own, std::uint32_t other, const std::vector<ImpactPoint>& points,
                   const Sweep& motion, const Traveller& t, double fraction, bool at_start) const {
        const std::uint32_t body_a = world_.shapes.shapes[own].body,
                            body_b = world_.shapes.shapes[other].body;
        const Vec3 ca = center_at(t.sweep, fraction), cb = center_at(motion, fraction);
        const Speed sa = speed_at(body_a, t.sweep, fraction),
                    sb = speed_at(body_b, motion, fraction);
        const double least = 1e-3;  // m/s
        for (const ImpactPoint& p : points) {
            const Vec3 ra = p.position - ca, rb = p.position - cb;
            const Vec3 u = (sb.v + cross(sb.w, rb)) - (sa.v + cross(sa.w, ra));
            const Vec3 swept = (motion.motion + cross(motion.turn, rb)) -
                               (t.sweep.motion + cross(t.sweep.turn, ra));
            if (dot(u, p.normal) < -least ||
                (!at_start && dot(swept, p.normal) < -least * step_.dt))
                return true;
        }
        return false;
    }

    // A body at the moment of an impact, with its masses as they stand there.
    ImpactBody end_of(std::uint32_t body, const Sweep& sweep, double fraction) {
        const BodyCold& cold = world_.bodies.cold[body];
        BodyWarm there = warm_of(world_, body);
        there.rotation = rotation_at(sweep, fraction);
        there.axes = to_matrix(there.rotation);
        const Speed speed = speed_at(body, sweep, fraction);
        ImpactBody e{
            .center = center_at(sweep, fraction), .inverse_mass = {}, .v = speed.v, .w = speed.w};
        if (cold.inverse_mass == 0) return e;
        e.inverse_mass = free_directions(cold) * cold.inverse_mass;
        e.inverse_inertia = world_inverse_inertia(there, cold);
        return e;
    }

    void impact(std::size_t index) {
        const double at = travellers_[index].fraction;
        const std::uint32_t own = travellers_[index].own_shape,
                            other = travellers_[index].other_shape;
        const std::uint32_t body_a = travellers_[index].body,
                            body_b = world_.shapes.shapes[other].body;
        const Sweep sweep_a = travellers_[index].sweep, sweep_b = sweep_of(body_b);
        const std::vector<ImpactPoint> points = std::move(travellers_[index].points);
        if (world_.bodies.cold[body_b].set == BodySet::sleeping) {
            wake_island(world_, world_.bodies.cold[body_b].island, world_.events.woke);
            world_.scratch.not_finite.resize(world_.bodies.awake.size(), 0);
        }
        ImpactBody a = end_of(body_a, sweep_a, at), b = end_of(body_b, sweep_b, at);
        const Material &ma = world_.shapes.shapes[own].material,
                       &mb = world_.shapes.shapes[other].material;
        report(own, other,
               resolve_impact(a, b, points, pair_restitution(ma, mb), pair_friction(ma, mb)));
        travellers_[index].impacts++;
        travellers_[index].looked = false;
        if (go_on(body_a, a, sweep_a, at)) look_out_for(where_.at(body_a));
        if (go_on(body_b, b, sweep_b, at)) look_out_for(where_.at(body_b));
    }

    // Whoever might meet a body that goes another way now looks anew: at that body or, if it would
    // have met it next, at everything.
    void look_out_for(std::size_t index) {
        find_near_anew(index);
        const Traveller& moved = travellers_[index];
        for (Traveller& t : travellers_) {
            if (!t.looked || t.impacts >= tuning::sweep_impacts) continue;
            if (t.fraction <= 1 && world_.shapes.shapes[t.other_shape].body == moved.body) {
                t.looked = false;
            } else if (overlap(t.way, moved.way)) {
                for (std::uint32_t s = world_.bodies.cold[moved.body].first_shape; s != none;
                     s = world_.shapes.shapes[s].next)
                    look_at(t, s);
            }
        }
    }

    void report(std::uint32_t own, std::uint32_t other, const HardestPoint& hit) {
        if (hit.approach < world_.def.hit_speed || hit.approach <= 0) return;
        world_.events.hits.push_back({shape_id(world_, own), shape_id(world_, other),
                                      body_id(world_, world_.shapes.shapes[own].body),
                                      body_id(world_, world_.shapes.shapes[other].body),
                                      hit.point.position, hit.point.normal, hit.approach});
    }

    // The rest of the step with the new velocity. What impulses cannot move keeps its way: false.
    bool go_on(std::uint32_t body, const ImpactBody& end, const Sweep& old, double at) {
        if (end.inverse_mass == Vec3{} && end.inverse_inertia == diagonal({0, 0, 0})) return false;
        const BodyCold& cold = world_.bodies.cold[body];
        const double left = 1 - at, dt = left * step_.dt;
        const auto known = where_.find(body);
        Traveller& t = travellers_[known == where_.end() ? add(body, old, false) : known->second];
        // From here on it flies, whatever held it before: the next step's contacts will see.
        BodyWarm there = warm_of(world_, body);
        there.rotation = rotation_at(old, at);
        there.axes = to_matrix(there.rotation);
        there.w = end.w;
        there.torque = {};
        const FreeSpin free = dt > 0 ? free_spin(there, cold, dt) : FreeSpin{there.rotation, end.w};
        t.end_rotation = free.rotation;
        t.end_spin = free.w;
        t.spin_at = at;
        t.spin = end.w;
        t.spin_rotation = there.rotation;
        t.velocity = end.v;
        const Vec3 mean = end.v + t.gain * (0.5 * left);
        t.sweep = {at, end.center, there.rotation, mean * step_.dt, {}};
        t.changed = true;
        if (t.impacts >= tuning::sweep_impacts) {  // stays here until the next step
            t.sweep.motion = {};
            return true;
        }
        // What was hit may now be fast itself.
        const double way = (length(end.v) + length(end.w) * cold.radius) * dt;
        t.fast |= cold.continuous && way > tuning::sweep_fraction * cold.inner_radius;
        aim(t);
        return true;
    }

    void arrive(Traveller& t) {
        const bool stays = t.impacts >= tuning::sweep_impacts;
        const double until = stays ? t.sweep.from : 1;
        BodyWarm& warm = warm_of(world_, t.body);
        const Vec3 center = center_at(t.sweep, until);
        world_.bodies.reach[t.body].travel +=
            length(center - warm.center) + 3.2 * world_.bodies.cold[t.body].radius;
        warm.center = center;
        warm.rotation = stays ? rotation_at(t.sweep, until) : t.end_rotation;
        warm.axes = to_matrix(warm.rotation);
        warm.v = t.velocity + t.gain * (until - t.sweep.from);
        warm.w = stays ? t.spin : t.end_spin;
        warm.quiet = 0;
        look_ahead(world_, t.body, step_.dt);
        for (std::uint32_t s = world_.bodies.cold[t.body].first_shape; s != none;
             s = world_.shapes.shapes[s].next)
            if (!fits_fat_box(world_.shapes.shapes[s], warm, step_.dt))
                refatten(world_, s, warm, step_.dt);
    }

    StepContext& step_;
    WorldState& world_;
    std::vector<Traveller> travellers_;
    std::unordered_map<std::uint32_t, std::size_t> where_;  // looked up, never walked
};

}  // namespace

void stop_fast_bodies(StepContext& step) {
    if (!step.world.def.continuous || step.world.scratch.any_fast == 0) return;
    Sweeper(step).run();
}

}  // namespace jostle::physics
