// SPDX-License-Identifier: MIT
#include "modules/rope/src/rope_winch.h"

#include <algorithm>

namespace jostle::modules::rope_detail {

using namespace physics;

namespace {

template <class T>
auto at(std::vector<T>& items, std::size_t index) {
    return items.begin() + static_cast<std::ptrdiff_t>(index);
}

void move_attachments(Rope& rope, std::size_t from, int by) {
    for (RopeAttachment& attachment : rope.attachments)
        if (attachment.node >= from)
            attachment.node = static_cast<std::uint32_t>(static_cast<int>(attachment.node) + by);
    rope.contacts.clear();  // they are identified by link
}

// Divides a link so that its part away from the end has the usual length.
void divide(Rope& rope, std::size_t link, bool first_end) {
    Strand& s = rope.strand;
    const double whole = s.rest_lengths[link], usual = rope.link_length;
    const double share = first_end ? (whole - usual) / whole : usual / whole;
    const auto between = [share](Vec3 a, Vec3 b) { return a + (b - a) * share; };
    s.positions.insert(at(s.positions, link + 1),
                       between(s.positions[link], s.positions[link + 1]));
    s.velocities.insert(at(s.velocities, link + 1),
                        between(s.velocities[link], s.velocities[link + 1]));
    // The tension stays the same.
    const double tension = s.force_densities[link] * whole;
    s.rest_lengths[link] = whole * share;
    s.rest_lengths.insert(at(s.rest_lengths, link + 1), whole * (1 - share));
    s.force_densities[link] = tension / s.rest_lengths[link];
    s.force_densities.insert(at(s.force_densities, link + 1), tension / s.rest_lengths[link + 1]);
    move_attachments(rope, link + 1, 1);
}

// Removes the node between a link and the next one. Returns false if the node is attached.
bool unite(Rope& rope, std::size_t link) {
    const auto node = static_cast<std::uint32_t>(link + 1);
    if (std::ranges::find(rope.attachments, node, &RopeAttachment::node) != rope.attachments.end())
        return false;
    Strand& s = rope.strand;
    const double tension = s.force_densities[link] * s.rest_lengths[link];
    s.rest_lengths[link] += s.rest_lengths[link + 1];
    s.force_densities[link] = tension / s.rest_lengths[link];
    s.rest_lengths.erase(at(s.rest_lengths, link + 1));
    s.force_densities.erase(at(s.force_densities, link + 1));
    s.positions.erase(at(s.positions, node));
    s.velocities.erase(at(s.velocities, node));
    move_attachments(rope, node, -1);
    return true;
}

// Links next to the winch are between half and three halves of the usual length.
void run_winch(Rope& rope, RopeEnd end, double dt, std::size_t links_free) {
    const bool first = end == RopeEnd::first;
    double& speed = rope.winch[first ? 0 : 1];
    if (speed == 0) return;
    Strand& s = rope.strand;
    const double usual = rope.link_length;
    double left = speed * dt;
    while (left != 0) {
        const std::size_t link = first ? 0 : s.links() - 1;
        double& length = s.rest_lengths[link];
        const double before = length;
        length = std::clamp(length + left, 0.5 * usual, 1.5 * usual);
        s.force_densities[link] *= before / length;
        left -= length - before;
        if (left > 0) {
            if (links_free == 0 || s.links() >= RopeDef::links_max) break;
            links_free--;
            divide(rope, link, first);
        } else if (left < 0 && (s.links() == 1 || !unite(rope, first ? 0 : link - 1))) {
            break;
        }
    }
    if (left != 0) speed = 0;
}

}  // namespace

void run_winches(Rope& rope, double dt, std::size_t links_free) {
    run_winch(rope, RopeEnd::first, dt, links_free);
    run_winch(rope, RopeEnd::last, dt, links_free);
}

}  // namespace jostle::modules::rope_detail
