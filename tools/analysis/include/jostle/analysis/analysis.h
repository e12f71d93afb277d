// SPDX-License-Identifier: MIT
//
// How hard a problem is, and why: its eigenvalues, its rank, and which rows say what others say
// already.
#pragma once

#include "jostle/analysis/problem.h"

namespace jostle::linear_systems {

struct Term {
    std::size_t row = 0;
    double factor = 0;
};
// The row is the sum of others, each times its factor: what it wants they decide, and what it
// carries is not determined. Factors below 1e-9 of the largest are left out.
struct Redundancy {
    std::size_t row = 0;
    std::vector<Term> of;
};

struct Analysis {
    std::vector<double> eigenvalues;         // rising
    std::vector<double> scaled_eigenvalues;  // of D A D, whose diagonal is ones
    std::size_t rank = 0;                    // of D A D, which is that of A
    // Largest over smallest eigenvalue, of those that are not zero: of A, and of D A D.
    double condition = 1, scaled_condition = 1;
    std::vector<Redundancy> redundancies;  // as many as rows less the rank, rising by row
    // The part of b that no x can make, relative to b: rows that say the same want different
    // things.
    double inconsistency = 0;

    bool singular() const { return rank < eigenvalues.size(); }
};

Analysis analyse(const Problem& problem);

// "joint 3 turn x = 0.5 joint 0 turn x - joint 1 point z"; no more than so many terms.
std::string to_text(const Redundancy& redundancy, const Problem& problem, int terms_max = 6);

}  // namespace jostle::linear_systems
