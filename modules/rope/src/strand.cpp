// SPDX-License-Identifier: MIT
#include "modules/rope/src/strand.h"

#include <utility>

#include "jostle/base/check.h"
#include "jostle/physics/scalar.h"

namespace jostle::modules::rope_detail {

using namespace physics;

namespace {

// Compliance of contacts relative to the inertia of a node: small enough to be invisible, large
// enough for the accuracy of the elimination.
constexpr double contact_compliance = 1e-3, friction_compliance = 1e-4;
// Smallest compliance of links, relative to L^2 over the mass of the link.
constexpr double link_compliance = 1e-9;
// Compliance of a link that is shorter than its rest length, relative to the same.
constexpr double slack_compliance = 10;
// Compliance of links and contacts that alternate between two states, relative to the same and to 1
// / m: the sub-step resolves them as springs.
constexpr double undecided_compliance = 0.1;
// A contact pushes the strand out of an overlap at most this fast, m/s.
constexpr double push_out_speed = 1;
// Solutions after which the decisions about links and contacts are final.
constexpr int decisions_max = 8;
// Relative change of a pressure above which friction is computed again.
constexpr double pressure_tolerance = 0.05;
// Relative error of lengths below which an iteration is the last one.
constexpr double length_tolerance = 1e-6;
// Square of the relative change of a node below which forces between links are settled.
constexpr double force_tolerance = 1e-7;
// Squares of the relative change of an edge: above the first one in the last iteration, the
// solution is rejected; the second one limits an iteration.
constexpr double acceptable_change = 0.01, farthest_change = 0.0625;

// One sub-step of one strand.
class Substep {
public:
    Substep(Strand& strand, const SubstepInput& input, StrandScratch& scratch)
        : strand_(strand),
          input_(input),
          scratch_(scratch),
          h2_(input.h * input.h),
          inverse_mass_per_length_(1 / strand.mass_per_length),
          stretch_compliance_(1 / (strand.stretch_stiffness * h2_)) {}

    void begin() {
        predict();
        choose_weights();
        begin_contacts();
    }
    // Returns whether the solution is found.
    bool iterate() {
        linearise();
        return conclude(true);
    }
    // Solves for the displacements of an iteration.
    void linearise() {
        iterations_++;
        assemble();
        solve();
    }
    // Moves to the next iterate. `settled`: forces of the coupling have changed little.
    bool conclude(bool settled) {
        bool lengths_settled = move() && settled;
        if (decided_) {
            lengths_settled = !stiffen() && lengths_settled;
        } else {
            // The step starts again if tensions or contacts differ from what it assumed.
            const bool links_agree = update_links(), contacts_agree = update_contacts();
            decided_ = (links_agree && contacts_agree) || iterations_ >= decisions_max;
            if (!decided_) move_back();
        }
        solved_ = decided_ && lengths_settled;
        return solved_;
    }
    bool may_iterate() const { return iterations_ < input_.iterations_max; }
    // Returns the number of iterations.
    int end() {
        // Without contacts, each iterate is bounded and the next sub-step continues from it.
        if (!solved_ && !acceptable_ && !input_.contacts.empty()) {
            take_soft_step();
            iterations_++;
        }
        finish();
        return iterations_;
    }

private:
    bool bends() const { return strand_.bending_stiffness > 0; }
    std::size_t nodes() const { return strand_.positions.size(); }

    Vec3 edge(std::size_t link) const {
        return strand_.positions[link + 1] - strand_.positions[link];
    }
    Vec3 start_edge(std::size_t link) const {
        return scratch_.start[link + 1] - scratch_.start[link];
    }
    Vec3 previous_edge(std::size_t link) const {
        return scratch_.previous[link + 1] - scratch_.previous[link];
    }
    static Vec3 mean(Vec3 previous, Vec3 start, Vec3 end, TimeWeights weights) {
        return start + (end - start) * weights.end + (previous - start) * weights.previous;
    }

