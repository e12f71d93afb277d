// SPDX-License-Identifier: MIT
//
// Eight single-precision lanes for the kernels of cloth, by vector extensions of the compiler: the
// same operations per lane, and so the same bits, for every instruction set. Nodes are records of
// eight floats that are loaded transposed.
//
// Everything is in an unnamed namespace, because each kernel source is compiled for another
// instruction set.
#pragma once

#include <cstdint>

#include "modules/cloth/src/sheet_node.h"

namespace jostle::modules::cloth_detail {
namespace {

using Wide = float __attribute__((vector_size(32)));
using WideMask = std::int32_t __attribute__((vector_size(32)));

inline Wide all(float x) {
    return Wide{x, x, x, x, x, x, x, x};
}
inline Wide load(const float* from) {
    Wide v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}
inline void store(float* to, Wide v) {
    __builtin_memcpy(to, &v, sizeof v);
}
inline Wide larger(Wide a, Wide b) {
    return a > b ? a : b;
}
inline Wide root(Wide v) {
    Wide r;
    for (int k = 0; k < 8; k++) r[k] = __builtin_sqrtf(v[k]);
    return r;
}

struct Wide3 {
    Wide x, y, z;
};
inline Wide3 operator+(Wide3 a, Wide3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Wide3 operator-(Wide3 a, Wide3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Wide3 operator*(Wide3 a, Wide s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline Wide dot(Wide3 a, Wide3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Eight nodes: position at the start of the sub-step, predicted position, inverse mass and
// displacement.
struct WideNode {
    Wide3 start, at;
    Wide inverse_mass;
    Wide3 moved;
};

inline Wide low_pairs(Wide a, Wide b) {
    return __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
}
inline Wide high_pairs(Wide a, Wide b) {
    return __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
}
inline Wide low_halves(Wide a, Wide b) {
    return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
}
inline Wide high_halves(Wide a, Wide b) {
    return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
}
inline Wide first_of_both(Wide a, Wide b) {
    return __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
}
inline Wide second_of_both(Wide a, Wide b) {
    return __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
}

// Rows 0 and 4 to columns, of the transposed 4 x 4 blocks of eight records.
inline WideNode load_nodes(const SheetNode* nodes, const std::uint32_t* index) {
    Wide r[8];
    for (int k = 0; k < 8; k++) r[k] = load(&nodes[index[k]].x);
    Wide q[8];
    for (int k = 0; k < 8; k += 4) {
        const Wide a = low_pairs(r[k], r[k + 1]), b = high_pairs(r[k], r[k + 1]);
        const Wide c = low_pairs(r[k + 2], r[k + 3]), d = high_pairs(r[k + 2], r[k + 3]);
        q[k] = low_halves(a, c);
        q[k + 1] = high_halves(a, c);
        q[k + 2] = low_halves(b, d);
        q[k + 3] = high_halves(b, d);
    }
    WideNode n;
    n.moved = {second_of_both(q[0], q[4]), second_of_both(q[1], q[5]), second_of_both(q[2], q[6])};
    n.start = {first_of_both(q[0], q[4]), first_of_both(q[1], q[5]), first_of_both(q[2], q[6])};
    n.at = n.start + n.moved;
    n.inverse_mass = first_of_both(q[3], q[7]);
    return n;
}

// Writes the displacements. Lanes may refer to the same node only if they write the same values.
inline void store_moved(SheetNode* nodes, const std::uint32_t* index, Wide3 moved) {
    const Wide zero = all(0);
    const Wide a = low_pairs(moved.x, moved.y), b = high_pairs(moved.x, moved.y);
    const Wide c = low_pairs(moved.z, zero), d = high_pairs(moved.z, zero);
    const Wide rows[4] = {low_halves(a, c), high_halves(a, c), low_halves(b, d), high_halves(b, d)};
    for (int k = 0; k < 4; k++) {
        const Wide row = rows[k];
        __builtin_memcpy(&nodes[index[k]].moved_x, &row, 16);
        __builtin_memcpy(&nodes[index[k + 4]].moved_x, reinterpret_cast<const char*>(&row) + 16,
                         16);
    }
}

}  // namespace
}  // namespace jostle::modules::cloth_detail
