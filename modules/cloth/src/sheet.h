// SPDX-License-Identifier: MIT
//
// A sheet of cloth without a world: its threads, cells and hinges, and a sub-step of it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/modules/cloth_def.h"
#include "jostle/physics/vec3.h"
#include "modules/cloth/src/sheet_kernel.h"

namespace jostle::modules::cloth_detail {

struct SheetEdge {
    std::uint32_t a = 0, b = 0;
    double rest_length = 0;  // m
    double stiffness = 0;    // N/m, force per change of length
    double width = 0;        // m, of the strip that it carries
};

// Four nodes of a grid: shear.
struct SheetCell {
    std::array<std::uint32_t, 4> nodes = {};
};

// An inner edge (first two nodes) and the opposite nodes of its triangles: bending.
struct SheetHinge {
    std::array<std::uint32_t, 4> nodes = {};
};

// The parts of a sheet as its definition describes them. Built once; tearing removes parts.
struct SheetTopology {
    std::vector<physics::Vec3> rest;  // m
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<double> masses;                      // kg, per vertex
    std::vector<SheetEdge> edges;                    // the threads
    std::vector<std::vector<std::uint32_t>> chains;  // nodes of threads in a row
    std::vector<SheetCell> cells;
    std::vector<SheetHinge> hinges;
};

SheetTopology sheet_topology(const ClothDef& def);
// The initial position of each vertex, m.
std::vector<physics::Vec3> initial_positions(const ClothDef& def);

// The state of a sheet and the arrays of its kernels.
class Sheet {
public:
    Sheet() = default;
    explicit Sheet(const ClothDef& def);

    std::size_t size() const { return topology_.rest.size(); }
    const SheetTopology& topology() const { return topology_; }
    // Where each vertex started, m.
    const std::vector<physics::Vec3>& initial() const { return initial_; }

    physics::Vec3 position(std::size_t vertex) const;
    physics::Vec3 velocity(std::size_t vertex) const;
    // Relative to the root, exact in single precision.
    physics::Vec3 relative_position(std::size_t vertex) const {
        return {nodes_[vertex].x, nodes_[vertex].y, nodes_[vertex].z};
    }
    void set_relative_position(std::size_t vertex, physics::Vec3 p) {
        nodes_[vertex].x = static_cast<float>(p.x);
        nodes_[vertex].y = static_cast<float>(p.y);
        nodes_[vertex].z = static_cast<float>(p.z);
    }
    void set_position(std::size_t vertex, physics::Vec3 position);
    void set_velocity(std::size_t vertex, physics::Vec3 velocity);
    // Predicted displacement in the current sub-step, m.
    physics::Vec3 moved(std::size_t vertex) const;
    void set_moved(std::size_t vertex, physics::Vec3 moved);
    // 1/kg; 0: set_moved() alone moves the vertex.
    double inverse_mass(std::size_t vertex) const { return nodes_[vertex].inverse_mass; }
    void set_inverse_mass(std::size_t vertex, double value) {
        nodes_[vertex].inverse_mass = static_cast<float>(value);
    }
    double free_inverse_mass(std::size_t vertex) const { return 1 / topology_.masses[vertex]; }

    // Positions are stored relative to this point, which follows the sheet.
    physics::Vec3 root() const { return root_; }
    void set_root(physics::Vec3 root) { root_ = root; }
    // Moves the root to the sheet if it is far from it.
    void rebase();

    // A sub-step: predict() sets the displacements by inertia and acceleration, solve_bends()
    // corrects them by cells and hinges, solve_threads() by threads, finish() moves the vertices.
    void predict(double h, physics::Vec3 acceleration);
    // Hinges move slowly: one solve of them may stand for several sub-steps, and the others skip
    // them (0).
    void solve_bends(double h, int substeps = 1);
    void solve_threads(double h);
    // 4 floats per vertex for solve_threads() (SheetArrays::pressed); empty: none.
    std::vector<float>& pressed() { return pressed_; }
    void finish(double h, physics::Vec3 acceleration, double damping);

    // Acceleration of each vertex besides gravity, 4 floats per vertex of which the last is 0,
    // m/s^2; empty: none.
    std::vector<float>& accelerations() { return accelerations_; }

    // Parts of a sub-step of h seconds so that transverse waves of the tension are stable.
    int stable_parts(double h, int least) const;
    float transverse_rate() const { return transverse_rate_; }
    void set_transverse_rate(float rate) { transverse_rate_ = rate; }

    // Tension of a thread in the last sub-step, N; negative: compression.
    double tension(std::size_t edge) const { return tensions_[edge_lane_[edge]]; }
    // Removes threads, with the cells, hinges and triangles that contain them.
    void tear(std::span<const std::uint32_t> edges);
    bool is_torn(std::size_t edge) const { return torn_[edge] != 0; }
    const std::vector<std::uint8_t>& torn() const { return torn_; }

    std::span<SheetNode> nodes() { return std::span(nodes_).first(size()); }
    std::span<const SheetNode> nodes() const { return std::span(nodes_).first(size()); }

private:
    void build_arrays();
    void build_chains();
    void build_cells(double shear_stiffness);
    void build_hinges(double bending_stiffness);
    SheetArrays arrays();

    SheetTopology topology_;
    std::vector<physics::Vec3> initial_;
    physics::Vec3 root_ = {};
    std::vector<SheetNode> nodes_;   // and one that pads the arrays
    std::vector<float> velocities_;  // 4 per vertex, the last is 0, m/s
    std::vector<float> accelerations_, pressed_;
    std::vector<std::uint8_t> torn_;  // per edge
    float transverse_rate_ = 0;

    std::vector<ChainBlock> chains_;
    std::vector<std::uint32_t> chain_nodes_, cell_nodes_, hinge_nodes_, edge_lane_;
    std::vector<float> rest_lengths_, stretch_compliance_, tensions_, scratch_;
    std::vector<float> cell_scale_u_, cell_scale_v_, cell_compliance_;
    std::vector<float> hinge_weights_, hinge_compliance_;
    bool is_grid_ = true;
    double shear_stiffness_ = 0, bending_stiffness_ = 0;
};

}  // namespace jostle::modules::cloth_detail
