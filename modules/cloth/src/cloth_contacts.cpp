// SPDX-License-Identifier: MIT
#include "modules/cloth/src/cloth_contacts.h"

#include <algorithm>

#include "jostle/physics/scalar.h"

namespace jostle::modules::cloth_detail {

using namespace physics;

namespace {

// Index of a shape of `nearby`, which are sorted by id.
std::uint32_t index_of(const NearbyShapes& nearby, ShapeId id) {
    std::size_t first = 0, end = nearby.size();
    while (end - first > 1) {
        const std::size_t middle = (first + end) / 2;
        (id < nearby.shape(middle) ? end : first) = middle;
    }
    return static_cast<std::uint32_t>(first);
}

bool was_pressed(const Cloth& cloth, std::uint32_t vertex, ShapeId shape) {
    const auto at = std::ranges::lower_bound(cloth.pressed, vertex, {}, &Pressed::vertex);
    return at != cloth.pressed.end() && at->vertex == vertex && at->shape == shape;
}

bool is_held(const Cloth& cloth, std::uint32_t vertex) {
    return std::ranges::binary_search(cloth.attachments, vertex, {}, &ClothAttachment::vertex);
}

Vec3 arm_of(const VertexContact& contact, const CarriedBody& body) {
    return contact.point - body.center;
}

double response_along(const CarriedBody& body, Vec3 arm, Vec3 direction) {
    if (!body.is_pushed()) return 0;
    return dot(direction, point_response(body.response, arm) * direction);
}

}  // namespace

double greatest_speed(const Sheet& sheet) {
    double most = 0;
    for (std::size_t k = 0; k < sheet.size(); k++)
        most = maximum(most, length_squared(sheet.velocity(k)));
    return square_root(most);
}

Aabb bounds_of(const Sheet& sheet, double margin) {
    Aabb box{sheet.position(0), sheet.position(0)};
    for (std::size_t k = 0; k < sheet.size(); k++) {
        box.low = min(box.low, sheet.position(k));
        box.high = max(box.high, sheet.position(k));
    }
    const Vec3 more{margin, margin, margin};
    return {box.low - more, box.high + more};
}

double longest_edge(const Sheet& sheet) {
    double most = 0;
    for (const SheetEdge& edge : sheet.topology().edges) most = maximum(most, edge.rest_length);
    return most;
}

double mean_speed(const Sheet& sheet) {
    double sum = 0;
    for (std::size_t k = 0; k < sheet.size(); k++) sum += length_squared(sheet.velocity(k));
    return square_root(sum / static_cast<double>(sheet.size()));
}

namespace {

// Shapes that fit between vertices, or are fast enough to stretch the threads around them, touch
// edges too.
bool touches_edges(const CarriedBody& body, double radius, double longest) {
    constexpr double fast = 5;  // m/s
    return body.type != BodyType::static_body &&
           (radius < 2 * longest || length_squared(body.velocity) > fast * fast);
}

void find_edge_contacts(Cloth& cloth, double margin) {
    cloth.edge_contacts.clear();
    const Sheet& sheet = cloth.sheet;
    const double longest = longest_edge(sheet);
    std::vector<bool> small(cloth.nearby.bodies().size());
    bool any = false;
    for (std::size_t k = 0; k < small.size(); k++) {
        const std::uint32_t index = cloth.bodies.index_of_nearby(k);
        if (index == CarriedBodies::none) continue;
        const CarriedBody& body = cloth.bodies.all()[index];
        small[k] = touches_edges(body, cloth.nearby.bodies()[k].radius, longest) &&
                   !cloth.bodies.is_attached_to(body.id);
        any = any || small[k];
    }
    if (!any) return;
    const auto& edges = sheet.topology().edges;
    for (std::uint32_t e = 0; e < edges.size(); e++) {
        if (sheet.is_torn(e)) continue;
        const Vec3 a = sheet.position(edges[e].a), b = sheet.position(edges[e].b);
        const double size = length(b - a);
        if (size < 1e-6) continue;
        bool is_near = false;
        for (std::size_t k = 0; k < small.size() && !is_near; k++) {
            const NearbyShapes::Body& body = cloth.nearby.bodies()[k];
            const double most = body.radius + size + margin + cloth.def.thickness;
            is_near = small[k] && length_squared(body.center - a) < most * most;
        }
        if (!is_near) continue;
        cloth.found.clear();
        cloth.nearby.capsule_contacts(a, b, cloth.def.thickness, margin, cloth.found);
        for (const CapsuleContact& found : cloth.found) {
            const std::uint32_t of = cloth.nearby.body_of(found.shape);
            // The ends are contacts of vertices.
            if (!small[of] || found.fraction < 0.05 || found.fraction > 0.95) continue;
            cloth.edge_contacts.push_back(
                {edges[e].a, edges[e].b, cloth.bodies.index_of_nearby(of), found.fraction,
                 found.point, found.normal, found.gap,
                 square_root(cloth.def.friction * cloth.nearby.material(found.shape).friction)});
        }
    }
}

}  // namespace

void find_contacts(Cloth& cloth, double h, Vec3 gravity) {
    cloth.contacts.clear();
    cloth.edge_contacts.clear();
    if (cloth.nearby.size() == 0) return;
    const Sheet& sheet = cloth.sheet;
    const double thickness = cloth.def.thickness;
    const double margin =
        0.25 * thickness +
        h * (greatest_speed(sheet) + cloth.bodies.greatest_speed() + h * length(gravity));
    cloth.points.resize(sheet.size());
    cloth.nearest.resize(sheet.size());
    for (std::size_t k = 0; k < sheet.size(); k++) cloth.points[k] = sheet.position(k);
    cloth.nearby.closest_points(cloth.points, thickness + margin, cloth.nearest);
    for (std::uint32_t k = 0; k < sheet.size(); k++) {
        if (!cloth.nearest[k]) continue;
        const ClosestPoint& near = *cloth.nearest[k];
        const std::uint32_t shape = index_of(cloth.nearby, near.shape);
        const std::uint32_t body = cloth.bodies.index_of_nearby(cloth.nearby.body_of(shape));
        if (body == CarriedBodies::none || cloth.bodies.is_attached_to(near.body)) continue;
        VertexContact contact;
        contact.vertex = k;
        contact.body = body;
        contact.shape = shape;
        contact.point = near.point;
        contact.normal = near.normal;
        contact.gap = near.distance - thickness;
        contact.friction = square_root(cloth.def.friction * cloth.nearby.material(shape).friction);
        contact.pressed = contact.gap < 0.1 * thickness && was_pressed(cloth, k, near.shape);
        cloth.contacts.push_back(contact);
    }
    find_edge_contacts(cloth, margin);
}

void press_contacts(Cloth& cloth, double h) {
    Sheet& sheet = cloth.sheet;
    sheet.pressed().clear();
    for (CarriedBody& body : cloth.bodies.all()) body.touching = 0;
    bool any = false;
    for (VertexContact& contact : cloth.contacts) {
        contact.pressed = contact.pressed && !is_held(cloth, contact.vertex);
        if (!contact.pressed) continue;
        cloth.bodies.all()[contact.body].touching++;
        any = true;
    }
    if (!any) return;
    sheet.pressed().assign(4 * (sheet.size() + 1), 0);
    for (VertexContact& contact : cloth.contacts) {
        if (!contact.pressed) continue;
        const CarriedBody& body = cloth.bodies.all()[contact.body];
        const Vec3 arm = arm_of(contact, body), n = contact.normal;
        const double own = sheet.inverse_mass(contact.vertex);
        const double other = response_along(body, arm, n) * body.touching;
        const Vec3 moved = sheet.moved(contact.vertex);
        const double before = dot(n, moved), travel = dot(n, body.travel_of(arm, h));
        contact.common = (travel * own + before * other) / (own + other);
        contact.inverse_mass = own * other / (own + other);
        sheet.set_moved(contact.vertex, moved + n * (contact.common - before));
        // The sheet moves the vertex by this impulse; resolve_contacts() applies the opposite one
        // to the body.
        contact.impulse = (contact.common - before) / (own * h);
        const Vec3 q = n * square_root(own - contact.inverse_mass);
        float* to = &sheet.pressed()[4 * std::size_t{contact.vertex}];
        for (int axis = 0; axis < 3; axis++) to[axis] = static_cast<float>(q[axis]);
    }
}

namespace {

// The threads pull at the vertex and its share of the body together: the body gets what the vertex
// did not take.
void share_impulses(Cloth& cloth, double h) {
    for (VertexContact& contact : cloth.contacts) {
        if (!contact.pressed) continue;
        const float* q = &cloth.sheet.pressed()[4 * std::size_t{contact.vertex}];
        const double own = cloth.sheet.inverse_mass(contact.vertex);
        const double size = square_root(own - contact.inverse_mass);
        if (size > 0)
            contact.impulse -= double{q[3]} / (size * h) * (1 - contact.inverse_mass / own);
        CarriedBody& body = cloth.bodies.all()[contact.body];
        body.push(contact.normal * -contact.impulse, arm_of(contact, body));
    }
}

void push_apart(Cloth& cloth, VertexContact& contact, double h) {
    Sheet& sheet = cloth.sheet;
    CarriedBody& body = cloth.bodies.all()[contact.body];
    const Vec3 arm = arm_of(contact, body), n = contact.normal;
    const double own = sheet.inverse_mass(contact.vertex);
    if (own == 0 && !body.is_pushed()) return;
    Vec3 moved = sheet.moved(contact.vertex);
    Vec3 relative = moved - body.travel_of(arm, h);
    const double overlap = -(contact.gap + dot(n, relative));
    if (overlap > 0) {
        const double impulse = overlap / ((own + response_along(body, arm, n)) * h);
        contact.impulse += impulse;
        moved += n * (impulse * own * h);
        body.push(n * -impulse, arm);
        relative = moved - body.travel_of(arm, h);
    }
    const double load = contact.impulse;
    if (load > 0 && contact.friction > 0) {
        const Vec3 slip = relative - n * dot(n, relative);
        const double size = length(slip);
        if (size > 1e-12) {
            const Vec3 direction = slip * (1 / size);
            const double stop = size / ((own + response_along(body, arm, direction)) * h);
            const Vec3 impulse = direction * -minimum(stop, contact.friction * load);
            moved += impulse * (own * h);
            body.push(-impulse, arm);
        }
    }
    sheet.set_moved(contact.vertex, moved);
}

void push_apart(Cloth& cloth, const EdgeContact& contact, double h) {
    Sheet& sheet = cloth.sheet;
    CarriedBody& body = cloth.bodies.all()[contact.body];
    const Vec3 arm = contact.point - body.center, n = contact.normal;
    const double wa = 1 - contact.fraction, wb = contact.fraction;
    const double own_a = sheet.inverse_mass(contact.a), own_b = sheet.inverse_mass(contact.b);
    const double own = own_a * wa * wa + own_b * wb * wb;
    if (own == 0 && !body.is_pushed()) return;
    const auto relative = [&] {
        return sheet.moved(contact.a) * wa + sheet.moved(contact.b) * wb - body.travel_of(arm, h);
    };
    const auto apply = [&](Vec3 impulse) {
        sheet.set_moved(contact.a, sheet.moved(contact.a) + impulse * (own_a * wa * h));
        sheet.set_moved(contact.b, sheet.moved(contact.b) + impulse * (own_b * wb * h));
        body.push(-impulse, arm);
    };
    const double overlap = -(contact.gap + dot(n, relative()));
    if (overlap <= 0) return;
    const double impulse = overlap / ((own + response_along(body, arm, n)) * h);
    apply(n * impulse);
    const Vec3 slip = relative() - n * dot(n, relative());
    const double size = length(slip);
    if (size < 1e-12) return;
    const Vec3 direction = slip * (1 / size);
    const double stop = size / ((own + response_along(body, arm, direction)) * h);
    apply(direction * -minimum(stop, contact.friction * impulse));
}

void note_touch(Cloth& cloth, std::uint32_t index) {
    const CarriedBody& body = cloth.bodies.all()[index];
    if (body.type == BodyType::dynamic) cloth.bodies.touch(body.id);
}

}  // namespace

void resolve_contacts(Cloth& cloth, double h) {
    share_impulses(cloth, h);
    for (const EdgeContact& contact : cloth.edge_contacts) {
        push_apart(cloth, contact, h);
        note_touch(cloth, contact.body);
    }
    cloth.pressed.clear();
    for (VertexContact& contact : cloth.contacts) {
        push_apart(cloth, contact, h);
        if (contact.impulse <= 0) continue;
        note_touch(cloth, contact.body);
        cloth.pressed.push_back({contact.vertex, cloth.nearby.shape(contact.shape)});
    }
}

}  // namespace jostle::modules::cloth_detail
