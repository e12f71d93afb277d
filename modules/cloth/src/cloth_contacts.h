// SPDX-License-Identifier: MIT
//
// Contacts of the vertices of a cloth with shapes, in a part of a sub-step. The surface of a shape
// near a vertex is a plane for the part, found at its start, so no speed passes it. A vertex that
// pressed against a body in the last part moves along the normal together with a share of the body
// while the threads are solved: heavy bodies are carried without sinking through light cloth.
#pragma once

#include "modules/cloth/src/cloth_data.h"

namespace jostle::modules::cloth_detail {

double greatest_speed(const Sheet& sheet);
double longest_edge(const Sheet& sheet);
physics::Aabb bounds_of(const Sheet& sheet, double margin);
double mean_speed(const Sheet& sheet);  // root mean square
// Finds the contacts of the next h seconds.
void find_contacts(Cloth& cloth, double h, physics::Vec3 gravity);
// Joins pressed vertices with their bodies. Before Sheet::solve_threads().
void press_contacts(Cloth& cloth, double h);
// Gives the bodies the impulses of pressed vertices, then pushes vertices and bodies apart, with
// friction. After Sheet::solve_threads().
void resolve_contacts(Cloth& cloth, double h);

}  // namespace jostle::modules::cloth_detail
