// SPDX-License-Identifier: MIT
#include "bench/speed/engine_kinds.h"

#include <ode/ode.h>

#include <algorithm>
#include <vector>

#include "bench/speed/portable_scene.h"

namespace jostle::bench {
namespace {

using physics::Quat;
using physics::Transform;
using physics::Vec3;
using scenes::SceneBody;
using scenes::SceneDescription;
using scenes::SceneJoint;

constexpr int contacts_per_pair = 4;

struct OdeQuaternion {
    dQuaternion values;  // w first

    explicit OdeQuaternion(Quat q) : values{q.w, q.x, q.y, q.z} {}
};

dGeomID make_geom(const physics::Sphere& sphere) {
    return dCreateSphere(nullptr, sphere.radius);
}

dGeomID make_geom(const physics::Capsule& capsule) {
    return dCreateCapsule(nullptr, capsule.radius, 2 * capsule.half_length);
}

dGeomID make_geom(const physics::Box& box) {
    const Vec3 sides = box.half_extents * 2;
    return dCreateBox(nullptr, sides.x, sides.y, sides.z);
}

dMass ode_mass(const SolidMass& solid) {
    const physics::Mat3& m = solid.inertia;
    dMass mass;
    dMassSetParameters(&mass, solid.mass, 0, 0, 0, m.x.x, m.y.y, m.z.z, m.x.y, m.x.z, m.y.z);
    return mass;
}

// ODE's capsules are along z, those of the scenes along y.
Transform geom_pose(const Part& part) {
    if (!std::holds_alternative<physics::Capsule>(part.shape)) return part.pose;
    return {part.pose.position,
            part.pose.rotation * physics::from_axis_angle({1, 0, 0}, -0.5 * physics::pi)};
}

// ODE's convex shapes and meshes do not collide with all other shapes.
bool has_geom(const Part& part) {
    return !std::holds_alternative<physics::Hull>(part.shape) &&
           !std::holds_alternative<physics::Mesh>(part.shape);
}

class OdeEngine final : public Engine {
public:
    OdeEngine() {
        dInitODE2(0);
        dRandSetSeed(0);  // QuickStep shuffles its rows; the seed makes runs repeatable
        world_ = dWorldCreate();
        space_ = dHashSpaceCreate(nullptr);
        contacts_ = dJointGroupCreate(0);
    }

    ~OdeEngine() override {
        dJointGroupDestroy(contacts_);
        for (const dGeomID geom : loose_geoms_) dGeomDestroy(geom);
        dSpaceDestroy(space_);  // including its geoms
        dWorldDestroy(world_);
        dCloseODE();
    }

    OdeEngine(const OdeEngine&) = delete;
    OdeEngine& operator=(const OdeEngine&) = delete;

    physics::Status init(const SceneDescription& scene) override {
        if (auto status = check_portable(scene); !status) return status;
        scene_ = &scene;
        step_seconds_ = 1 / scene.hz;
        const Vec3 gravity = scene.world.gravity;
        dWorldSetGravity(world_, gravity.x, gravity.y, gravity.z);
        dWorldSetLinearDampingThreshold(world_, 0);
        dWorldSetAngularDampingThreshold(world_, 0);
        dWorldSetAutoDisableFlag(world_, scene.world.sleeping ? 1 : 0);
        const auto masses = solid_masses(scene);
        if (!masses) return masses.error();
        for (std::size_t k = 0; k < scene.bodies.size(); k++) {
            if (!std::ranges::all_of(parts_of(scene.bodies[k]), has_geom))
                return physics::Error{.message =
                                          "ode: hulls and meshes do not collide with all shapes"};
            add_body(scene.bodies[k], (*masses)[k]);
        }
        for (const SceneJoint& joint : scene.joints) {
            // ODE identifies the pairs that a joint excludes by their bodies; static bodies have
            // none.
            for (const std::size_t end : {joint.body_a, joint.body_b})
                if (is_static(scene.bodies[end]) && collides(scene.bodies[end]))
                    return physics::Error{
                        .message = "ode: joints to colliding static bodies are not supported"};
            add_joint(joint);
        }
        return {};
    }