    // Positions without internal forces are the first iterate.
    void predict() {
        StrandScratch& s = scratch_;
        s.start = strand_.positions;
        s.free_targets.resize(nodes());
        s.previous.resize(nodes());
        s.masses.resize(nodes());
        s.nodes.resize(nodes());
        s.links.resize(strand_.links());
        s.displacements.resize(nodes());
        s.changes.resize(strand_.links());
        s.multipliers.resize(strand_.links());
        for (std::size_t i = 0; i < nodes(); i++) {
            s.nodes[i].fixed = false;
            s.masses[i] = node_mass(strand_, i);
            s.previous[i] = s.start[i] - strand_.velocities[i] * input_.h;
            Vec3 acceleration = input_.gravity;
            if (!input_.forces.empty()) acceleration += input_.forces[i] * (1 / s.masses[i]);
            s.free_targets[i] = s.start[i] + strand_.velocities[i] * input_.h + acceleration * h2_;
        }
        for (const NodeLoad& load : input_.loads) s.nodes[load.node].fixed = load.fixed;
        restart();
        s.laws.assign(strand_.links(), LinkLaw::taut);
        for (std::size_t k = 0; k < strand_.links(); k++) {
            s.multipliers[k] = strand_.force_densities[k] * h2_;
            const double length = strand_.rest_lengths[k];
            if (!bends() && s.multipliers[k] <= 0 && length_squared(edge(k)) <= length * length)
                s.laws[k] = LinkLaw::slack;
        }
    }

    void restart() {
        strand_.positions = scratch_.free_targets;
        for (const NodeLoad& load : input_.loads)
            if (load.fixed) strand_.positions[load.node] = load.target;
    }

    void choose_weights() {
        StrandScratch& s = scratch_;
        s.weights.resize(strand_.links());
        for (std::size_t k = 0; k < strand_.links(); k++) s.weights[k] = weights_now(k);
        if (!bends()) return;
        s.bend_weights.resize(nodes());
        for (std::size_t i = 0; i < nodes(); i++) {
            const double before = strand_.rest_lengths[i > 0 ? i - 1 : 0];
            const double after = strand_.rest_lengths[minimum_of(i, strand_.links() - 1)];
            const double least = minimum(before, after);
            s.bend_weights[i] = weights_of(16 * strand_.bending_stiffness * h2_,
                                           s.masses[i] * least * least * least);
        }
    }
    TimeWeights weights_now(std::size_t k) const {
        const StrandScratch& s = scratch_;
        return weights_of(4 * s.multipliers[k], minimum(s.masses[k], s.masses[k + 1]));
    }
    TimeWeights weights_of(double stiffness, double mass) const {
        return input_.coupled ? impact_weights(stiffness, mass) : time_weights(stiffness, mass);
    }
    static std::size_t minimum_of(std::size_t a, std::size_t b) { return a < b ? a : b; }

    void solve() {
        StrandScratch& s = scratch_;
        const auto solve = bends() || input_.coupled ? solve_rod : solve_chain;
        solve(s.nodes, s.links, s.cross, s.elimination, s.displacements, s.changes);
    }

    // ---- assembly ----

    void assemble() {
        StrandScratch& s = scratch_;
        s.used_multipliers = s.multipliers;
        if (input_.contacts.empty())
            s.cross.clear();
        else
            s.cross.assign(strand_.links(), {});
        for (std::size_t i = 0; i < nodes(); i++) {
            s.nodes[i].diagonal = scalar_matrix(s.masses[i]);
            s.nodes[i].right = (s.free_targets[i] - strand_.positions[i]) * s.masses[i];
        }
        for (std::size_t k = 0; k < strand_.links(); k++) add_link(k);
        for (const NodeLoad& load : input_.loads) {
            if (load.fixed) continue;
            NodeRow& node = s.nodes[load.node];
            node.diagonal = node.diagonal + load.mass;
            node.right += load.mass * (load.target - strand_.positions[load.node]);
        }
        if (bends()) {
            for (std::size_t i = 1; i + 1 < nodes(); i++) add_bend(i);
            for (Clamp& clamp : input_.clamps) add_clamp(clamp);
        }
        for (StrandContact& contact : input_.contacts)
            if (contact.grip != ContactGrip::open) add_contact(contact);
        if (input_.coupled)
            for (std::size_t i = 0; i < nodes(); i++) s.nodes[i].right += s.pushes[i];
    }

