// SPDX-License-Identifier: MIT
#include "modules/cloth/src/cloth_step.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "jostle/physics/scalar.h"
#include "modules/cloth/src/cloth_contacts.h"
#include "modules/cloth/src/cloth_wind.h"

namespace jostle::modules::cloth_detail {

using namespace physics;

namespace {

// A cloth and its bodies rest for this time before they sleep, as bodies do, s.
constexpr double time_to_sleep = 0.5;

// Destroyed bodies release the cloth.
void drop_lost_bodies(const World& world, Cloth& cloth) {
    const std::size_t before = cloth.attachments.size();
    std::erase_if(cloth.attachments, [&](const ClothAttachment& attachment) {
        return !is_null(attachment.body) && !world.contains(attachment.body);
    });
    if (cloth.attachments.size() != before) wake(cloth);
    cloth.bodies.begin_step(world, supports_of(cloth));
}

// Bodies that may reach the cloth in this step join its group before they touch it: otherwise they
// would pass it in their own motion. Returns whether one is new.
bool expect_bodies(Cloth& cloth, double dt, Vec3 gravity) {
    const Sheet& sheet = cloth.sheet;
    double reach = cloth.def.thickness + dt * greatest_speed(sheet);
    bool any = false;
    reach += longest_edge(sheet);
    for (const NearbyShapes::Body& body : cloth.nearby.bodies()) {
        if (body.type != BodyType::dynamic || !body.awake || cloth.bodies.is_attached_to(body.id))
            continue;
        const Vec3 path = (body.linear_velocity + gravity * dt) * dt;
        const double path2 = length_squared(path);
        for (std::size_t k = 0; k < sheet.size(); k++) {
            const Vec3 to = sheet.position(k) - body.start_center;
            const double t = path2 > 0 ? clamp(dot(to, path) / path2, 0, 1) : 0;
            const double most = body.radius + reach;
            if (length_squared(to - path * t) > most * most) continue;
            if (cloth.bodies.touch(body.id)) any = true;
            break;
        }
    }
    return any;
}

// ---- a part of a sub-step ----

class Part {
public:
    Part(Cloth& cloth, Vec3 gravity, double h, int bends)
        : cloth_(cloth), gravity_(gravity), h_(h), bends_(bends) {}

    // Up to the contacts between sheets.
    void begin() {
        cloth_.bodies.pull_grabs(h_);
        cloth_.bodies.place(cloth_.nearby);
        find_contacts(cloth_, h_, gravity_);
        cloth_.sheet.predict(h_, gravity_);
        hold_attachments();
        cloth_.sheet.solve_bends(h_, bends_);
        press_contacts(cloth_, h_);
        cloth_.sheet.solve_threads(h_);
        note_overloads();
        resolve_contacts(cloth_, h_);
    }
    void end() {
        release_attachments();
        cloth_.sheet.finish(h_, gravity_, cloth_.def.damping);
        cloth_.bodies.move(h_);
    }

private:
    // An attached vertex and its share of the body move as one mass.
    void hold_attachments() {
        Sheet& sheet = cloth_.sheet;
        cloth_.own_moved.resize(cloth_.attachments.size());
        cloth_.common_moved.resize(cloth_.attachments.size());
        for (std::size_t k = 0; k < cloth_.attachments.size(); k++) {
            const ClothAttachment& attachment = cloth_.attachments[k];
            const std::uint32_t v = attachment.vertex;
            const Vec3 at = sheet.position(v);
            const double own = sheet.free_inverse_mass(v);
            cloth_.own_moved[k] = sheet.moved(v);
            double inverse_mass = 0;
            Vec3 moved = attachment.point - at;
            if (const CarriedBody* body = cloth_.bodies.attached(k)) {
                const Vec3 arm = body->arm_to(attachment.point);
                const Vec3 drift = body->center + arm - at, travel = body->travel_of(arm, h_);
                moved = drift + travel;
                if (body->is_pushed()) {
                    const double others = response_bound(*body, arm) * body->attached;
                    inverse_mass = own * others / (own + others);
                    moved = drift +
                            (travel * own + cloth_.own_moved[k] * others) * (1 / (own + others));
                }
            }
            sheet.set_inverse_mass(v, inverse_mass);
            sheet.set_moved(v, moved);
            cloth_.common_moved[k] = sheet.moved(v);
        }
    }
    // At least the response of the point in any direction, so that shares never overshoot.
    static double response_bound(const CarriedBody& body, Vec3 arm) {
        const Mat3 r = point_response(body.response, arm);
        return r.x.x + r.y.y + r.z.z;
    }