    void step() override {
        dSpaceCollide(space_, this, &OdeEngine::on_pair);
        dWorldQuickStep(world_, step_seconds_);
        dJointGroupEmpty(contacts_);
    }

    Transform pose(std::uint32_t body) const override {
        const dBodyID id = bodies_[body];
        if (id == nullptr) return scene_->bodies[body].body.pose;
        const dReal *at = dBodyGetPosition(id), *q = dBodyGetQuaternion(id);
        const Quat rotation{q[1], q[2], q[3], q[0]};
        return {Vec3{at[0], at[1], at[2]} - rotate(rotation, centers_[body]), rotation};
    }

    Vec3 velocity(std::uint32_t body) const override {
        if (bodies_[body] == nullptr) return {};
        const dReal* v = dBodyGetLinearVel(bodies_[body]);
        return {v[0], v[1], v[2]};
    }

    void set_velocity(std::uint32_t body, Vec3 linear) override {
        dBodyEnable(bodies_[body]);
        dBodySetLinearVel(bodies_[body], linear.x, linear.y, linear.z);
    }

    int awake() const override {
        return static_cast<int>(std::ranges::count_if(bodies_, is_awake));
    }

private:
    static void on_pair(void* self, dGeomID a, dGeomID b) {
        static_cast<OdeEngine*>(self)->collide(a, b);
    }

    static double friction(dGeomID geom) {
        return static_cast<const SceneBody*>(dGeomGetData(geom))->shapes[0].material.friction;
    }

    static bool is_awake(dBodyID body) {
        return body != nullptr && dBodyIsKinematic(body) == 0 && dBodyIsEnabled(body) != 0;
    }

    void collide(dGeomID a, dGeomID b) {
        const dBodyID body_a = dGeomGetBody(a), body_b = dGeomGetBody(b);
        if (!is_awake(body_a) && !is_awake(body_b)) return;
        if (body_a && body_b && dAreConnectedExcluding(body_a, body_b, dJointTypeContact)) return;
        dContact found[contacts_per_pair];
        const int count = dCollide(a, b, contacts_per_pair, &found[0].geom, sizeof(dContact));
        const double pair_friction = physics::square_root(friction(a) * friction(b));
        for (int k = 0; k < count; k++) {
            found[k].surface.mode = dContactApprox1;  // otherwise mu would be a force
            found[k].surface.mu = pair_friction;
            dJointAttach(dJointCreateContact(world_, contacts_, &found[k]), body_a, body_b);
        }
    }

    // In ODE a static body has geoms only, no dBody.
    void add_body(const SceneBody& body, const SolidMass& solid) {
        centers_.push_back(solid.center);
        bodies_.push_back(is_static(body) ? nullptr : add_moving(body, solid));
        for (const Part& part : parts_of(body)) {
            const dGeomID geom = std::visit(
                []<class Shape>(const Shape& shape) -> dGeomID {
                    if constexpr (requires { make_geom(shape); })
                        return make_geom(shape);
                    else
                        return nullptr;
                },
                part.shape);
            dGeomSetData(geom, const_cast<SceneBody*>(&body));
            if (collides(body))
                dSpaceAdd(space_, geom);
            else
                loose_geoms_.push_back(geom);
            place(geom, body, geom_pose(part));
        }
    }

    void place(dGeomID geom, const SceneBody& body, const Transform& in_body) {
        if (const dBodyID id = bodies_.back()) {
            const Vec3 at = in_body.position - centers_.back();
            dGeomSetBody(geom, id);
            dGeomSetOffsetPosition(geom, at.x, at.y, at.z);
            dGeomSetOffsetQuaternion(geom, OdeQuaternion(in_body.rotation).values);
            return;
        }
        const auto [at, rotation] = compose(body.body.pose, in_body);
        dGeomSetPosition(geom, at.x, at.y, at.z);
        dGeomSetQuaternion(geom, OdeQuaternion(rotation).values);
    }