    void add_link(std::size_t k) {
        StrandScratch& s = scratch_;
        const double length = strand_.rest_lengths[k], q = s.multipliers[k];
        const Vec3 e = edge(k);
        LinkRow& link = s.links[k];
        const double compliance = compliance_of(k);
        // A compressed link has no geometric stiffness of its own: it may buckle.
        const double geometric = s.weights[k].end * maximum(q, 0);
        link = {.direction = e,
                .compliance = compliance,
                .right = 0.5 * (length * length - dot(e, e)) + compliance * q,
                .next = -geometric,
                .skip = 0};
        const Vec3 force = tension_of(k);
        s.nodes[k].right += force;
        s.nodes[k + 1].right -= force;
        add_scalar(k, geometric);
        add_scalar(k + 1, geometric);
    }

    // Force of a link on its first node, times h^2.
    Vec3 tension_of(std::size_t k) const {
        return mean(previous_edge(k), start_edge(k), edge(k), scratch_.weights[k]) *
               scratch_.multipliers[k];
    }

    // Of (|e|^2 - L^2) / 2 against q h^2. A rope without bending stiffness buckles within its links
    // rather than push: a short link only resists as a spring that a sub-step resolves.
    double compliance_of(std::size_t k) const {
        const double length = strand_.rest_lengths[k];
        const double unit = length * inverse_mass_per_length_;
        if (scratch_.laws[k] == LinkLaw::slack) return unit * slack_compliance;
        if (scratch_.laws[k] == LinkLaw::undecided) return unit * undecided_compliance;
        return maximum(length * length * length * stretch_compliance_, unit * link_compliance);
    }

    void add_scalar(std::size_t node, double value) {
        Symmetric3& d = scratch_.nodes[node].diagonal;
        d.xx += value, d.yy += value, d.zz += value;
    }

    // Energy 1/2 k |D|^2 with D = e' / L' - e / L, whose length is the angle between short links,
    // and k = 2 E I / (L + L'). For links of constant length this quadratic form is the bending
    // energy (M. Bergou et al., "A quadratic bending model for inextensible surfaces", SGP 2006).
    void add_bend(std::size_t i) {
        StrandScratch& s = scratch_;
        const double before = 1 / strand_.rest_lengths[i - 1], after = 1 / strand_.rest_lengths[i];
        const double k = 2 * strand_.bending_stiffness * h2_ /
                         (strand_.rest_lengths[i - 1] + strand_.rest_lengths[i]);
        const TimeWeights weights = s.bend_weights[i];
        const Vec3 now = edge(i) * after - edge(i - 1) * before;
        const Vec3 start = start_edge(i) * after - start_edge(i - 1) * before;
        const Vec3 previous = previous_edge(i) * after - previous_edge(i - 1) * before;
        const Vec3 force = mean(previous, start, now, weights) * k;
        s.nodes[i - 1].right -= force * before;
        s.nodes[i].right += force * (before + after);
        s.nodes[i + 1].right -= force * after;
        const double stiffness = k * weights.end, middle = before + after;
        add_scalar(i - 1, stiffness * before * before);
        add_scalar(i, stiffness * middle * middle);
        add_scalar(i + 1, stiffness * after * after);
        s.links[i - 1].next -= stiffness * before * middle;
        s.links[i].next -= stiffness * middle * after;
        s.links[i - 1].skip += stiffness * before * after;
    }

    // Half a link bends between the support and the first link, so k = 2 E I / L.
    void add_clamp(Clamp& clamp) {
        StrandScratch& s = scratch_;
        const std::size_t link = clamp.last ? strand_.links() - 1 : 0;
        const std::size_t held = clamp.last ? nodes() - 1 : 0, other = clamp.last ? held - 1 : 1;
        const double inverse_length = 1 / strand_.rest_lengths[link];
        const double k = 2 * strand_.bending_stiffness * h2_ * inverse_length;
        const Vec3 force = clamp_deviation(clamp, other, held) * k;
        s.nodes[other].right -= force * inverse_length;
        s.nodes[held].right += force * inverse_length;
        const double stiffness = k * inverse_length * inverse_length;
        add_scalar(other, stiffness);
        add_scalar(held, stiffness);
        s.links[link].next -= stiffness;
    }
    Vec3 clamp_deviation(const Clamp& clamp, std::size_t other, std::size_t held) const {
        const std::size_t link = clamp.last ? strand_.links() - 1 : 0;
        return (strand_.positions[other] - strand_.positions[held]) *
                   (1 / strand_.rest_lengths[link]) -
               clamp.direction;
    }

