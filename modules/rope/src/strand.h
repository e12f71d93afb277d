// SPDX-License-Identifier: MIT
//
// A strand: nodes in a row, connected by links that resist a change of length and optionally
// bending. This file knows neither worlds nor shapes: the caller describes everything outside the
// strand as fixed nodes, as masses that move with a node, and as contacts with moving points.
//
// A sub-step solves, with the mass m, the rest length L, and the force density q = tension / L,
//     m (x' - x - h v - h^2 g) = h^2 (forces of links, bending and contacts),   v' = (x' - x) / h,
// for x' and q' by Newton's method. The length of a link and its tension are taken at the end of
// the sub-step, so stiff links are stable and do not vibrate. The direction of the tension, and
// bending, are taken at a mean of the end, the start and the start of the previous sub-step, by the
// velocities. For x'' = -omega^2 x and s = (omega h)^2, with the weights a, 1 - a - b and b, such a
// force is stable for a + b > 1/2 - 2/s and a >= b, is of second order and keeps energy for a = b
// (N. Newmark, "A method of computation for structural dynamics", 1959), and damps slow motion with
// the rate (a - b) omega^2 h / 2. At a = b = 0 this is the SHAKE method (J.-P. Ryckaert et al.,
// "Numerical integration of the Cartesian equations of motion of a system with constraints", J.
// Comput. Phys. 23, 1977).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "modules/rope/src/strand_system.h"

namespace jostle::modules::rope_detail {

// Weights of the end of the sub-step and of the start of the previous one.
struct TimeWeights {
    double end = 0, previous = 0;
};
// For s = stiffness / mass of the fastest vibration: equal weights while sub-steps resolve it,
// implicit Euler if they are much too long, because equal weights are stable only for linear
// forces: (s - 1) / (s + 1) / 4 times (1 + 3 d, 1 - d) with d = s / (s + 300).
inline TimeWeights time_weights(double stiffness, double mass) {
    if (!(stiffness > mass)) return {};
    const double both = stiffness + 300 * mass;
    const double share = 0.25 * (stiffness - mass) / ((stiffness + mass) * both);
    return {(both + 3 * stiffness) * share, (both - stiffness) * share};
}

// The same for strands that touch others, whose links turn by much in an impact: a tension in the
// direction of the mean of start and end adds no energy however much a link turns, and a direction
// nearer to the end takes some.
inline TimeWeights impact_weights(double stiffness, double mass) {
    if (!(stiffness > mass)) return {};
    if (stiffness < 2 * mass) return {0.5 * (stiffness - mass) / mass, 0};
    return {0.5 + 0.5 * (stiffness - 2 * mass) / (stiffness + 28 * mass), 0};
}

// State of a strand.
struct Strand {
    std::vector<physics::Vec3> positions, velocities;  // per node, m and m/s
    std::vector<double> rest_lengths;                  // per link, m
    std::vector<double> force_densities;               // per link, tension / rest length, N/m
    double mass_per_length = 0.1;                      // kg/m
    double stretch_stiffness = 1e6;                    // E A, N
    double bending_stiffness = 0;                      // E I, N m^2

