// SPDX-License-Identifier: MIT
//
// Source of the kernels, for inclusion by kernel_*.cpp only. No functions of the standard library:
// the linker could choose the copy for a newer instruction set for all callers.
#pragma once

#include "modules/cloth/src/lanes.h"
#include "modules/cloth/src/sheet_kernel.h"

namespace jostle::modules::cloth_detail {
namespace {

// Threads pull along their direction at this share of the predicted motion. Waves across a thread
// of angular frequency w then lose the share w^2 h^2 / 2 of this per sub-step and are stable for
// w h < 2 / sqrt(1 + 2 * share). At 0 they lose nothing, but short waves grow by rounding and
// compression.
constexpr float direction_time = 0.5f;

// Implicit Euler of all links of a chain at once: the multipliers of neighbouring links couple by
// their common node, which is a tridiagonal system (Han and Harada 2013; Deul et al. 2018). A chain
// therefore carries any load without the surplus stretch of one local sweep.
template <bool pressed>
Wide3 load_pressed(const SheetArrays& sheet, const std::uint32_t* index) {
    if constexpr (!pressed) {
        return {all(0), all(0), all(0)};
    } else {
        Wide3 q;
        for (int k = 0; k < 8; k++) {
            const float* from = sheet.pressed + 4 * std::size_t{index[k]};
            q.x[k] = from[0];
            q.y[k] = from[1];
            q.z[k] = from[2];
        }
        return q;
    }
}

// The motion of nodes by a pull. Adds the pull along q to the fourth number of pressed nodes.
template <bool pressed>
Wide3 respond(const SheetArrays& sheet, const std::uint32_t* index, Wide inverse_mass, Wide3 pull) {
    const Wide3 motion = pull * inverse_mass;
    if constexpr (!pressed) return motion;
    const Wide3 q = load_pressed<pressed>(sheet, index);
    const Wide along = dot(q, pull);
    for (int k = 0; k < 8; k++) sheet.pressed[4 * std::size_t{index[k]} + 3] += along[k];
    return motion - q * along;
}

template <bool pressed>
float solve_chains_of(const SheetArrays& sheet, float h) {
    const Wide per_h2 = all(1 / (h * h)), tiny = all(1e-12f), one = all(1), zero = all(0);
    Wide most = zero;
    for (std::size_t c = 0; c < sheet.chain_count; c++) {
        const ChainBlock chain = sheet.chains[c];
        const std::uint32_t* nodes = sheet.chain_nodes + 8 * std::size_t{chain.first_node};
        const float* rest = sheet.rest_lengths + 8 * std::size_t{chain.first};
        const float* compliance = sheet.stretch_compliance + 8 * std::size_t{chain.first};
        float* tension = sheet.tensions + 8 * std::size_t{chain.first};
        // Per link: direction, coupling to the link before, right-hand side times the inverse
        // pivot, and the displacement and inverse mass of its second node.
        WideNode a = load_nodes(sheet.nodes, nodes);
        Wide3 q = load_pressed<pressed>(sheet, nodes), before = {zero, zero, zero};
        Wide pivot = zero, right = zero;
        for (std::uint32_t k = 0; k < chain.links; k++) {
            const WideNode b = load_nodes(sheet.nodes, nodes + 8 * (k + 1));
            const Wide3 next_q = load_pressed<pressed>(sheet, nodes + 8 * (k + 1));
            // A thread that turns by more than 60 degrees pulls along its predicted direction.
            const Wide3 apart = b.at - a.at;
            const Wide3 during = b.start - a.start + (b.moved - a.moved) * all(direction_time);
            const Wide length = root(dot(apart, apart));
            const Wide pull_length = root(dot(during, during));
            const WideMask turns = dot(apart, during) < all(0.5f) * length * pull_length;
            const Wide scale = one / larger(turns ? length : pull_length, tiny);
            const Wide3 n = {(turns ? apart.x : during.x) * scale,
                             (turns ? apart.y : during.y) * scale,
                             (turns ? apart.z : during.z) * scale};
            Wide coupling = -a.inverse_mass * dot(before, n);
            Wide diagonal = a.inverse_mass + b.inverse_mass + load(compliance + 8 * k) * per_h2;
            if constexpr (pressed) {
                const Wide qa = dot(q, n), qb = dot(next_q, n);
                coupling += dot(q, before) * qa;
                diagonal -= qa * qa + qb * qb;
            }
            const Wide part = coupling * pivot;
            right = length - load(rest + 8 * k) - part * right;
            pivot = one / (diagonal - part * coupling);
            float* s = sheet.scratch + 72 * std::size_t{k};
            store(s, n.x);
            store(s + 8, n.y);
            store(s + 16, n.z);
            store(s + 24, coupling);
            store(s + 32, right * pivot);
            store(s + 40, b.moved.x);
            store(s + 48, b.moved.y);
            store(s + 56, b.moved.z);
            store(s + 64, b.inverse_mass);
            store(tension + 8 * k, pivot);
            before = n;
            q = next_q;
            a = b;
        }
        // Back substitution, and the displacements from the last node to the first.
        Wide after = zero, next_coupling = zero;
        Wide3 pull_after = {zero, zero, zero};
        for (std::uint32_t k = chain.links; k-- > 0;) {
            const float* s = sheet.scratch + 72 * std::size_t{k};
            const Wide3 n = {load(s), load(s + 8), load(s + 16)};
            const Wide multiplier = load(s + 32) - next_coupling * after * load(tension + 8 * k);
            const Wide3 pull = n * multiplier;
            const std::uint32_t* to = nodes + 8 * (k + 1);
            const Wide3 moved = {load(s + 40), load(s + 48), load(s + 56)};
            const Wide inverse_mass = load(s + 64);
            store_moved(sheet.nodes, to,
                        moved + respond<pressed>(sheet, to, inverse_mass, pull_after - pull));
            const Wide force = multiplier * per_h2;
            store(tension + 8 * k, force);
            const Wide rate = force * inverse_mass / larger(load(rest + 8 * k), tiny);
            most = larger(rate, most);
            pull_after = pull;
            after = multiplier;
            next_coupling = load(s + 24);
        }
        const WideNode first = load_nodes(sheet.nodes, nodes);
        store_moved(sheet.nodes, nodes,
                    first.moved + respond<pressed>(sheet, nodes, first.inverse_mass, pull_after));
    }
    float result = 0;
    for (int k = 0; k < 8; k++)
        if (most[k] > result) result = most[k];
    return 4 * result;
}

float solve_chains(const SheetArrays& sheet, float h) {
    return sheet.pressed == nullptr ? solve_chains_of<false>(sheet, h)
                                    : solve_chains_of<true>(sheet, h);
}

// Shear of a cell of four nodes: the mean edges U along and V across stay at right angles, without
// effect on their lengths. Energy G A / 2 (U V)^2 (Mueller et al., Strain based dynamics, 2014).
void solve_cells(const SheetArrays& sheet, float h) {
    const Wide per_h2 = all(1 / (h * h));
    for (std::size_t c = 0; c < sheet.cell_count; c++) {
        const std::uint32_t* index = sheet.cell_nodes + 32 * c;
        WideNode n[4];
        for (int k = 0; k < 4; k++) n[k] = load_nodes(sheet.nodes, index + 8 * k);
        const Wide su = load(sheet.cell_scale_u + 8 * c), sv = load(sheet.cell_scale_v + 8 * c);
        const Wide3 d = n[3].at - n[0].at, e = n[1].at - n[2].at;
        const Wide3 u = (d + e) * su, v = (d - e) * sv;
        const Wide3 gu = v * su, gv = u * sv;
        const Wide3 g3 = gu + gv, g1 = gu - gv;  // the opposite corners have the opposite sign
        const Wide response = (n[0].inverse_mass + n[3].inverse_mass) * dot(g3, g3) +
                              (n[1].inverse_mass + n[2].inverse_mass) * dot(g1, g1);
        const Wide multiplier =
            -dot(u, v) / (response + load(sheet.cell_compliance + 8 * c) * per_h2);
        const Wide3 p3 = g3 * multiplier, p1 = g1 * multiplier;
        store_moved(sheet.nodes, index, n[0].moved - p3 * n[0].inverse_mass);
        store_moved(sheet.nodes, index + 8, n[1].moved + p1 * n[1].inverse_mass);
        store_moved(sheet.nodes, index + 16, n[2].moved - p1 * n[2].inverse_mass);
        store_moved(sheet.nodes, index + 24, n[3].moved + p3 * n[3].inverse_mass);
    }
}

// Bending over an edge, quadratic in the positions for sheets that hardly stretch (Bergou et al., A
// quadratic bending model for inextensible surfaces, 2006).
void solve_hinges(const SheetArrays& sheet, float h) {
    const Wide per_h2 = all(1 / (h * h));
    for (std::size_t c = 0; c < sheet.hinge_count; c++) {
        const std::uint32_t* index = sheet.hinge_nodes + 32 * c;
        const float* weights = sheet.hinge_weights + 32 * c;
        WideNode n[4];
        Wide response = load(sheet.hinge_compliance + 8 * c) * per_h2;
        // The weights add up to zero, so differences lose no digits.
        Wide3 sum = {all(0), all(0), all(0)};
        for (int k = 0; k < 4; k++) {
            n[k] = load_nodes(sheet.nodes, index + 8 * k);
            const Wide weight = load(weights + 8 * k);
            if (k > 0) sum = sum + (n[k].at - n[0].at) * weight;
            response += n[k].inverse_mass * weight * weight;
        }
        const Wide3 multiplier = sum * (all(-1) / response);
        for (int k = 0; k < 4; k++)
            store_moved(sheet.nodes, index + 8 * k,
                        n[k].moved + multiplier * (n[k].inverse_mass * load(weights + 8 * k)));
    }
}

}  // namespace
}  // namespace jostle::modules::cloth_detail