    // For a sub-step without a consistent solution, such as a rope that is crushed: contacts act as
    // springs without friction that the sub-step resolves, and links as in the second of two linear
    // solutions. The next sub-step corrects the errors.
    void take_soft_step() {
        StrandScratch& s = scratch_;
        restart();
        for (std::size_t k = 0; k < strand_.links(); k++) {
            const double length = strand_.rest_lengths[k];
            const bool shorter = !bends() && length_squared(edge(k)) <= length * length;
            s.laws[k] = shorter ? LinkLaw::slack : LinkLaw::taut;
            s.multipliers[k] = maximum(strand_.force_densities[k], 0) * h2_;
            s.weights[k] = weights_now(k);
        }
        for (StrandContact& c : input_.contacts) {
            c.grip = overlap(c, contact_motion(c)) > 0 ? ContactGrip::smooth : ContactGrip::open;
            c.openings = 2;
            c.pressure = 0;
        }
        for (const bool last : {false, true}) {
            assemble();
            solve();
            move();
            if (last) break;
            update_links();
            move_back();
        }
        // These tensions say little about those of the next sub-step, so they grow slowly.
        for (std::size_t k = 0; k < strand_.links(); k++)
            s.multipliers[k] =
                clamp(s.multipliers[k], 0,
                      2 * maximum(strand_.force_densities[k], 0) * h2_ + s.masses[k]);
    }

    // ---- contacts ----

    Vec3 contact_point(const StrandContact& c, std::span<const Vec3> x) const {
        return x[c.link] * (1 - c.fraction) + x[c.link + 1] * c.fraction;
    }
    // Relative to the obstacle, since the start of the sub-step.
    Vec3 contact_motion(const StrandContact& c) const {
        return contact_point(c, strand_.positions) - contact_point(c, scratch_.start) - c.travel;
    }
    double contact_mass(const StrandContact& c) const {
        return scratch_.masses[c.link] * (1 - c.fraction) +
               scratch_.masses[c.link + 1] * c.fraction;
    }
    double normal_stiffness(const StrandContact& c) const {
        const double own = c.openings > 0 ? undecided_compliance : contact_compliance;
        return 1 / (own / contact_mass(c) + c.response_normal);
    }
    double tangent_stiffness(const StrandContact& c) const {
        return 1 / (friction_compliance / contact_mass(c) + c.response_tangent);
    }
    // Overlap that the contact removes in this sub-step, m.
    double overlap(const StrandContact& c, Vec3 motion) const {
        const double allowed = minimum(0, c.gap + push_out_speed * input_.h);
        return allowed - c.gap - dot(c.normal, motion);
    }

    void begin_contacts() {
        for (StrandContact& c : input_.contacts) {
            const bool closed = overlap(c, contact_motion(c)) > 0;
            if (closed && c.grip == ContactGrip::open) c.grip = ContactGrip::smooth;
            c.openings = c.flips = 0;
            c.impulse = {};
        }
    }

    Vec3 across(const StrandContact& c, Vec3 motion) const {
        return motion - c.normal * dot(c.normal, motion);
    }

