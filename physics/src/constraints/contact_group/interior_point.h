// SPDX-License-Identifier: MIT
//
// Solves a GroupProblem by a primal-dual interior point method: Newton's method on the optimality
// conditions, whose products impulse * slack are relaxed to a common value that falls to zero. The
// number of iterations (4 to 15) hardly depends on the number of contacts or on their mass ratios,
// which is what sweeps, active sets and augmented Lagrangians lack. Each iteration factors
//     I + G^T W G,
// which has one block row per body. Predictor and corrector are those of Mehrotra (1992). With
// constant discs of friction the problem is convex; their radii follow the normal impulses in a few
// corrections on the way, as a fixed point (Haslinger, 1983).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "physics/src/constraints/contact_group/group_problem.h"
#include "physics/src/constraints/contact_group/skyline_cholesky.h"

namespace jostle::physics {

inline constexpr double relative_tolerance = 1e-7;

// Scratch data are reused from call to call. Not thread-safe.
class InteriorPoint {
public:
    // `matrix`: with the pattern of the problem. `y`: six per body, receives the solution; the
    // impulses of the rows are the start and the result. `tolerance`: in m/s, relative_tolerance of
    // what gravity adds to velocities. Returns whether a solution was found.
    bool solve(GroupProblem& problem, SkylineCholesky& matrix, std::span<double> y,
               double tolerance);
    // Returns whether the solution of the last call also solves this problem, which differs only in
    // its rows. At rest it does, from sub-step to sub-step.
    bool still_solves(const GroupProblem& problem, std::span<const double> y, double tolerance);

    int iterations() const { return iterations_; }  // of the last call

private:
    struct Disc {
        double radius = 0, slack = 0;  // slack: m/s per N s, the ratio of sliding and friction
        double inverse[3] = {};        // of the curvature: 00 01 11
        double change_of_slack = 0;
        double response = 0;  // of the first point of the contact
        bool active = false;  // the radius is not zero
    };

    void begin(const GroupProblem& problem, std::span<const double> y);
    double radius_of(const GroupProblem& problem, const GroupContact& contact, int disc) const;
    bool has_right_radius(const GroupProblem& problem, const GroupContact& contact, int d) const;
    bool correct_radii(GroupProblem& problem, double tolerance);
    void start(GroupProblem& problem, double least, double tolerance);
    double worst_miss(const GroupProblem& problem) const;
    void start_disc(GroupProblem& problem, std::size_t d, double product, double tolerance);
    bool iterate(GroupProblem& problem, SkylineCholesky& matrix, std::span<double> y,
                 double tolerance);
    double room(const GroupProblem& problem, std::size_t disc) const;
    double least_product(std::size_t disc) const;
    double mean_product(const GroupProblem& problem) const;
    void factor(const GroupProblem& problem, SkylineCholesky& matrix);
    void find_residual(const GroupProblem& problem, std::span<const double> y);
    void find_changes(const GroupProblem& problem, const SkylineCholesky& matrix,
                      std::span<const double> y, double product, bool corrected);
    double longest_step(const GroupProblem& problem) const;
    void take(GroupProblem& problem, std::span<double> y, double fraction);
    bool is_solved(const GroupProblem& problem, double tolerance) const;
    bool is_solved(const GroupProblem& problem, const GroupContact& contact,
                   double tolerance) const;
    void drop_idle_impulses(GroupProblem& problem) const;

    int iterations_ = 0;
    double usual_speed_ = 0;                              // m/s, what gravity adds to velocities
    std::vector<double> slack_, weight_, velocity_;       // by row
    std::vector<double> change_, change_of_slack_;        // by row, of impulses and slacks
    std::vector<double> product_shift_, velocity_shift_;  // by row, second-order terms
    std::vector<double> disc_shift_;                      // by disc
    std::vector<Disc> discs_;
    std::vector<double> right_, residual_;
};

}  // namespace jostle::physics
