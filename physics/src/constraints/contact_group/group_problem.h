// SPDX-License-Identifier: MIT
//
// The contacts of a small group of bodies as one problem: find velocities and impulses such that
// points push and do not pull, and friction opposes sliding within its limit. Velocities are scaled
// by the square root of the mass, y = M^1/2 (v - v_free), so that all masses have the same weight.
#pragma once

#include <span>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/constraints/contact_group/six.h"

namespace jostle::physics {

// One scalar row. Its velocity is offset + ga . y_a + gb . y_b.
struct GroupRow {
    int a = 0, b = -1;              // bodies; b: -1 if contacts do not move the second body
    double ga[6] = {}, gb[6] = {};  // Jacobian times the square root of the inverse mass
    double offset = 0;              // m/s without impulses, including what the row has to close
    double free = 0;                // m/s without impulses
    double response = 0;            // 1/kg: G G^T
    double impulse = 0;             // N s: start value and result
};

// Rows whose impulse stays within a disc: the tangents of a contact, its torsion, its rolling
// resistance. The radius is a factor times the normal impulse of the contact.
struct GroupDisc {
    int first = 0, size = 1;  // rows: one or two
    double factor = 0;        // of the tangents 1, of moments m
};

// Normal rows come first, then the rows of the discs.
struct GroupContact {
    int first = 0, points = 0;  // rows
    int first_disc = 0, discs = 0;
    double load = 0;  // kg, estimate of what lies on the contact
};

struct GroupProblem {
    int bodies = 0;
    std::vector<GroupRow> rows;
    std::vector<GroupDisc> discs;
    std::vector<GroupContact> contacts;
    std::vector<double> root;  // largest square root of an inverse mass, by body: m/s per unit of y

    void clear(int body_count) {
        ASSERT(body_count > 0);
        bodies = body_count;
        rows.clear();
        discs.clear();
        contacts.clear();
    }
    const GroupRow& row(int i) const { return rows[static_cast<std::size_t>(i)]; }
    GroupRow& row(int i) { return rows[static_cast<std::size_t>(i)]; }
};

// Velocity of a row from y without its offset.
inline double velocity_of(const GroupRow& row, std::span<const double> y) {
    const double of_a = dot6(row.ga, &y[static_cast<std::size_t>(6 * row.a)]);
    return row.b < 0 ? of_a : of_a + dot6(row.gb, &y[static_cast<std::size_t>(6 * row.b)]);
}
// y += G^T impulse
inline void add_impulse(const GroupRow& row, double impulse, std::span<double> y) {
    add_six(&y[static_cast<std::size_t>(6 * row.a)], load_six(row.ga), impulse);
    if (row.b >= 0) add_six(&y[static_cast<std::size_t>(6 * row.b)], load_six(row.gb), impulse);
}

}  // namespace jostle::physics