    void add_contact(StrandContact& c) {
        const Vec3 motion = contact_motion(c);
        const double k = normal_stiffness(c);
        Vec3 force = c.normal * (k * overlap(c, motion));
        Symmetric3 stiffness = outer(c.normal, k);
        if (has_friction(c)) add_friction(c, across(c, motion), force, stiffness);
        const double a = 1 - c.fraction, b = c.fraction;
        StrandScratch& s = scratch_;
        s.nodes[c.link].right += force * a;
        s.nodes[c.link + 1].right += force * b;
        s.nodes[c.link].diagonal = s.nodes[c.link].diagonal + stiffness * (a * a);
        s.nodes[c.link + 1].diagonal = s.nodes[c.link + 1].diagonal + stiffness * (b * b);
        if (a == 0 || b == 0) return;
        CrossBlock& cross = s.cross[c.link];
        cross.block = cross.block + stiffness * (a * b);
        cross.any = true;
    }
    static bool has_friction(const StrandContact& c) {
        return c.friction > 0 && c.grip != ContactGrip::smooth;
    }
    void add_friction(const StrandContact& c, Vec3 slid, Vec3& force, Symmetric3& stiffness) const {
        const Symmetric3 plane = scalar_matrix(1) - outer(c.normal, 1);
        const double most = tangent_stiffness(c), limit = c.friction * c.pressure;
        const double distance = length(slid);
        if (c.grip == ContactGrip::slips) {
            force -= c.slip * limit;
            // Turning the direction of sliding costs force; sliding further does not.
            if (distance > 0)
                stiffness =
                    stiffness + (plane - outer(c.slip, 1)) * minimum(limit / distance, most);
            return;
        }
        const double k =
            c.grip == ContactGrip::drags && limit < most * distance ? limit / distance : most;
        force -= slid * k;
        stiffness = stiffness + plane * k;
    }

    // Decides for each contact how it acts. Returns whether all agree with the last solution.
    bool update_contacts() {
        bool settled = true;
        for (StrandContact& c : input_.contacts) settled = update_contact(c) && settled;
        return settled;
    }
    bool update_contact(StrandContact& c) const {
        const Vec3 motion = contact_motion(c);
        const double depth = overlap(c, motion);
        if (c.grip == ContactGrip::open) {
            if (!(depth > 0)) return true;
            c.grip = ContactGrip::smooth;
            c.pressure = 0;
            return false;
        }
        // A contact that opens a second time remains as a spring that pulls a little.
        if (!(depth > 0)) {
            c.pressure = 0;
            if (c.openings > 1) return true;
            c.openings++;
            c.grip = ContactGrip::open;
            return false;
        }
        const double before = std::exchange(c.pressure, normal_stiffness(c) * depth);
        if (c.friction == 0) return true;
        const bool same_pressure = absolute(c.pressure - before) <= pressure_tolerance * c.pressure;
        return update_grip(c, across(c, motion)) && same_pressure;
    }
    bool update_grip(StrandContact& c, Vec3 slid) const {
        const double limit = c.friction * c.pressure, distance = length(slid);
        const bool holds = distance * tangent_stiffness(c) <= limit;
        if (c.grip == ContactGrip::drags) return true;
        // Friction opposes the motion without it, unless that reverses the motion.
        if (c.grip == ContactGrip::smooth) {
            c.grip = holds ? ContactGrip::sticks : ContactGrip::slips;
            if (!holds) c.slip = slid * (1 / distance);
            return false;
        }
        if (c.grip == ContactGrip::sticks) {
            if (holds) return true;
            c.grip = c.flips > 0 ? ContactGrip::drags : ContactGrip::slips;
            c.slip = slid * (1 / distance);
            return false;
        }
        if (dot(slid, c.slip) <= 0) {
            c.flips++;
            c.grip = ContactGrip::sticks;
            return false;
        }
        const Vec3 direction = slid * (1 / distance);
        const bool same = length_squared(direction - c.slip) < 0.01;
        c.slip = direction;
        return same;
    }

    // ---- results ----

    // Changes between taut and slack. Returns whether that happened.
    bool changes_law(std::size_t k) {
        StrandScratch& s = scratch_;
        if (bends()) return false;
        if (s.laws[k] == LinkLaw::taut && s.multipliers[k] <= 0) {
            s.laws[k] = LinkLaw::slack;
            return true;
        }
        const double length = strand_.rest_lengths[k];
        if (s.laws[k] != LinkLaw::slack || length_squared(edge(k)) <= length * length) return false;
        s.laws[k] = LinkLaw::undecided;
        return true;
    }

    // The row of a node on which only links act.
    Vec3 pull_of_links(std::size_t i) const {
        const StrandScratch& s = scratch_;
        Vec3 sum = (s.free_targets[i] - strand_.positions[i]) * s.masses[i];
        if (i < strand_.links()) sum += tension_of(i);
        if (i > 0) sum -= tension_of(i - 1);
        return sum;
    }

