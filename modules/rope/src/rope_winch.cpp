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
    rope.link_contacts.clear();
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

std::size_t link_at(const Rope& rope, bool first) {
    return first ? 0 : rope.strand.links() - 1;
}

}  // namespace

void keep_link_lengths(Rope& rope, std::size_t links_free) {
    for (const bool first : {true, false}) {
        double& speed = rope.winch[first ? 0 : 1];
        const std::size_t link = link_at(rope, first);
        const double length = rope.strand.rest_lengths[link];
        if (speed > 0 && length > 1.5 * rope.link_length) {
            if (links_free == 0 || rope.strand.links() >= RopeDef::links_max)
                speed = 0;
            else
                divide(rope, link, first);
        } else if (speed < 0 && length < 0.5 * rope.link_length) {
            if (rope.strand.links() == 1 || !unite(rope, first ? 0 : link - 1)) speed = 0;
        }
    }
}

void run_winches(Rope& rope, double h, double dt) {
    for (const bool first : {true, false}) {
        const double most = 0.5 * rope.link_length / dt;
        const double speed = std::clamp(rope.winch[first ? 0 : 1], -most, most);
        if (speed == 0) continue;
        const std::size_t link = link_at(rope, first);
        double& length = rope.strand.rest_lengths[link];
        const double before = length;
        length = std::max(length + speed * h, 0.25 * rope.link_length);
        rope.strand.force_densities[link] *= before / length;
    }
}

}  // namespace jostle::modules::rope_detail