    dBodyID add_moving(const SceneBody& body, const SolidMass& solid) {
        const dBodyID id = dBodyCreate(world_);
        if (is_dynamic(body)) {
            const dMass mass = ode_mass(solid);
            dBodySetMass(id, &mass);
        } else {
            dBodySetKinematic(id);
        }
        const physics::BodyDef& def = body.body;
        const Vec3 at = apply(def.pose, solid.center), v = def.linear_velocity,
                   w = def.angular_velocity;
        dBodySetPosition(id, at.x, at.y, at.z);
        dBodySetQuaternion(id, OdeQuaternion(def.pose.rotation).values);
        dBodySetLinearVel(id, v.x, v.y, v.z);
        dBodySetAngularVel(id, w.x, w.y, w.z);
        // ODE's damping is a fraction of the velocity per step; that of the scenes is per second.
        if (is_dynamic(body)) {
            dBodySetLinearDamping(id, def.linear_damping * step_seconds_);
            dBodySetAngularDamping(id, def.angular_damping * step_seconds_);
        }
        return id;
    }

    void add_joint(const SceneJoint& joint) {
        const JointAxes axes = axes_of(*scene_, joint);
        const dBodyID a = bodies_[joint.body_a], b = bodies_[joint.body_b];
        if (const auto* hinge = std::get_if<physics::HingeJoint>(&joint.joint.kind))
            return add_hinge(a, b, axes, *hinge);
        const Vec3 at = axes.anchor;
        const dJointID ball = dJointCreateBall(world_, nullptr);
        dJointAttach(ball, a, b);
        dJointSetBallAnchor(ball, at.x, at.y, at.z);
        if (const auto* shoulder = std::get_if<physics::ConeTwistJoint>(&joint.joint.kind))
            add_swing_limits(a, b, axes, *shoulder);
    }

    void add_hinge(dBodyID a, dBodyID b, const JointAxes& axes, const physics::HingeJoint& def) {
        const Vec3 at = axes.anchor, axis = axes.z;
        const dJointID hinge = dJointCreateHinge(world_, nullptr);
        dJointAttach(hinge, a, b);
        dJointSetHingeAnchor(hinge, at.x, at.y, at.z);
        dJointSetHingeAxis(hinge, axis.x, axis.y, axis.z);
        // ODE's hinge angle is that of a relative to b.
        if (def.limit.enabled) {
            dJointSetHingeParam(hinge, dParamLoStop, -def.limit.upper);
            dJointSetHingeParam(hinge, dParamHiStop, -def.limit.lower);
        }
        if (def.motor.enabled) {
            dJointSetHingeParam(hinge, dParamVel, -def.motor.speed);
            dJointSetHingeParam(hinge, dParamFMax, def.motor.max_torque);
        }
    }

    // Euler angles: two swings, the first about a's own normal, then the twist about b's own axis.
    // In this order the twist does not change the direction of the arm.
    void add_swing_limits(dBodyID a, dBodyID b, const JointAxes& axes,
                          const physics::ConeTwistJoint& shoulder) {
        const dJointID motor = dJointCreateAMotor(world_, nullptr);
        dJointAttach(motor, a, b);
        dJointSetAMotorMode(motor, dAMotorEuler);
        dJointSetAMotorAxis(motor, 0, 1, axes.z.x, axes.z.y, axes.z.z);
        dJointSetAMotorAxis(motor, 2, 2, axes.x.x, axes.x.y, axes.x.z);
        const double twist = std::max(-shoulder.twist.lower, shoulder.twist.upper);
        dJointSetAMotorParam(motor, dParamLoStop, -shoulder.swing);
        dJointSetAMotorParam(motor, dParamHiStop, shoulder.swing);
        dJointSetAMotorParam(motor, dParamLoStop2, -shoulder.swing);
        dJointSetAMotorParam(motor, dParamHiStop2, shoulder.swing);
        dJointSetAMotorParam(motor, dParamLoStop3, -twist);
        dJointSetAMotorParam(motor, dParamHiStop3, twist);
    }

    const SceneDescription* scene_ = nullptr;
    double step_seconds_ = 0;
    dWorldID world_ = nullptr;
    dSpaceID space_ = nullptr;
    dJointGroupID contacts_ = nullptr;
    std::vector<dBodyID> bodies_;       // null: static
    std::vector<Vec3> centers_;         // of mass, in each body, m
    std::vector<dGeomID> loose_geoms_;  // in no space: without collision
};

}  // namespace

std::unique_ptr<Engine> make_ode_engine() {
    return std::make_unique<OdeEngine>();
}

}  // namespace jostle::bench