    // The body gets what the sheet did to the common mass, less what the vertex took.
    void release_attachments() {
        Sheet& sheet = cloth_.sheet;
        for (std::size_t k = 0; k < cloth_.attachments.size(); k++) {
            const std::uint32_t v = cloth_.attachments[k].vertex;
            const double inverse_mass = sheet.inverse_mass(v), own = sheet.free_inverse_mass(v);
            sheet.set_inverse_mass(v, own);
            if (inverse_mass == 0) continue;
            CarriedBody& body = *cloth_.bodies.attached(k);
            const Vec3 moved = sheet.moved(v);
            const Vec3 impulse = (moved - cloth_.common_moved[k]) * (1 / (inverse_mass * h_)) -
                                 (moved - cloth_.own_moved[k]) * (1 / (own * h_));
            body.push(impulse, body.arm_to(cloth_.attachments[k].point));
        }
    }

    void note_overloads() {
        if (cloth_.def.breaking_load == 0) return;
        const Sheet& sheet = cloth_.sheet;
        const std::vector<SheetEdge>& edges = sheet.topology().edges;
        for (std::uint32_t e = 0; e < edges.size(); e++) {
            const double tension = sheet.tension(e) / edges[e].width;
            if (tension <= cloth_.def.breaking_load || sheet.is_torn(e)) continue;
            if (cloth_.overloaded.empty()) cloth_.overload = tension;
            cloth_.overloaded.push_back(e);
        }
    }