    // Moves to the next iterate. Returns whether the lengths are settled: the error that remains is
    // of second order in the change of each edge.
    bool move() {
        StrandScratch& s = scratch_;
        bool settled = true, far = false;
        acceptable_ = true;
        for (std::size_t k = 0; k < strand_.links(); k++) {
            s.multipliers[k] += s.changes[k];
            const double change = length_squared(s.displacements[k + 1] - s.displacements[k]);
            const double length = strand_.rest_lengths[k], square = length * length;
            settled = settled && change <= 2 * length_tolerance * square;
            if (input_.coupled)
                settled = settled && length_squared(s.displacements[k]) <= force_tolerance * square;
            acceptable_ = acceptable_ && change <= acceptable_change * square;
            far = far || change > farthest_change * square;
        }
        if (far) shorten_step();
        for (std::size_t i = 0; i < nodes(); i++) strand_.positions[i] += s.displacements[i];
        return settled;
    }
    // Scales a Newton step so that no edge changes by more than a quarter of its length.
    void shorten_step() {
        StrandScratch& s = scratch_;
        double share = 1;
        for (std::size_t k = 0; k < strand_.links(); k++) {
            const double change = length_squared(s.displacements[k + 1] - s.displacements[k]);
            const double most = farthest_change * strand_.rest_lengths[k] * strand_.rest_lengths[k];
            if (share * share * change > most) share = square_root(most / change);
        }
        for (Vec3& displacement : s.displacements) displacement *= share;
    }
    void move_back() {
        for (std::size_t i = 0; i < nodes(); i++) strand_.positions[i] -= scratch_.displacements[i];
    }

    // Raises the weights of links whose tension has grown since they were chosen. Returns whether
    // there are any.
    bool stiffen() {
        bool any = false;
        for (std::size_t k = 0; k < strand_.links(); k++) {
            const TimeWeights weights = weights_now(k);
            if (weights.end <= scratch_.weights[k].end + 0.05) continue;
            scratch_.weights[k] = weights;
            any = true;
        }
        return any;
    }

    // Decides for each link whether it is taut, and how much its tension stiffens the strand.
    // Returns whether all agree with the last solution.
    bool update_links() {
        StrandScratch& s = scratch_;
        bool settled = true;
        for (std::size_t k = 0; k < strand_.links(); k++) {
            settled = !changes_law(k) && settled;
            // Most tensions change little.
            const double change = absolute(s.multipliers[k] - s.used_multipliers[k]);
            if (change <= 0.25 * s.masses[k]) continue;
            const TimeWeights weights = weights_now(k);
            const double used = s.weights[k].end * maximum(s.used_multipliers[k], 0);
            const double now = weights.end * maximum(s.multipliers[k], 0);
            if (absolute(now - used) <= 0.5 * (s.masses[k] + used)) continue;
            s.weights[k] = weights;
            settled = false;
        }
        return settled;
    }

    void finish() {
        StrandScratch& s = scratch_;
        const double inverse_h = 1 / input_.h, inverse_h2 = 1 / h2_;
        for (std::size_t i = 0; i < nodes(); i++)
            strand_.velocities[i] = (strand_.positions[i] - s.start[i]) * inverse_h;
        for (std::size_t k = 0; k < strand_.links(); k++)
            strand_.force_densities[k] = s.multipliers[k] * inverse_h2;
        // The rows of fixed nodes are the impulses on their supports, after the last iteration.
        const bool links_only = !bends() && input_.contacts.empty() && !input_.coupled;
        if (!input_.loads.empty() && !links_only) assemble();
        for (NodeLoad& load : input_.loads) {
            const Vec3 sum = !load.fixed  ? load.mass * (strand_.positions[load.node] - load.target)
                             : links_only ? pull_of_links(load.node)
                                          : s.nodes[load.node].right;
            load.impulse = sum * inverse_h;
        }
        for (Clamp& clamp : input_.clamps) {
            const std::size_t link = clamp.last ? strand_.links() - 1 : 0;
            const std::size_t held = clamp.last ? nodes() - 1 : 0,
                              other = clamp.last ? held - 1 : 1;
            const double k = 2 * strand_.bending_stiffness / strand_.rest_lengths[link];
            clamp.moment =
                cross(clamp.direction, clamp_deviation(clamp, other, held)) * (k * input_.h);
        }
        for (StrandContact& c : input_.contacts) {
            if (c.grip == ContactGrip::open) continue;
            const Vec3 motion = contact_motion(c);
            Vec3 force = c.normal * (normal_stiffness(c) * overlap(c, motion));
            Symmetric3 unused;
            if (has_friction(c)) add_friction(c, across(c, motion), force, unused);
            const Vec3 impulse = -force;
            c.impulse = impulse * inverse_h;
        }
    }

