// SPDX-License-Identifier: MIT
#include "modules/rope/src/rope_contacts.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "jostle/base/check.h"
#include "jostle/physics/aabb.h"
#include "jostle/physics/scalar.h"
#include "modules/rope/src/rope_data.h"
#include "modules/rope/src/rope_step.h"

namespace jostle::modules::rope_detail {

using namespace physics;

namespace {

// Share of an overlap that a contact removes in a sub-step, and its greatest speed, m/s.
constexpr double overlap_share = 0.2, separation_speed = 1;
// Stiffness of a contact relative to m / h^2 of its nodes.
constexpr double relative_stiffness = 30;
// Contacts are looked at within this share of the sum of the radii.
constexpr double near_share = 0.5;

// Closest points of two segments, as fractions from a0 and b0 (C. Ericson, Real-Time Collision
// Detection, 5.1.9).
std::array<double, 2> closest_on_segments(Vec3 a0, Vec3 a1, Vec3 b0, Vec3 b1) {
    const Vec3 d1 = a1 - a0, d2 = b1 - b0, r = a0 - b0;
    const double a = dot(d1, d1), e = dot(d2, d2), f = dot(d2, r), c = dot(d1, r);
    if (!(a > 0) || !(e > 0)) return {0, e > 0 ? clamp(f / e, 0, 1) : 0};
    const double b = dot(d1, d2), determinant = a * e - b * b;
    double s = determinant > 1e-12 * a * e ? clamp((b * f - c * e) / determinant, 0, 1) : 0.5;
    double t = (b * s + f) / e;
    if (t < 0) {
        t = 0;
        s = clamp(-c / a, 0, 1);
    } else if (t > 1) {
        t = 1;
        s = clamp((b - c) / a, 0, 1);
    }
    return {s, t};
}

double speed_of(const Strand& strand) {
    double most = 0;
    for (const Vec3 v : strand.velocities) most = maximum(most, length_squared(v));
    return square_root(most);
}

auto place_of(const LinkContact& contact) {
    return std::tuple(contact.link, contact.other, contact.other_link);
}

// The saved contact of two links, or of their neighbours if `near`.
const LinkContact* saved_contact(const Rope& rope, std::uint32_t link, std::uint32_t other,
                                 std::uint32_t other_link, bool near) {
    const std::uint32_t reach = near ? 1 : 0;
    const std::uint32_t first = link - std::min(link, reach);
    auto at = std::ranges::lower_bound(rope.link_contacts, std::tuple(first, 0u, 0u), {}, place_of);
    const LinkContact* best = nullptr;
    for (; at != rope.link_contacts.end() && at->link <= link + reach; ++at) {
        if (at->other != other) continue;
        const std::uint32_t apart =
            at->other_link > other_link ? at->other_link - other_link : other_link - at->other_link;
        if (apart > reach) continue;
        if (best == nullptr || at->impulse > best->impulse) best = &*at;
    }
    return best;
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
    find_candidates(2 * dt * (speed + dt * length(gravity)));
}

// ---- the links that may touch ----

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
            const Candidate pair = ordered(all[k].link, all[n].link);
            if (may_touch(pair)) candidates_.push_back(pair);
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

// ---- contacts ----

double RopeContacts::node_response(Link link, std::uint32_t end) const {
    if (link.rope >= moving_) return 0;
    return 1 / node_mass(ropes_[link.rope]->strand, link.link + end);
}

// Finds the points, the normal and the gap. Returns whether the links are near each other.
bool RopeContacts::place(Contact& c) const {
    const Rope &a = *ropes_[c.a.rope], &b = *ropes_[c.b.rope];
    const Vec3 a0 = a.strand.positions[c.a.link], a1 = a.strand.positions[c.a.link + 1];
    const Vec3 b0 = b.strand.positions[c.b.link], b1 = b.strand.positions[c.b.link + 1];
    const double radii = a.def.radius + b.def.radius;
    const auto [s, t] = closest_on_segments(a0, a1, b0, b1);
    const Vec3 apart = a0 + (a1 - a0) * s - (b0 + (b1 - b0) * t);
    double distance = length(apart);
    if (distance > radii * (1 + near_share)) return false;
    c.at_a = s;
    c.at_b = t;
    const LinkContact* saved = saved_contact(a, c.a.link, b.key.number, c.b.link, false);
    if (saved != nullptr) {
        c.preload = saved->impulse * h_;
        c.drag = saved->friction * h_;
    }
    // The axes have crossed if the normal has turned over.
    Vec3 along = apart;
    if (saved != nullptr && dot(apart, saved->normal) < -0.7 * distance && saved->impulse > 0) {
        along = -apart;
        distance = -distance;
    }
    if (length_squared(apart) > 1e-18)
        c.normal = normalized(along);
    else if (saved != nullptr)
        c.normal = saved->normal;
    else
        return false;
    c.apart = apart;
    c.gap = distance - radii;
    // Out of an overlap little by little.
    c.wanted = minimum(0, minimum((1 - overlap_share) * c.gap, c.gap + separation_speed * h_));
    c.drag -= c.normal * dot(c.drag, c.normal);
    return true;
}

void RopeContacts::find_contacts() {
    contacts_.clear();
    for (const Candidate& pair : candidates_) {
        Contact c{.a = pair.a, .b = pair.b};
        if (!place(c)) continue;
        const Rope &a = *ropes_[c.a.rope], &b = *ropes_[c.b.rope];
        const double response = (1 - c.at_a) * (1 - c.at_a) * node_response(c.a, 0) +
                                c.at_a * c.at_a * node_response(c.a, 1) +
                                (1 - c.at_b) * (1 - c.at_b) * node_response(c.b, 0) +
                                c.at_b * c.at_b * node_response(c.b, 1);
        c.stiffness = relative_stiffness / response;
        c.friction = square_root(a.def.friction * b.def.friction);
        contacts_.push_back(c);
    }
}

void RopeContacts::begin_substep(double h) {
    h_ = h;
    find_contacts();
}

Vec3 RopeContacts::apart(const Contact& c) const {
    const auto at = [this](Link link, double fraction) {
        const auto& x = ropes_[link.rope]->strand.positions;
        return x[link.link] * (1 - fraction) + x[link.link + 1] * fraction;
    };
    return at(c.a, c.at_a) - at(c.b, c.at_b);
}

Vec3 RopeContacts::force(const Contact& c, Symmetric3& stiffness, double& normal,
                         Vec3& drag) const {
    const Vec3 moved = apart(c) - c.apart;
    const double along = dot(c.normal, moved);
    normal = maximum(0, c.preload + c.stiffness * (c.wanted - c.gap - along));
    drag = {};
    stiffness = {};
    if (normal == 0) return {};
    stiffness = outer(c.normal, c.stiffness);
    if (c.friction == 0) return c.normal * normal;
    drag = c.drag - (moved - c.normal * along) * c.stiffness;
    double k = c.stiffness;
    const double size = length(drag), limit = c.friction * normal;
    if (size > limit) {
        k *= limit / size;
        drag *= limit / size;
    }
    stiffness = stiffness + (scalar_matrix(1) - outer(c.normal, 1)) * k;
    return c.normal * normal + drag;
}

void RopeContacts::add_to(const Strand& strand, StrandScratch& rows) const {
    for (const Contact& c : contacts_) {
        const bool on_a = &ropes_[c.a.rope]->strand == &strand;
        const bool on_b = c.b.rope < moving_ && &ropes_[c.b.rope]->strand == &strand;
        if (!on_a && !on_b) continue;
        Symmetric3 stiffness;
        double normal = 0;
        Vec3 drag;
        const Vec3 push = force(c, stiffness, normal, drag);
        if (normal == 0) continue;
        stiffness = stiffness * 2;
        const auto add = [&](std::uint32_t link, double at, Vec3 on_link) {
            const double a = 1 - at, b = at;
            rows.nodes[link].right += on_link * a;
            rows.nodes[link + 1].right += on_link * b;
            rows.nodes[link].diagonal = rows.nodes[link].diagonal + stiffness * (a * a);
            rows.nodes[link + 1].diagonal = rows.nodes[link + 1].diagonal + stiffness * (b * b);
            if (a == 0 || b == 0) return;
            rows.cross[link].block = rows.cross[link].block + stiffness * (a * b);
            rows.cross[link].any = true;
        };
        if (on_a) add(c.a.link, c.at_a, push);
        if (on_b) add(c.b.link, c.at_b, -push);
    }
}

void RopeContacts::end_substep() {
    for (std::size_t r = 0; r < moving_; r++) ropes_[r]->link_contacts.clear();
    for (const Contact& c : contacts_) {
        Symmetric3 unused;
        double normal = 0;
        Vec3 drag;
        static_cast<void>(force(c, unused, normal, drag));
        ropes_[c.a.rope]->link_contacts.push_back({.link = c.a.link,
                                                   .other = ropes_[c.b.rope]->key.number,
                                                   .other_link = c.b.link,
                                                   .normal = c.normal,
                                                   .impulse = normal / h_,
                                                   .friction = drag * (1 / h_)});
    }
    for (std::size_t r = 0; r < moving_; r++)
        std::ranges::sort(ropes_[r]->link_contacts, {}, place_of);
}

}  // namespace jostle::modules::rope_detail
