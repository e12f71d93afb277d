// SPDX-License-Identifier: MIT
//
// Conditioning of a constraint system: eigenvalues, rank and redundant rows.
#pragma once

#include "jostle/analysis/problem.h"

namespace jostle::analysis {

struct Term {
    std::size_t row = 0;
    double factor = 0;
};
/// A redundant row: it is a linear combination of other rows with these factors, so its right-hand
/// side is determined by theirs and its impulse is undetermined. Factors below 1e-9 of the largest
/// are omitted.
struct Redundancy {
    std::size_t row = 0;
    std::vector<Term> of;
};

struct Analysis {
    std::vector<double> eigenvalues;         ///< ascending
    std::vector<double> scaled_eigenvalues;  ///< of D A D, which has ones on the diagonal
    std::size_t rank = 0;                    ///< of D A D, which equals that of A
    /// Largest over smallest nonzero eigenvalue, of A and of D A D.
    double condition = 1, scaled_condition = 1;
    std::vector<Redundancy> redundancies;  ///< rows minus rank entries, sorted by row
    /// The component of b outside the range of A, relative to b: redundant rows with contradictory
    /// right-hand sides.
    double inconsistency = 0;

    bool singular() const { return rank < eigenvalues.size(); }
};

Analysis analyse(const Problem& problem);

/// Formats a redundancy as "joint 3 turn x = 0.5 joint 0 turn x - joint 1 point z", with at most
/// `terms_max` terms.
std::string to_text(const Redundancy& redundancy, const Problem& problem, int terms_max = 6);

}  // namespace jostle::analysis
