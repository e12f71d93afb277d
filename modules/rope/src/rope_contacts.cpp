// SPDX-License-Identifier: MIT
#include "modules/rope/src/rope_contacts.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "jostle/base/check.h"
#include "jostle/modules/segments.h"
#include "jostle/physics/aabb.h"
#include "jostle/physics/scalar.h"
#include "modules/rope/src/rope_data.h"

namespace jostle::modules::rope_detail {

using namespace physics;

namespace {

// Share of an overlap that a contact removes in a sub-step, and its greatest speed, m/s.
constexpr double overlap_share = 0.2, separation_speed = 0.1;
// A recovery that energy limits to less than this share does not happen.
constexpr double least_recovery = 0.05;
// Contacts are looked at within this share of the sum of the radii.
constexpr double near_share = 0.5;
// A contact takes part in an iteration if its gap is less than this share of its distance.
constexpr double active_share = 0.1;
// Share of the smaller radius by which two links may move relative to each other in a sub-step, and
// the greatest factor of the number of parts for that.
constexpr double motion_share = 0.5;
constexpr int parts_max = 4;
constexpr int sweeps_max = 60;
// Greatest change by a sweep that ends it, relative to the distance.
constexpr double sweep_tolerance = 1e-5;
// Compliance of contacts relative to their response.
constexpr double relative_compliance = 1e-6;

double speed_of(const Strand& strand) {
    double most = 0;
    for (const Vec3 v : strand.velocities) most = maximum(most, length_squared(v));
    return square_root(most);
}

auto place_of(const LinkContact& contact) {
    return std::tuple(contact.link, contact.other, contact.other_link);
}

const LinkContact* saved_contact(const Rope& rope, std::uint32_t link, std::uint32_t other,
                                 std::uint32_t other_link) {
    const std::tuple place(link, other, other_link);
    const auto at = std::ranges::lower_bound(rope.link_contacts, place, {}, place_of);
    return at != rope.link_contacts.end() && place_of(*at) == place ? &*at : nullptr;
}

}  // namespace

void RopeContacts::begin_step(std::span<Rope* const> ropes, std::span<Rope* const> obstacles,
                              double dt, Vec3 gravity) {
    ropes_.assign(ropes.begin(), ropes.end());
    moving_ = ropes_.size();
    ropes_.insert(ropes_.end(), obstacles.begin(), obstacles.end());
    candidates_.clear();
    contacts_.clear();
    if (ropes_.size() == 1 && !ropes_[0]->def.collide_self) return;
    double speed = 0;
    for (const Rope* rope : ropes) speed = maximum(speed, speed_of(rope->strand));
    find_meetings();
    find_candidates(2 * dt * (speed + dt * length(gravity)));
}

// ---- the links that may touch ----

// Attachments at the same place, such as two ropes at one hook.
void RopeContacts::find_meetings() {
    meetings_.clear();
    std::vector<Link> held;
    for (std::uint32_t r = 0; r < ropes_.size(); r++)
        for (const RopeAttachment& attachment : ropes_[r]->attachments)
            held.push_back({r, attachment.node});
    for (std::size_t k = 0; k < held.size(); k++)
        for (std::size_t n = k + 1; n < held.size(); n++) {
            const Rope &a = *ropes_[held[k].rope], &b = *ropes_[held[n].rope];
            const double apart =
                length(a.strand.positions[held[k].link] - b.strand.positions[held[n].link]);
            if (apart >= a.def.radius + b.def.radius) continue;
            meetings_.push_back({held[k], held[n], apart});
            meetings_.push_back({held[n], held[k], apart});
        }
}

// The sum of the radii, or less near attachments that are closer to each other.
double RopeContacts::most_distance(const Candidate& pair) const {
    const Rope &a = *ropes_[pair.a.rope], &b = *ropes_[pair.b.rope];
    double most = a.def.radius + b.def.radius;
    const auto from = [](const Rope& rope, std::uint32_t node, std::uint32_t link) {
        double along = 0;
        for (std::uint32_t k = std::min(node, link + 1); k < std::max(node, link); k++)
            along += rope.strand.rest_lengths[k];
        return along;
    };
    for (const Meeting& meeting : meetings_) {
        if (meeting.a.rope != pair.a.rope || meeting.b.rope != pair.b.rope) continue;
        most = minimum(most, meeting.apart + 0.5 * (from(a, meeting.a.link, pair.a.link) +
                                                    from(b, meeting.b.link, pair.b.link)));
    }
    return most;
}

// `reach`: how much closer two links may come in the step, m.
void RopeContacts::find_candidates(double reach) {
    struct Bounds {
        Aabb box;
        Link link;
    };
    std::vector<Bounds> all;
    for (std::uint32_t r = 0; r < ropes_.size(); r++) {
        const Rope& rope = *ropes_[r];
        const double margin = rope.def.radius * (1 + near_share) + 0.5 * reach;
        const Vec3 more{margin, margin, margin};
        for (std::uint32_t k = 0; k < rope.strand.links(); k++) {
            const Vec3 a = rope.strand.positions[k], b = rope.strand.positions[k + 1];
            all.push_back({{min(a, b) - more, max(a, b) + more}, {r, k}});
        }
    }
    std::ranges::sort(all, [](const Bounds& a, const Bounds& b) {
        return std::tuple(a.box.low.x, a.link.rope, a.link.link) <
               std::tuple(b.box.low.x, b.link.rope, b.link.link);
    });
    for (std::size_t k = 0; k < all.size(); k++)
        for (std::size_t n = k + 1; n < all.size() && all[n].box.low.x <= all[k].box.high.x; n++) {
            if (!overlap(all[k].box, all[n].box)) continue;
            Candidate pair = ordered(all[k].link, all[n].link);
            if (!may_touch(pair)) continue;
            pair.most = most_distance(pair);
            candidates_.push_back(pair);
        }
    std::ranges::sort(candidates_, [](const Candidate& x, const Candidate& y) {
        return std::tuple(x.a.rope, x.a.link, x.b.rope, x.b.link) <
               std::tuple(y.a.rope, y.a.link, y.b.rope, y.b.link);
    });
}

RopeContacts::Candidate RopeContacts::ordered(Link a, Link b) const {
    const auto key = [this](Link x) {
        return std::tuple(x.rope >= moving_, ropes_[x.rope]->key.number, x.link);
    };
    return key(a) < key(b) ? Candidate{a, b} : Candidate{b, a};
}

bool RopeContacts::may_touch(const Candidate& pair) const {
    if (pair.a.rope >= moving_ && pair.b.rope >= moving_) return false;
    if (pair.a.rope != pair.b.rope) return true;
    const Rope& rope = *ropes_[pair.a.rope];
    if (!rope.def.collide_self) return false;
    // The nearest part of a rope that is bent by half a turn about its own radius.
    double apart = 0;
    for (std::uint32_t k = pair.a.link + 1; k < pair.b.link; k++) {
        apart += rope.strand.rest_lengths[k];
        if (apart >= pi * rope.def.radius) return true;
    }
    return false;
}

double RopeContacts::relative_speed(const Candidate& pair) const {
    const auto &a = ropes_[pair.a.rope]->strand.velocities,
               &b = ropes_[pair.b.rope]->strand.velocities;
    double most = 0;
    for (const std::uint32_t i : {pair.a.link, pair.a.link + 1})
        for (const std::uint32_t j : {pair.b.link, pair.b.link + 1})
            most = maximum(most, length_squared(a[i] - b[j]));
    return square_root(most);
}

int RopeContacts::parts_of(double h, int least) {
    double most = 0;
    speed_ = 0;
    for (const Candidate& pair : candidates_) {
        const Rope &a = *ropes_[pair.a.rope], &b = *ropes_[pair.b.rope];
        const double allowed = motion_share * minimum(a.def.radius, b.def.radius);
        const double motion = h * relative_speed(pair);
        if (motion <= maximum(most, least) * allowed) continue;
        const Vec3 a0 = a.strand.positions[pair.a.link], a1 = a.strand.positions[pair.a.link + 1];
        const Vec3 b0 = b.strand.positions[pair.b.link], b1 = b.strand.positions[pair.b.link + 1];
        const auto [s, t] = closest_on_segments(a0, a1, b0, b1, 0.5);
        const Vec3 between = a0 + (a1 - a0) * s - (b0 + (b1 - b0) * t);
        const double reach = (a.def.radius + b.def.radius) * (1 + near_share) + 2 * motion;
        if (length_squared(between) > reach * reach) continue;
        most = motion / allowed;
        speed_ = maximum(speed_, motion / h);
    }
    if (!(most > least)) return least;
    return std::max(least, static_cast<int>(minimum(most, parts_max * least - 1)) + 1);
}

// ---- contacts ----

// Finds the points, the normal and the gap. Returns whether the links are near each other.
bool RopeContacts::place(Contact& c, double most) const {
    const Rope &a = *ropes_[c.a.rope], &b = *ropes_[c.b.rope];
    const Vec3 a0 = a.strand.positions[c.a.link], a1 = a.strand.positions[c.a.link + 1];
    const Vec3 b0 = b.strand.positions[c.b.link], b1 = b.strand.positions[c.b.link + 1];
    const auto [s, t] = closest_on_segments(a0, a1, b0, b1, 0.5);
    c.apart = a0 + (a1 - a0) * s - (b0 + (b1 - b0) * t);
    double distance = length(c.apart);
    if (distance > most * (1 + near_share) + h_ * speed_) return false;
    c.at_a = s;
    c.at_b = t;
    c.is_double = is_at_next(c);
    Vec3 along = c.apart;
    const LinkContact* saved = saved_contact(a, c.a.link, b.key.number, c.b.link);
    c.distance = minimum(most, distance);
    if (saved != nullptr) {
        c.force = saved->force * (h_ * h_);
        c.distance = minimum(most, maximum(c.distance, saved->distance));
        // The axes have crossed if the normal has turned over.
        if (dot(c.apart, saved->normal) < -0.7 * distance) {
            along = -along;
            distance = -distance;
        }
    }
    if (!(c.distance > 1e-9)) return false;
    if (distance * distance > 1e-18)
        c.normal = normalized(along);
    else if (saved != nullptr)
        c.normal = saved->normal;
    else
        return false;
    c.gap = distance - c.distance;
    // Out of an overlap little by little.
    c.wanted = minimum(0, minimum((1 - overlap_share) * c.gap, c.gap + separation_speed * h_));
    return true;
}

// Whether the next link has the same contact at its start.
bool RopeContacts::is_at_next(const Contact& c) const {
    const Link next_a{c.a.rope, c.a.link + 1}, next_b{c.b.rope, c.b.link + 1};
    const auto exists = [this](Link x) { return x.link < ropes_[x.rope]->strand.links(); };
    return (c.at_a > 1 - 1e-9 && exists(next_a) && may_touch({next_a, c.b})) ||
           (c.at_b > 1 - 1e-9 && exists(next_b) && may_touch({c.a, next_b}));
}

void RopeContacts::find_contacts() {
    contacts_.clear();
    for (const Candidate& pair : candidates_) {
        Contact c{.a = pair.a, .b = pair.b};
        if (!place(c, pair.most)) continue;
        const Rope &a = *ropes_[c.a.rope], &b = *ropes_[c.b.rope];
        c.friction = square_root(a.def.friction * b.def.friction);
        if (c.is_double || dot(c.force, c.normal) < 0) c.force = {};
        if (c.friction == 0) c.force = c.normal * dot(c.normal, c.force);
        const auto add = [&](Link link, double at, double sign) {
            if (link.rope >= moving_) return;
            if (at < 1) c.ends[c.ends_count++] = {link.rope, link.link, 0, sign * (1 - at)};
            if (at > 0) c.ends[c.ends_count++] = {link.rope, link.link + 1, 0, sign * at};
        };
        add(c.a, c.at_a, 1);
        add(c.b, c.at_b, -1);
        contacts_.push_back(c);
    }
}

bool RopeContacts::begin_substep(double h) {
    h_ = h;
    find_contacts();
    for (std::size_t r = 0; r < moving_; r++)
        ropes_[r]->scratch.pushes.assign(ropes_[r]->strand.positions.size(), {});
    for (const Contact& c : contacts_)
        for (std::uint32_t k = 0; k < c.ends_count; k++)
            ropes_[c.ends[k].rope]->scratch.pushes[c.ends[k].node] += c.force * c.ends[k].weight;
    return !contacts_.empty();
}

Vec3 RopeContacts::apart(const Contact& c) const {
    const auto at = [this](Link link, double fraction) {
        const auto& x = ropes_[link.rope]->strand.positions;
        return x[link.link] * (1 - fraction) + x[link.link + 1] * fraction;
    };
    return at(c.a, c.at_a) - at(c.b, c.at_b);
}

// Since the start of the sub-step, after the displacements of the iteration.
Vec3 RopeContacts::displaced(const Contact& c, std::span<const StrandJob> jobs) const {
    Vec3 sum = apart(c) - c.apart;
    for (std::uint32_t k = 0; k < c.ends_count; k++)
        sum += jobs[c.ends[k].rope].scratch->displacements[c.ends[k].node] * c.ends[k].weight;
    return sum;
}

// ---- forces ----

bool RopeContacts::couple(std::span<StrandJob> jobs) {
    for (Contact& c : contacts_) {
        if (c.is_double) continue;
        c.moved = displaced(c, jobs);
        const double gap = c.gap + dot(c.normal, c.moved);
        c.active = c.active || c.force != Vec3{} || gap < c.wanted + active_share * c.distance;
        c.before = c.force;
    }
    activate(jobs);
    solve();
    std::vector<bool> changed(moving_, false);
    for (const Contact& c : contacts_) {
        if (!c.active) continue;
        const Vec3 change = c.force - c.before;
        if (change == Vec3{}) continue;
        for (std::uint32_t k = 0; k < c.ends_count; k++) {
            const End& end = c.ends[k];
            jobs[end.rope].scratch->pushes[end.node] += change * end.weight;
            jobs[end.rope].scratch->nodes[end.node].right += change * end.weight;
            changed[end.rope] = true;
        }
    }
    for (std::size_t r = 0; r < moving_; r++)
        if (changed[r]) solve_again(jobs[r]);
    bool settled = !limit_recovery(jobs);
    for (Contact& c : contacts_) {
        if (c.active || c.is_double) continue;
        if (c.gap + dot(c.normal, displaced(c, jobs)) >= minimum(0, c.wanted)) continue;
        c.active = true;
        settled = false;
    }
    return settled;
}

// Contacts may do as much work, while they take ropes out of overlaps, as the sub-step dissipates:
// 1/2 m |change of velocity|^2, beside what tensions and bending at or after the middle of the
// sub-step take. Reduces the recovery otherwise. Returns whether it does.
bool RopeContacts::limit_recovery(std::span<const StrandJob> jobs) {
    double work = 0, recovery = 0, dissipated = 0;  // times h^2
    for (const Contact& c : contacts_) {
        if (c.force == Vec3{}) continue;
        work += dot(c.force, displaced(c, jobs));
        recovery += dot(c.force, c.normal) * maximum(0, c.wanted - c.gap);
    }
    if (!(work > 0) || !(recovery > 0)) return false;
    for (const StrandJob& job : jobs) {
        const StrandScratch& s = *job.scratch;
        for (std::size_t i = 0; i < s.displacements.size(); i++) {
            const Vec3 end = job.strand->positions[i] + s.displacements[i];
            dissipated += 0.5 * s.masses[i] * length_squared(end - s.start[i] * 2 + s.previous[i]);
        }
    }
    if (work <= dissipated * (1 + 1e-3)) return false;
    double share = 1 - (work - dissipated) / recovery;
    if (share < least_recovery) share = 0;
    for (Contact& c : contacts_)
        if (c.wanted > c.gap) c.wanted = c.gap + (c.wanted - c.gap) * share;
    return true;
}

void RopeContacts::activate(std::span<const StrandJob> jobs) {
    responses_.resize(moving_);
    for (StrandResponse& response : responses_) response.nodes.clear();
    for (const Contact& c : contacts_)
        for (std::uint32_t k = 0; c.active && k < c.ends_count; k++)
            responses_[c.ends[k].rope].nodes.push_back(c.ends[k].node);
    for (std::size_t r = 0; r < moving_; r++) {
        StrandResponse& response = responses_[r];
        if (response.nodes.empty()) continue;
        std::ranges::sort(response.nodes);
        const auto rest = std::ranges::unique(response.nodes);
        response.nodes.erase(rest.begin(), rest.end());
        const StrandScratch& scratch = *jobs[r].scratch;
        response.compliance.compute(scratch.links, scratch.elimination, response.nodes);
        response.moved.assign(response.nodes.size(), {});
    }
    columns_.clear();
    for (Contact& c : contacts_)
        if (c.active) add_response(c);
}

void RopeContacts::add_response(Contact& c) {
    for (std::uint32_t k = 0; k < c.ends_count; k++) {
        const auto& nodes = responses_[c.ends[k].rope].nodes;
        const auto at = std::ranges::lower_bound(nodes, c.ends[k].node);
        c.ends[k].slot = static_cast<std::uint32_t>(at - nodes.begin());
    }
    const bool alone = c.a.rope == c.b.rope || c.b.rope >= moving_;
    for (int side = 0; side < (alone ? 1 : 2); side++) {
        const std::uint32_t rope = side == 0 ? c.a.rope : c.b.rope;
        const StrandResponse& response = responses_[rope];
        c.columns[side] = columns_.size();
        for (std::size_t i = 0; i < response.nodes.size(); i++) {
            Mat3 sum = diagonal({0, 0, 0});
            for (std::uint32_t k = 0; k < c.ends_count; k++)
                if (c.ends[k].rope == rope)
                    sum = sum + response.compliance.block(i, c.ends[k].slot) * c.ends[k].weight;
            columns_.push_back(sum);
        }
    }
    c.response = diagonal({0, 0, 0});
    for (std::uint32_t k = 0; k < c.ends_count; k++) {
        const int side = c.ends[k].rope == c.a.rope ? 0 : 1;
        c.response = c.response + columns_[c.columns[side] + c.ends[k].slot] * c.ends[k].weight;
    }
    c.response = to_matrix(symmetric_part(c.response));
    const Vec3 helper = absolute(c.normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    c.tangents[0] = normalized(cross(c.normal, helper));
    c.tangents[1] = cross(c.normal, c.tangents[0]);
    const Vec3 u = c.response * c.tangents[0], v = c.response * c.tangents[1];
    const double uu = dot(c.tangents[0], u), uv = dot(c.tangents[0], v), vv = dot(c.tangents[1], v),
                 nn = dot(c.normal, c.response * c.normal);
    const double least = 1e-12;
    c.normal_step = 1 / (nn * (1 + relative_compliance) + least);
    const double middle = 0.5 * (uu + vv), half = 0.5 * (uu - vv);
    c.slip_step = 1 / (middle + square_root(half * half + uv * uv) + least);
    const double a = uu * (1 + relative_compliance) + least,
                 b = vv * (1 + relative_compliance) + least, inverse = 1 / (a * b - uv * uv);
    c.sticking[0] = b * inverse;
    c.sticking[1] = -uv * inverse;
    c.sticking[2] = a * inverse;
}

void RopeContacts::solve() {
    bool any = true;
    for (int sweep = 0; any && sweep < sweeps_max; sweep++) {
        any = false;
        for (Contact& c : contacts_)
            if (c.active && update(c) > sweep_tolerance * c.distance) any = true;
    }
}

// Returns how far the change of the force moves the points, m.
double RopeContacts::update(Contact& c) {
    Vec3 moved = c.moved;
    for (std::uint32_t k = 0; k < c.ends_count; k++)
        moved += responses_[c.ends[k].rope].moved[c.ends[k].slot] * c.ends[k].weight;
    const double before = dot(c.normal, c.force);
    const double error = c.wanted - c.gap - dot(c.normal, moved);
    const double normal = maximum(0, before + c.normal_step * error);
    Vec3 change = c.normal * (normal - before);
    if (c.friction > 0) {
        const Vec3 slid = moved + c.response * change;
        const double x = dot(c.tangents[0], slid), y = dot(c.tangents[1], slid);
        const double fx = dot(c.tangents[0], c.force), fy = dot(c.tangents[1], c.force);
        const double limit = c.friction * normal;
        double gx = fx - c.sticking[0] * x - c.sticking[1] * y;
        double gy = fy - c.sticking[1] * x - c.sticking[2] * y;
        if (gx * gx + gy * gy > limit * limit) {
            gx = fx - c.slip_step * x;
            gy = fy - c.slip_step * y;
            const double size = square_root(gx * gx + gy * gy);
            if (size > limit) {
                gx *= limit / size;
                gy *= limit / size;
            }
        }
        change += c.tangents[0] * (gx - fx) + c.tangents[1] * (gy - fy);
    }
    if (change == Vec3{}) return 0;
    apply(c, change);
    return length(c.response * change);
}

void RopeContacts::apply(Contact& c, Vec3 change) {
    c.force += change;
    const bool alone = c.a.rope == c.b.rope || c.b.rope >= moving_;
    for (int side = 0; side < (alone ? 1 : 2); side++) {
        auto& moved = responses_[side == 0 ? c.a.rope : c.b.rope].moved;
        const Mat3* column = &columns_[c.columns[side]];
        for (std::size_t i = 0; i < moved.size(); i++) moved[i] += column[i] * change;
    }
}

void RopeContacts::end_substep() {
    for (std::size_t r = 0; r < moving_; r++) ropes_[r]->link_contacts.clear();
    const double inverse = 1 / (h_ * h_);
    for (const Contact& c : contacts_)
        ropes_[c.a.rope]->link_contacts.push_back({.link = c.a.link,
                                                   .other = ropes_[c.b.rope]->key.number,
                                                   .other_link = c.b.link,
                                                   .normal = c.normal,
                                                   .distance = c.distance,
                                                   .force = c.force * inverse});
    for (std::size_t r = 0; r < moving_; r++)
        std::ranges::sort(ropes_[r]->link_contacts, {}, place_of);
}

}  // namespace jostle::modules::rope_detail