    std::size_t links() const { return rest_lengths.size(); }
};

// Something that moves with a node: a fixed point if `fixed`, otherwise a mass.
struct NodeLoad {
    std::uint32_t node = 0;
    bool fixed = false;
    physics::Vec3 target = {};  // m, where it is at the end of the sub-step without the strand
    Symmetric3 mass = {};       // kg, of a point of a body; not used if fixed
    // Result: the impulse that the strand gave to it, N s.
    physics::Vec3 impulse = {};
};

// The direction of the strand at an end is held along `direction` (unit, out of the support).
struct Clamp {
    bool last = false;             // at the last node instead of the first one
    physics::Vec3 direction = {};  // from the held node to its neighbour
    physics::Vec3 moment = {};     // result: angular impulse on the support, N m s
};

// How a contact acts: not at all, without friction (a contact that has just closed), without
// sliding, sliding with a constant force, or sliding with a force proportional to the distance,
// which always converges, but slowly.
enum class ContactGrip : std::uint8_t { open, smooth, sticks, slips, drags };

// A contact of a point of a link with a moving plane.
struct StrandContact {
    std::uint32_t link = 0;
    double fraction = 0;          // along the link
    physics::Vec3 normal = {};    // unit, out of the obstacle
    double gap = 0;               // m, at the start of the sub-step; negative: overlap
    physics::Vec3 travel = {};    // m, of the obstacle's point during the sub-step without contact
    double response_normal = 0;   // 1/kg, of the obstacle along the normal
    double response_tangent = 0;  // 1/kg, across it
    double friction = 0;
    // State of the solution; the caller may start it with that of the last sub-step.
    ContactGrip grip = ContactGrip::open;
    physics::Vec3 slip = {};               // unit direction of sliding, if it slips
    double pressure = 0;                   // normal impulse times h, kg m
    std::uint8_t openings = 0, flips = 0;  // in this sub-step
    physics::Vec3 impulse = {};            // on the obstacle, N s
};

struct SubstepInput {
    double h = 0;                                // s
    physics::Vec3 gravity = {};                  // m/s^2
    std::span<const physics::Vec3> forces = {};  // N per node, or empty
    std::span<NodeLoad> loads = {};              // at most one per node
    std::span<Clamp> clamps = {};                // at held ends
    std::span<StrandContact> contacts = {};
    bool coupled = false;  // to other links by a StrandCoupling
    int iterations_max = 12;
};

// A taut link resists stretching. A slack one is shorter than its rest length. A link that became
// slack and taut again within a sub-step is a spring that the sub-step resolves.
enum class LinkLaw : std::uint8_t { taut, slack, undecided };

// Reused memory of a sub-step. Not state.
struct StrandScratch {
    std::vector<NodeRow> nodes;
    std::vector<LinkRow> links;
    std::vector<CrossBlock> cross;  // empty without contacts
    StrandElimination elimination;
    std::vector<physics::Vec3> displacements, start, previous, free_targets;
    std::vector<double> changes, multipliers, used_multipliers, masses;
    std::vector<TimeWeights> weights, bend_weights;  // per link, per node
    std::vector<LinkLaw> laws;                       // per link
    // Of a StrandCoupling, per node: force times h^2, kg m.
    std::vector<physics::Vec3> pushes;
    int iterations = 0;  // of the last sub-step
};

// Mass of a node, kg: half of the links at it.
double node_mass(const Strand& strand, std::size_t node);
// Advances a strand by a sub-step. Returns the number of Newton iterations.
int advance_strand(Strand& strand, const SubstepInput& input, StrandScratch& scratch);

// A strand of a coupled system in a sub-step.
struct StrandJob {
    Strand* strand = nullptr;
    SubstepInput input = {};
    StrandScratch* scratch = nullptr;
};
// Forces between links of one or several strands. Each iteration linearises the strands; the
// coupling then solves for its forces and the displacements of all nodes together.
class StrandCoupling {
public:
    virtual ~StrandCoupling() = default;
    // The systems of the strands are assembled with StrandScratch::pushes and solved. Changes the
    // pushes, the right sides and the displacements. Returns whether the forces are settled.
    virtual bool couple(std::span<StrandJob> jobs) = 0;
};
// Advances strands whose inputs are `coupled`.
void advance_strands(std::span<StrandJob> jobs, StrandCoupling& coupling);
// Solves the system of a strand again, after a change of the right sides of nodes.
void solve_again(const StrandJob& job);
// Kinetic energy, elastic energy, and their sum with the weight, J.
double strand_energy(const Strand& strand, physics::Vec3 gravity);

}  // namespace jostle::modules::rope_detail