    Strand& strand_;
    const SubstepInput& input_;
    StrandScratch& scratch_;
    const double h2_;
    const double inverse_mass_per_length_, stretch_compliance_;  // m/kg, 1/(N s^2)
    int iterations_ = 0;
    bool decided_ = false, solved_ = false;
    bool acceptable_ = true;  // the edges changed little in the last iteration
};

}  // namespace

double node_mass(const Strand& strand, std::size_t node) {
    ASSERT(node < strand.positions.size());
    const double before = node > 0 ? strand.rest_lengths[node - 1] : 0;
    const double after = node < strand.links() ? strand.rest_lengths[node] : 0;
    return 0.5 * strand.mass_per_length * (before + after);
}

int advance_strand(Strand& strand, const SubstepInput& input, StrandScratch& scratch) {
    ASSERT(strand.positions.size() == strand.links() + 1 && strand.links() > 0);
    ASSERT(strand.velocities.size() == strand.positions.size());
    ASSERT(strand.force_densities.size() == strand.links() && input.h > 0);
    ASSERT(input.forces.empty() || input.forces.size() == strand.positions.size());
    Substep substep(strand, input, scratch);
    substep.begin();
    while (substep.may_iterate() && !substep.iterate()) {
    }
    scratch.iterations = substep.end();
    return scratch.iterations;
}

void advance_strands(std::span<StrandJob> jobs, StrandCoupling& coupling) {
    std::vector<Substep> substeps;
    for (StrandJob& job : jobs) {
        ASSERT(job.input.coupled && job.scratch->pushes.size() == job.strand->positions.size());
        substeps.emplace_back(*job.strand, job.input, *job.scratch);
        substeps.back().begin();
    }
    for (bool solved = false; !solved && substeps[0].may_iterate();) {
        for (Substep& substep : substeps) substep.linearise();
        const bool settled = coupling.couple(jobs);
        solved = true;
        for (Substep& substep : substeps) solved = substep.conclude(settled) && solved;
    }
    for (std::size_t k = 0; k < jobs.size(); k++) jobs[k].scratch->iterations = substeps[k].end();
}

void solve_again(const StrandJob& job) {
    StrandScratch& s = *job.scratch;
    solve_rod(s.nodes, s.links, s.cross, s.elimination, s.displacements, s.changes);
}

double strand_energy(const Strand& strand, Vec3 gravity) {
    double energy = 0;
    for (std::size_t i = 0; i < strand.positions.size(); i++)
        energy += node_mass(strand, i) *
                  (0.5 * length_squared(strand.velocities[i]) - dot(gravity, strand.positions[i]));
    for (std::size_t k = 0; k < strand.links(); k++) {
        const double strain =
            length(strand.positions[k + 1] - strand.positions[k]) / strand.rest_lengths[k] - 1;
        energy += 0.5 * strand.stretch_stiffness * strain * strain * strand.rest_lengths[k];
    }
    for (std::size_t i = 1; i + 1 < strand.positions.size(); i++) {
        const double before = strand.rest_lengths[i - 1], after = strand.rest_lengths[i];
        const Vec3 angle = (strand.positions[i + 1] - strand.positions[i]) * (1 / after) -
                           (strand.positions[i] - strand.positions[i - 1]) * (1 / before);
        energy += strand.bending_stiffness / (before + after) * length_squared(angle);
    }
    return energy;
}

}  // namespace jostle::modules::rope_detail