    Cloth& cloth_;
    const Vec3 gravity_;
    const double h_;
    const int bends_;  // parts that bending stands for
};

}  // namespace

void wake(Cloth& cloth) {
    cloth.awake = true;
    cloth.rest_time = 0;
}

void begin_step(World& world, Cloth& cloth, double dt) {
    drop_lost_bodies(world, cloth);
    cloth.substeps_done = 0;
    cloth.overloaded.clear();
    cloth.sheet_contacts.begin_step();
    cloth.leader = nullptr;
    cloth.companions.clear();
    cloth.obstacles.clear();
    const double speed = greatest_speed(cloth.sheet);
    const double reach = cloth.def.thickness + dt * (speed + dt * length(world.gravity()));
    if (cloth.def.collide_bodies)
        cloth.nearby.collect(world, bounds_of(cloth.sheet, reach), dt,
                             {.categories = cloth.def.body_categories});
    if (!cloth.awake && cloth.bodies.any_moves(world, cloth.nearby)) wake(cloth);
    std::vector<FieldDef> fields;
    for (const FieldId id : world.fields())
        if (const Result<FieldDef> field = world.field(id); field.ok()) fields.push_back(*field);
    if (cloth.def.wind != Vec3{} || cloth.def.gust != Vec3{})
        fields.push_back({.force = UniformWind{.velocity = cloth.def.wind,
                                               .gust = cloth.def.gust,
                                               .gust_period = cloth.def.gust_period}});
    const bool blown =
        blow(cloth.sheet, fields, cloth.def.drag, cloth.def.mass_per_area, world.time(), dt);
    if (!cloth.awake && blown) {
        const std::vector<float>& a = cloth.sheet.accelerations();
        const auto strong = [](float x) { return absolute(double{x}) > 0.5; };
        if (std::ranges::any_of(a, strong)) wake(cloth);
    }
}

void find_bodies(World& world, Cloth& cloth, double dt) {
    cloth.sheet.rebase();
    cloth.bodies.forget_old_contacts();
    bool moves = expect_bodies(cloth, dt, world.gravity()) || cloth.rest_time == 0;
    // One group of sub-steps owns a leader and its companions, which find their bodies first.
    std::vector<BodyId> others;
    for (const Cloth* companion : cloth.companions) {
        const std::span<const BodyId> tied = companion->bodies.ties().bodies();
        others.insert(others.end(), tied.begin(), tied.end());
        moves = moves || companion->rest_time == 0;
    }
    if (moves) cloth.bodies.tie(world, others);
    cloth.bodies.find(world, cloth.nearby);
}

// Parts of a sub-step in which no body that may touch the cloth moves by more than half an edge.
static int parts_for_bodies(const Cloth& cloth, double h, int least) {
    constexpr int most = 64;
    double fastest = 0;
    for (const CarriedBody& body : cloth.bodies.all())
        if (cloth.bodies.was_touched(body.id))
            fastest = maximum(fastest, length_squared(body.velocity));
    const double needed = h * square_root(fastest) / (0.5 * longest_edge(cloth.sheet));
    int parts = least;
    while (parts < needed && parts < most) parts++;
    return parts;
}

// Parts of a sub-step of a cloth.
static int parts_of(const Cloth& cloth, double h, int count) {
    const int least = (static_cast<int>(cloth.def.substeps) + count - 1) / count;
    return cloth.sheet.stable_parts(h, parts_for_bodies(cloth, h, least));
}

static ContactSheet contact_sheet(Cloth& cloth, bool is_fixed) {
    return {.sheet = &cloth.sheet,
            .number = cloth.key.number,
            .thickness = cloth.def.thickness,
            .friction = cloth.def.friction,
            .collide_self = cloth.def.collide_self,
            .is_fixed = is_fixed};
}

void advance(Cloth& cloth, const ClothSubstep& substep, int count) {
    ASSERT(count >= 1 && substep.h > 0 && cloth.leader == nullptr);
    std::vector<Cloth*> members{&cloth};
    members.insert(members.end(), cloth.companions.begin(), cloth.companions.end());
    if (substep.group != nullptr && members.size() > 1)
        for (Cloth* member : members) member->bodies.push_as_before(*substep.group);
    int parts = 1;
    cloth.contact_sheets.clear();
    for (Cloth* member : members) {
        member->bodies.read(substep.group);
        parts = std::max(parts, parts_of(*member, substep.h, count));
        cloth.contact_sheets.push_back(contact_sheet(*member, false));
    }
    for (Cloth* obstacle : cloth.obstacles)
        cloth.contact_sheets.push_back(contact_sheet(*obstacle, true));
    const bool sheets_touch = cloth.def.collide_self || cloth.contact_sheets.size() > 1;
    const double h = substep.h / parts;
    for (int n = 0; n < parts; n++) {
        const int bends = n % 2 == 1 ? 0 : n + 1 < parts ? 2 : 1;
        for (Cloth* member : members) Part(*member, substep.gravity, h, bends).begin();
        if (sheets_touch) cloth.sheet_contacts.resolve(cloth.contact_sheets);
        for (Cloth* member : members) Part(*member, substep.gravity, h, bends).end();
    }
    for (Cloth* member : members) {
        member->bodies.write(substep.group);
        member->substeps_done++;
    }
}

void end_step(World& world, Cloth& cloth, double dt) {
    if (!cloth.awake) return;
    const bool bodies_rest = cloth.bodies.finish_step(world);
    constexpr double rest_speed = CarriedBodies::rest_speed;
    const bool rests = bodies_rest && mean_speed(cloth.sheet) <= rest_speed &&
                       greatest_speed(cloth.sheet) <= 5 * rest_speed;
    cloth.rest_time = rests ? cloth.rest_time + dt : 0;
    if (cloth.rest_time < time_to_sleep) return;
    if (!cloth.bodies.all_asleep(world)) return;
    cloth.awake = false;
    for (std::size_t k = 0; k < cloth.sheet.size(); k++) cloth.sheet.set_velocity(k, {});
}

}  // namespace jostle::modules::cloth_detail
