// SPDX-License-Identifier: MIT
#include "physics/src/constraints/contact_group/interior_point.h"

#include <algorithm>

#include "jostle/physics/scalar.h"

namespace jostle::physics {
namespace {

constexpr int max_iterations = 40;
// A solution that rounding keeps from the tolerance is accepted within this factor.
constexpr double last_resort = 1000;
// Compliance of a row relative to its response. It bounds the impulses where immovable bodies press
// from both sides. A load of a million times the mass sinks by 1e-8 m/s.
constexpr double compliance = 1e-12;
// The same for the change of an impulse in one iteration. It bounds the elements of the matrix, and
// with them rounding errors, and does not change the solution.
constexpr double proximal = 1e-12;
// Products of speed and impulse, with response, relative to the tolerance and to what gravity adds.
// Contacts that neither press nor part, as those of neighbours in a wall, converge with the root of
// the products only.
constexpr double idle = 300;
// Rounding errors of velocities, with a margin for the elements of the matrix.
constexpr double rounding = 1e-9;
// Friction at its limit stays this fraction of half of radius^2 within it, because the distance is
// a difference.
constexpr double least_room = 1e-11;
// A step leaves this fraction of each impulse and slack, so that none becomes zero.
constexpr double boundary = 0.01;
// Relative error of the limit of friction where it matters, and how often it is corrected. What
// remains is corrected in the next pass.
constexpr double radius_tolerance = 1e-4;
constexpr int max_corrections = 12;
// The limit does not matter if friction is at most this fraction of it, or if the error changes
// velocities by less than this fraction of what gravity adds.
constexpr double holds_below = 0.99, idle_radius = 1e-4;
// A start near the last impulses has products of at least the square of this fraction of what
// gravity adds, or of the fastest row.
constexpr double rough_tolerance = 1e-3;
// Impulses that miss by less than this fraction of what gravity adds are a good start.
constexpr double warm_share = 0.3;
// Friction starts and stays within this fraction of a disc that shrinks.
constexpr double interior = 0.95;

std::size_t at(int i) {
    ASSERT(i >= 0);
    return static_cast<std::size_t>(i);
}

// A row on two bodies.
struct SixPair {
    Six a, b;
};
SixPair sides_of(const GroupRow& row) {
    return {load_six(row.ga), load_six(row.gb)};
}
SixPair operator*(const SixPair& v, double s) {
    return {v.a * s, v.b * s};
}
SixPair operator+(const SixPair& u, const SixPair& v) {
    return {u.a + v.a, u.b + v.b};
}

// block += left right^T
void add_product(double* block, Six left, const double* right) {
    for (int c = 0; c < 6; c++) add_six(block + 6 * c, left, right[c]);
}

// The blocks of the two bodies of a contact.
class ContactBlocks {
public:
    ContactBlocks(SkylineCholesky& matrix, const GroupRow& row)
        : aa_(matrix.block(row.a, row.a)), a_is_later_(row.a > row.b) {
        if (row.b < 0) return;
        bb_ = matrix.block(row.b, row.b);
        ab_ = matrix.block(std::max(row.a, row.b), std::min(row.a, row.b));
    }
    // left right^T, where the sum of all is symmetric.
    void add(const SixPair& left, const GroupRow& right) const {
        add_product(aa_, left.a, right.ga);
        if (bb_ == nullptr) return;
        add_product(bb_, left.b, right.gb);
        add_product(ab_, a_is_later_ ? left.a : left.b, a_is_later_ ? right.gb : right.ga);
    }

private:
    double *aa_, *bb_ = nullptr, *ab_ = nullptr;
    bool a_is_later_;
};

}  // namespace

// The products of impulses and slacks are relative to the masses: products / response, so that the
// contacts of light bodies are as far from their solution as those of heavy ones.

// Half of radius^2 - |friction|^2.
double InteriorPoint::room(const GroupProblem& problem, std::size_t disc) const {
    const GroupDisc& of = problem.discs[disc];
    double square = 0;
    for (int k = 0; k < of.size; k++) {
        const double f = problem.row(of.first + k).impulse;
        square += f * f;
    }
    const double radius = discs_[disc].radius;
    return 0.5 * (radius * radius - square);
}

double InteriorPoint::radius_of(const GroupProblem& problem, const GroupContact& contact,
                                int disc) const {
    double load = 0;
    for (int i = contact.first; i < contact.first + contact.points; i++)
        load += problem.row(i).impulse;
    return problem.discs[at(disc)].factor * load;
}

// Impulses and slacks that are positive, and friction that is within its discs, around the current
// velocities. Products are about the square of the speed at which a contact closes, at least
// `least`.
void InteriorPoint::start(GroupProblem& problem, double least, double tolerance) {
    std::fill(change_.begin(), change_.end(), 0.0);  // of discs that are not active
    for (const GroupContact& contact : problem.contacts) {
        double speed = least;
        for (int i = contact.first; i < contact.first + contact.points; i++)
            speed = maximum(speed, -velocity_[at(i)]);
        for (int i = contact.first; i < contact.first + contact.points; i++) {
            GroupRow& row = problem.row(i);
            slack_[at(i)] = maximum(velocity_[at(i)], speed);
            row.impulse = maximum(row.impulse, speed * (speed / slack_[at(i)]) / row.response);
        }
        const GroupRow& normal = problem.row(contact.first);
        for (int d = contact.first_disc; d < contact.first_disc + contact.discs; d++) {
            discs_[at(d)].radius = radius_of(problem, contact, d);
            discs_[at(d)].response = normal.response;
            start_disc(problem, at(d), normal.impulse * slack_[at(contact.first)], tolerance);
        }
    }
}

// The largest speed by which the impulses miss the conditions of the rows.
double InteriorPoint::worst_miss(const GroupProblem& problem) const {
    double worst = 0;
    for (const GroupContact& contact : problem.contacts) {
        for (int i = contact.first; i < contact.first + contact.points; i++) {
            const GroupRow& row = problem.row(i);
            const double v = velocity_[at(i)];
            worst = maximum(worst, v < 0 ? -v : minimum(v, row.impulse * row.response));
        }
        for (int d = contact.first_disc; d < contact.first_disc + contact.discs; d++) {
            const GroupDisc& of = problem.discs[at(d)];
            const double radius = radius_of(problem, contact, d);
            double square = 0, speed = 0;
            for (int k = 0; k < of.size; k++) {
                const double f = problem.row(of.first + k).impulse;
                square += f * f;
                speed = maximum(speed, absolute(velocity_[at(of.first + k)]));
            }
            if (square < interior * interior * radius * radius) worst = maximum(worst, speed);
        }
    }
    return worst;
}

// Friction within its disc, and the slack for a product of slack and room.
void InteriorPoint::start_disc(GroupProblem& problem, std::size_t d, double product,
                               double tolerance) {
    const GroupDisc& of = problem.discs[d];
    Disc& disc = discs_[d];
    double square = 0;
    for (int k = 0; k < of.size; k++)
        square += problem.row(of.first + k).impulse * problem.row(of.first + k).impulse;
    disc.active = disc.radius * disc.response > 0.01 * tolerance;
    const double size = square_root(square), most = interior * disc.radius;
    if (!disc.active || size > most)
        for (int k = 0; k < of.size; k++)
            problem.row(of.first + k).impulse *= disc.active ? most / size : 0;
    if (disc.active) disc.slack = product / room(problem, d);
}

bool InteriorPoint::has_right_radius(const GroupProblem& problem, const GroupContact& contact,
                                     int d) const {
    const GroupDisc& of = problem.discs[at(d)];
    const Disc& disc = discs_[at(d)];
    const double radius = radius_of(problem, contact, d);
    double square = 0;
    for (int k = 0; k < of.size; k++)
        square += problem.row(of.first + k).impulse * problem.row(of.first + k).impulse;
    const double most = holds_below * minimum(radius, disc.radius);
    if (disc.active && square < most * most) return true;
    return absolute(radius - disc.radius) <=
           maximum(radius_tolerance * radius, idle_radius * usual_speed_ / disc.response);
}

// Sets the radii that belong to the normal impulses. Friction keeps its ratio to them, and products
// hardly change. Returns false if the radii were right.
bool InteriorPoint::correct_radii(GroupProblem& problem, double tolerance) {
    bool right = true;
    for (const GroupContact& contact : problem.contacts)
        for (int d = contact.first_disc; d < contact.first_disc + contact.discs; d++)
            right = right && has_right_radius(problem, contact, d);
    if (right) return false;
    const double mean = mean_product(problem);
    for (const GroupContact& contact : problem.contacts)
        for (int d = contact.first_disc; d < contact.first_disc + contact.discs; d++) {
            const GroupDisc& of = problem.discs[at(d)];
            Disc& disc = discs_[at(d)];
            const double before = disc.radius;
            disc.radius = radius_of(problem, contact, d);
            if (!disc.active || !(disc.radius * disc.response > 0.01 * tolerance)) {
                start_disc(problem, at(d), mean / disc.response, tolerance);
                continue;
            }
            const double ratio = disc.radius / before;
            for (int k = 0; k < of.size; k++) problem.row(of.first + k).impulse *= ratio;
            disc.slack /= ratio;
        }
    return true;
}

void InteriorPoint::begin(const GroupProblem& problem, std::span<const double> y) {
    const std::size_t rows = problem.rows.size();
    for (std::vector<double>* v : {&slack_, &weight_, &velocity_, &change_, &change_of_slack_,
                                   &product_shift_, &velocity_shift_})
        v->assign(rows, 0);
    discs_.assign(problem.discs.size(), {});
    disc_shift_.assign(problem.discs.size(), 0);
    right_.assign(y.size(), 0);
    residual_.assign(y.size(), 0);
}

// The product of slack and room of a disc that is not reduced further.
double InteriorPoint::least_product(std::size_t disc) const {
    return discs_[disc].slack * 0.5 * least_room * discs_[disc].radius * discs_[disc].radius;
}

double InteriorPoint::mean_product(const GroupProblem& problem) const {
    double sum = 0;
    int count = 0;
    for (const GroupContact& contact : problem.contacts) {
        for (int i = contact.first; i < contact.first + contact.points; i++, count++)
            sum += problem.row(i).impulse * slack_[at(i)] * problem.row(i).response;
        for (int d = contact.first_disc; d < contact.first_disc + contact.discs; d++) {
            if (!discs_[at(d)].active) continue;
            sum += discs_[at(d)].response *
                   maximum(discs_[at(d)].slack * room(problem, at(d)) - least_product(at(d)), 0);
            count++;
        }
    }
    return sum / std::max(count, 1);
}

// Weights of the current impulses and slacks, and the factorization of I + G^T W G.
void InteriorPoint::factor(const GroupProblem& problem, SkylineCholesky& matrix) {
    matrix.set_identity();
    for (const GroupContact& contact : problem.contacts) {
        const ContactBlocks blocks(matrix, problem.row(contact.first));
        for (int i = contact.first; i < contact.first + contact.points; i++) {
            const GroupRow& row = problem.row(i);
            weight_[at(i)] = 1 / (slack_[at(i)] / row.impulse + proximal * row.response);
            blocks.add(sides_of(row) * weight_[at(i)], row);
        }
        for (int d = contact.first_disc; d < contact.first_disc + contact.discs; d++) {
            const GroupDisc& of = problem.discs[at(d)];
            Disc& disc = discs_[at(d)];
            if (!disc.active) continue;
            const GroupRow& row0 = problem.row(of.first);
            const double over = disc.slack / room(problem, at(d)), f0 = row0.impulse;
            const double k00 = disc.slack + over * f0 * f0 + proximal * row0.response;
            if (of.size == 1) {
                disc.inverse[0] = 1 / k00;
                blocks.add(sides_of(row0) * disc.inverse[0], row0);
                continue;
            }
            const GroupRow& row1 = problem.row(of.first + 1);
            const double f1 = row1.impulse, k01 = over * f0 * f1,
                         k11 = disc.slack + over * f1 * f1 + proximal * row1.response;
            const double det = k00 * k11 - k01 * k01;
            disc.inverse[0] = k11 / det;
            disc.inverse[1] = -k01 / det;
            disc.inverse[2] = k00 / det;
            const SixPair side0 = sides_of(row0), side1 = sides_of(row1);
            blocks.add(side0 * disc.inverse[0] + side1 * disc.inverse[1], row0);
            blocks.add(side0 * disc.inverse[1] + side1 * disc.inverse[2], row1);
        }
    }
    matrix.factor();
}

// The velocities of the rows at y, and what y lacks to the effect of the impulses.
void InteriorPoint::find_residual(const GroupProblem& problem, std::span<const double> y) {
    std::copy(y.begin(), y.end(), residual_.begin());
    for (std::size_t i = 0; i < problem.rows.size(); i++) {
        const GroupRow& row = problem.rows[i];
        velocity_[i] = row.offset + physics::velocity_of(row, y);
        add_impulse(row, -row.impulse, residual_);
    }
}

// Newton's step to products of `product`; `corrected`: with the second-order terms of the step
// before.
void InteriorPoint::find_changes(const GroupProblem& problem, const SkylineCholesky& matrix,
                                 std::span<const double> y, double product, bool corrected) {
    const auto goal_of = [&](int d, double mean) {
        return maximum(mean / discs_[at(d)].response, least_product(at(d)));
    };
    for (std::size_t i = 0; i < y.size(); i++) right_[i] = -y[i];
    // Until the velocities are known, change_ holds what the impulses do without them.
    for (const GroupContact& contact : problem.contacts) {
        for (int i = contact.first; i < contact.first + contact.points; i++) {
            const GroupRow& row = problem.row(i);
            const double goal = product / row.response - (corrected ? product_shift_[at(i)] : 0);
            change_[at(i)] = weight_[at(i)] * (goal / row.impulse - velocity_[at(i)] -
                                               compliance * row.response * row.impulse);
            add_impulse(row, row.impulse + change_[at(i)], right_);
        }
        for (int d = contact.first_disc; d < contact.first_disc + contact.discs; d++) {
            const GroupDisc& of = problem.discs[at(d)];
            const Disc& disc = discs_[at(d)];
            if (!disc.active) continue;
            const double goal = goal_of(d, product) + (corrected ? disc_shift_[at(d)] : 0);
            const double pull = goal / room(problem, at(d));
            double r[2] = {};
            for (int k = 0; k < of.size; k++) {
                const GroupRow& row = problem.row(of.first + k);
                r[k] = -(velocity_[at(of.first + k)] +
                         (corrected ? velocity_shift_[at(of.first + k)] : 0) +
                         (compliance * row.response + pull) * row.impulse);
            }
            change_[at(of.first)] = disc.inverse[0] * r[0];
            if (of.size == 2) {
                change_[at(of.first)] += disc.inverse[1] * r[1];
                change_[at(of.first + 1)] = disc.inverse[1] * r[0] + disc.inverse[2] * r[1];
            }
            for (int k = 0; k < of.size; k++)
                add_impulse(problem.row(of.first + k),
                            problem.row(of.first + k).impulse + change_[at(of.first + k)], right_);
        }
    }
    matrix.solve(right_);
    for (const GroupContact& contact : problem.contacts) {
        for (int i = contact.first; i < contact.first + contact.points; i++) {
            const GroupRow& row = problem.row(i);
            const double goal = product / row.response - (corrected ? product_shift_[at(i)] : 0);
            change_[at(i)] -= weight_[at(i)] * physics::velocity_of(row, right_);
            change_of_slack_[at(i)] =
                (goal - slack_[at(i)] * (row.impulse + change_[at(i)])) / row.impulse;
        }
        for (int d = contact.first_disc; d < contact.first_disc + contact.discs; d++) {
            const GroupDisc& of = problem.discs[at(d)];
            Disc& disc = discs_[at(d)];
            if (!disc.active) continue;
            const GroupRow& row0 = problem.row(of.first);
            const double u0 = physics::velocity_of(row0, right_);
            double along = 0;
            if (of.size == 1) {
                change_[at(of.first)] -= disc.inverse[0] * u0;
                along = row0.impulse * change_[at(of.first)];
            } else {
                const GroupRow& row1 = problem.row(of.first + 1);
                const double u1 = physics::velocity_of(row1, right_);
                change_[at(of.first)] -= disc.inverse[0] * u0 + disc.inverse[1] * u1;
                change_[at(of.first + 1)] -= disc.inverse[1] * u0 + disc.inverse[2] * u1;
                along =
                    row0.impulse * change_[at(of.first)] + row1.impulse * change_[at(of.first + 1)];
            }
            const double goal = goal_of(d, product) + (corrected ? disc_shift_[at(d)] : 0);
            const double left = room(problem, at(d));
            disc.change_of_slack = (goal - disc.slack * left + disc.slack * along) / left;
        }
    }
}

// The largest fraction of the changes that leaves impulses, slacks and rooms positive; up to 1.
double InteriorPoint::longest_step(const GroupProblem& problem) const {
    double longest = 1;
    const auto limit = [&](double value, double change) {
        if (change < 0) longest = minimum(longest, (1 - boundary) * value / -change);
    };
    for (const GroupContact& contact : problem.contacts) {
        for (int i = contact.first; i < contact.first + contact.points; i++) {
            limit(problem.row(i).impulse, change_[at(i)]);
            limit(slack_[at(i)], change_of_slack_[at(i)]);
        }
        for (int d = contact.first_disc; d < contact.first_disc + contact.discs; d++) {
            const GroupDisc& of = problem.discs[at(d)];
            if (!discs_[at(d)].active) continue;
            limit(discs_[at(d)].slack, discs_[at(d)].change_of_slack);
            // |f + t df|^2 = radius^2 - 2 boundary room, for t > 0
            double square = 0, along = 0;
            for (int k = 0; k < of.size; k++) {
                const double df = change_[at(of.first + k)];
                square += df * df;
                along += problem.row(of.first + k).impulse * df;
            }
            const double left = 2 * (1 - boundary) * room(problem, at(d));
            if (!(square > 0)) continue;
            const double root = square_root(along * along + square * left);
            longest = minimum(longest, along > 0 ? left / (along + root) : (root - along) / square);
        }
    }
    return longest;
}

void InteriorPoint::take(GroupProblem& problem, std::span<double> y, double fraction) {
    for (std::size_t i = 0; i < y.size(); i++) y[i] += fraction * right_[i];
    for (std::size_t i = 0; i < problem.rows.size(); i++) {
        problem.rows[i].impulse += fraction * change_[i];
        slack_[i] += fraction * change_of_slack_[i];
    }
    for (Disc& disc : discs_)
        if (disc.active) disc.slack += fraction * disc.change_of_slack;
}

// No point closes. A point that presses does not open. Friction holds, or opposes sliding at its
// limit.
bool InteriorPoint::is_solved(const GroupProblem& problem, const GroupContact& contact,
                              double tolerance) const {
    const double gap = idle * tolerance * usual_speed_;
    for (int i = contact.first; i < contact.first + contact.points; i++) {
        const GroupRow& row = problem.row(i);
        const double allowed = tolerance + 2 * compliance * row.response * row.impulse;
        if (velocity_[at(i)] < -allowed) return false;
        if (velocity_[at(i)] * row.impulse * row.response > gap) return false;
    }
    for (int d = contact.first_disc; d < contact.first_disc + contact.discs; d++) {
        const GroupDisc& of = problem.discs[at(d)];
        const Disc& disc = discs_[at(d)];
        if (!disc.active) continue;
        double response = 0;
        bool holds = true, opposes = true;
        for (int k = 0; k < of.size; k++) {
            const GroupRow& row = problem.row(of.first + k);
            const double u = velocity_[at(of.first + k)];
            const double allowed =
                tolerance + 2 * compliance * row.response * absolute(row.impulse);
            holds = holds && absolute(u) <= allowed;
            opposes = opposes && absolute(u + disc.slack * row.impulse) <= allowed;
            response = maximum(response, row.response);
        }
        if (!holds && !(opposes && disc.slack * room(problem, at(d)) * response <= gap))
            return false;
    }
    return true;
}

bool InteriorPoint::is_solved(const GroupProblem& problem, double tolerance) const {
    for (const GroupContact& contact : problem.contacts)
        if (!is_solved(problem, contact, tolerance)) return false;
    for (int body = 0; body < problem.bodies; body++)
        for (int k = 0; k < 6; k++)
            if (!(absolute(residual_[at(6 * body + k)]) * problem.root[at(body)] <= tolerance))
                return false;
    return true;
}

bool InteriorPoint::still_solves(const GroupProblem& problem, std::span<const double> y,
                                 double tolerance) {
    ASSERT(velocity_.size() == problem.rows.size() && discs_.size() == problem.discs.size());
    iterations_ = 0;
    find_residual(problem, y);
    double fastest = 0;
    for (const GroupRow& row : problem.rows) fastest = maximum(fastest, absolute(row.offset));
    return is_solved(problem, maximum(tolerance, rounding * fastest));
}

void InteriorPoint::drop_idle_impulses(GroupProblem& problem) const {
    for (const GroupContact& contact : problem.contacts) {
        double load = 0;
        for (int i = contact.first; i < contact.first + contact.points; i++) {
            GroupRow& row = problem.row(i);
            if (row.impulse * row.response < slack_[at(i)]) row.impulse = 0;
            load += row.impulse;
        }
        if (load > 0) continue;
        for (int d = contact.first_disc; d < contact.first_disc + contact.discs; d++)
            for (int k = 0; k < problem.discs[at(d)].size; k++)
                problem.row(problem.discs[at(d)].first + k).impulse = 0;
    }
}

// With constant radii the problem is convex. They are corrected before each of the first
// iterations.
bool InteriorPoint::iterate(GroupProblem& problem, SkylineCholesky& matrix, std::span<double> y,
                            double tolerance) {
    int corrections = 0;
    for (iterations_ = 0; iterations_ < max_iterations; iterations_++) {
        find_residual(problem, y);
        if (iterations_ > 0 && corrections < max_corrections && correct_radii(problem, tolerance)) {
            corrections++;
            find_residual(problem, y);
        }
        if (iterations_ > 0 && is_solved(problem, tolerance)) return true;
        factor(problem, matrix);
        const double mean = mean_product(problem);
        find_changes(problem, matrix, y, 0, false);
        const double ahead = longest_step(problem);
        // Second-order terms, and the mean product after the step.
        double sum = 0;
        int count = 0;
        for (const GroupContact& contact : problem.contacts) {
            for (int i = contact.first; i < contact.first + contact.points; i++, count++) {
                product_shift_[at(i)] = change_[at(i)] * change_of_slack_[at(i)];
                sum += (problem.row(i).impulse + ahead * change_[at(i)]) *
                       (slack_[at(i)] + ahead * change_of_slack_[at(i)]) * problem.row(i).response;
            }
            for (int d = contact.first_disc; d < contact.first_disc + contact.discs; d++) {
                const GroupDisc& of = problem.discs[at(d)];
                const Disc& disc = discs_[at(d)];
                if (!disc.active) continue;
                double square = 0, along = 0;
                for (int k = 0; k < of.size; k++) {
                    const double df = change_[at(of.first + k)];
                    square += df * df;
                    along += problem.row(of.first + k).impulse * df;
                    velocity_shift_[at(of.first + k)] = disc.change_of_slack * df;
                }
                disc_shift_[at(d)] = 0.5 * disc.slack * square + disc.change_of_slack * along;
                const double reached =
                    (disc.slack + ahead * disc.change_of_slack) *
                    (room(problem, at(d)) - ahead * along - 0.5 * ahead * ahead * square);
                sum += disc.response * maximum(reached - least_product(at(d)), 0);
                count++;
            }
        }
        const double after = sum / std::max(count, 1), ratio = maximum(0, minimum(after / mean, 1));
        find_changes(problem, matrix, y,
                     maximum(mean * ratio * ratio * ratio, 0.01 * tolerance * tolerance),
                     ahead > 0.1);
        take(problem, y, longest_step(problem));
    }
    find_residual(problem, y);
    return is_solved(problem, last_resort * tolerance);
}

bool InteriorPoint::solve(GroupProblem& problem, SkylineCholesky& matrix, std::span<double> y,
                          double tolerance) {
    ASSERT(y.size() == at(6 * problem.bodies));
    begin(problem, y);
    usual_speed_ = tolerance / relative_tolerance;
    double fastest = 0;
    for (const GroupRow& row : problem.rows) fastest = maximum(fastest, absolute(row.offset));
    tolerance = maximum(tolerance, rounding * fastest);
    // Contacts that have begun start with an estimate.
    for (const GroupContact& contact : problem.contacts) {
        double impulse = 0;
        for (int i = contact.first; i < contact.first + contact.points; i++)
            impulse += problem.row(i).impulse;
        if (impulse > 0) continue;
        for (int i = contact.first; i < contact.first + contact.points; i++)
            problem.row(i).impulse =
                fastest * maximum(1 / problem.row(i).response, contact.load / contact.points);
    }
    const double rough = maximum(tolerance, rough_tolerance * maximum(usual_speed_, fastest));
    // Near the velocities of the last impulses, if they are nearly right.
    std::fill(y.begin(), y.end(), 0.0);
    for (const GroupRow& row : problem.rows) add_impulse(row, row.impulse, y);
    find_residual(problem, y);
    double least = maximum(worst_miss(problem), rough);
    if (least > warm_share * usual_speed_) {
        std::fill(y.begin(), y.end(), 0.0);
        find_residual(problem, y);
        least = usual_speed_;
    }
    start(problem, least, tolerance);
    const bool solved = iterate(problem, matrix, y, tolerance);
    if (solved) drop_idle_impulses(problem);
    return solved;
}

}  // namespace jostle::physics
