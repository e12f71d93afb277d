// SPDX-License-Identifier: MIT
//
// Crowds: bodies that are about to bounce off each other within one step. One after the other, a
// push that goes through n of them leaves e^n of its speed, and where a wall throws it back e^2n
// (Bernu and Mazighi, "One-dimensional bounce of inelastically colliding marbles on a wall", 1990,
// find where such a row collapses). Once that is less than what bounces at all, or than what gravity
// gives in two steps, nothing is left of the order of the impacts: the contact solver resolves them
// together, and continuous collision sweeps as if they did not bounce.
#pragma once

#include "stages/contacts/contact_scratch.h"
#include "stages/step_context.h"

namespace jostle::physics {

// Reads: checks that look_at_pair is done with. Leaves in scratch: ContactScratch::crowds and
// crowd_of, for decide_contacts and solve_continuous.
void find_crowds(StepContext& step);

// Whether a pair with this restitution bounces in a crowd: one of its bodies is in one.
bool bounces_in_crowd(const ContactScratch& scratch, const BodyCold& a, const BodyCold& b,
                      double restitution);

}  // namespace jostle::physics
