// SPDX-License-Identifier: MIT
#include "bench/accuracy/mujoco_model.h"

#include <cstdarg>
#include <cstdio>

namespace jostle::bench::accuracy {
namespace {

std::string triple(Vec3 v) {
    char text[96];
    std::snprintf(text, sizeof text, "\"%.17g %.17g %.17g\"", v.x, v.y, v.z);
    return text;
}

std::string quadruple(Quat q) {
    char text[128];
    std::snprintf(text, sizeof text, "\"%.17g %.17g %.17g %.17g\"", q.w, q.x, q.y, q.z);
    return text;
}

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "\"%.17g\"", value);
    return text;
}

std::string name_of(const char* what, std::size_t index) {
    return std::string("\"") + what + std::to_string(index) + "\"";
}

Transform inverse(const Transform& t) {
    return {inverse_rotate(t.rotation, -t.position), conjugate(t.rotation)};
}

struct GeomText {
    std::size_t body;

    std::string operator()(const physics::Sphere& sphere) const {
        return "type=\"sphere\" size=" + number(sphere.radius);
    }
    std::string operator()(const physics::Box& box) const {
        return "type=\"box\" size=" + triple(box.half_extents);
    }
    std::string operator()(const physics::Cylinder& c) const {  // MuJoCo's cylinders are along z
        return "type=\"cylinder\" quat=\"0.70710678118654757 0.70710678118654757 0 0\" size=" +
               triple({c.radius, c.half_length, 0});
    }
    std::string operator()(const physics::Capsule& c) const {
        return "type=\"capsule\" quat=\"0.70710678118654757 0.70710678118654757 0 0\" size=" +
               triple({c.radius, c.half_length, 0});
    }
    std::string operator()(const OtherShape&) const { return {}; }
    std::string operator()(const physics::Plane&) const {
        return "type=\"plane\" size=\"100 100 1\"";
    }
    std::string operator()(const HullPoints&) const {
        return "type=\"mesh\" mesh=" + name_of("m", body);
    }
};

std::string assets_of(const Scene& scene) {
    std::string text = "<asset>\n";
    for (std::size_t k = 0; k < scene.bodies.size(); k++) {
        const auto& shape = scene.bodies[k].shape;
        const auto* hull = shape ? std::get_if<HullPoints>(&*shape) : nullptr;
        if (!hull) continue;
        std::string points;
        for (const Vec3 p : hull->points) {
            const std::string text_of_point = triple(p);
            points += text_of_point.substr(1, text_of_point.size() - 2) + " ";
        }
        text += "<mesh name=" + name_of("m", k) + " vertex=\"" + points + "\"/>\n";
    }
    return text + "</asset>\n";
}

const char* type_of(JointKind kind) {
    return kind == JointKind::ball ? "ball" : kind == JointKind::hinge ? "hinge" : "slide";
}

class TreeText {
public:
    TreeText(const Scene& scene, const BodyTree& tree) : scene_(scene), tree_(tree) {}

    std::string children_of(int parent) const {
        std::string text;
        for (std::size_t k = 0; k < scene_.bodies.size(); k++)
            if (tree_.nodes[k].parent == parent) text += body(k);
        return text;
    }

private:
    std::string body(std::size_t k) const {
        const Body& body = scene_.bodies[k];
        const BodyTree::Node& node = tree_.nodes[k];
        const Transform local = compose(inverse(pose_of(scene_, node.parent)), body.pose);
        std::string text = "<body name=" + name_of("b", k) + " pos=" + triple(local.position) +
                           " quat=" + quadruple(local.rotation) + ">\n";
        text += "<inertial pos=\"0 0 0\" mass=" + number(body.mass) +
                " diaginertia=" + triple(body.inertia) + "/>\n";
        if (body.shape) text += "<geom " + std::visit(GeomText{k}, *body.shape) + "/>\n";
        if (node.joint && node.joint->kind != JointKind::fixed)
            text += joint(k, *node.joint, body.pose);
        else if (!node.joint && body.motion == Motion::free)
            text += "<freejoint/>\n";
        for (std::size_t j = 0; j < scene_.joints.size(); j++) {
            const Joint& spring = scene_.joints[j];
            if (spring.kind == JointKind::spring && spring.b == static_cast<int>(k))
                text += site("sb", j, apply_inverse(body.pose, spring.anchor_b));
            if (spring.kind == JointKind::spring && spring.a == static_cast<int>(k))
                text += site("sa", j, apply_inverse(body.pose, spring.anchor));
        }
        return text + children_of(static_cast<int>(k)) + "</body>\n";
    }

    static std::string joint(std::size_t body, const Joint& joint, const Transform& pose) {
        std::string text = "<joint name=" + name_of("j", body) + " type=\"" + type_of(joint.kind) +
                           "\" pos=" + triple(apply_inverse(pose, joint.anchor));
        if (joint.kind != JointKind::ball)
            text += " axis=" + triple(inverse_rotate(pose.rotation, joint.axis));
        if (joint.limit)
            text += " limited=\"true\" range=\"" + std::to_string(joint.limit->lower) + " " +
                    std::to_string(joint.limit->upper) + "\"";
        return text + "/>\n";
    }

public:
    static std::string site(const char* end, std::size_t joint, Vec3 at) {
        return "<site name=" + name_of(end, joint) + " pos=" + triple(at) + "/>\n";
    }

private:
    const Scene& scene_;
    const BodyTree& tree_;
};

// A hinge that closes a planar loop of hinges needs only a point constraint.
std::string loops_of(const Scene& scene, const BodyTree& tree) {
    std::string text = "<equality>\n";
    for (const Joint& loop : tree.loops) {
        text += "<connect body1=" + name_of("b", static_cast<std::size_t>(loop.b)) +
                " anchor=" + triple(apply_inverse(pose_of(scene, loop.b), loop.anchor));
        if (loop.a != ground) text += " body2=" + name_of("b", static_cast<std::size_t>(loop.a));
        text += "/>\n";
    }
    return text + "</equality>\n";
}

std::string springs_of(const Scene& scene) {
    std::string text = "<tendon>\n";
    for (std::size_t j = 0; j < scene.joints.size(); j++) {
        const Joint& spring = scene.joints[j];
        if (spring.kind != JointKind::spring) continue;
        text += "<spatial stiffness=" + number(spring.stiffness) +
                " damping=" + number(spring.damping) +
                " springlength=" + number(spring.rest_length) + "><site site=" + name_of("sa", j) +
                "/><site site=" + name_of("sb", j) + "/></spatial>\n";
    }
    return text + "</tendon>\n";
}

// A motor is a damper towards the target speed with a limited torque. The gain of weak motors is
// limited by the stability of the explicit integrator.
constexpr double weak = 100;  // N m

std::string motors_of(const BodyTree& tree) {
    std::string text = "<actuator>\n";
    for (std::size_t k = 0; k < tree.nodes.size(); k++) {
        const auto& joint = tree.nodes[k].joint;
        if (!joint || !joint->motor) continue;
        const double most = joint->motor->max_torque;
        text += "<velocity joint=" + name_of("j", k) + " kv=" + number(most > weak ? 1e4 : 5) +
                " forcelimited=\"true\" forcerange=\"-" + std::to_string(most) + " " +
                std::to_string(most) + "\"/>\n";
    }
    return text + "</actuator>\n";
}

// Memory for contacts and their rows; MuJoCo allocates the square of the rows.
std::string size_of(const Scene& scene) {
    std::size_t solids = 0;
    for (const Body& body : scene.bodies) solids += body.shape.has_value();
    const std::size_t contacts = 50 + 10 * solids;
    return "<size nconmax=\"" + std::to_string(contacts) + "\" njmax=\"" +
           std::to_string(3 * contacts) + "\"/>\n";
}

std::string option_of(const Scene& scene, const std::string& mode) {
    const bool rk4 = mode.find("rk4") != std::string::npos;
    const bool implicit = mode.find("implicit") != std::string::npos;
    return "<option gravity=" + triple(scene.gravity) + " integrator=\"" +
           (rk4        ? "RK4"
            : implicit ? "implicit"
                       : "Euler") +
           "\" solver=\"" + (mode.starts_with("cg") ? "CG" : "Newton") + "\" cone=\"elliptic\"/>\n";
}

}  // namespace

Result<std::string> mujoco_xml(const Scene& scene, const BodyTree& tree, const std::string& mode) {
    if (scene.continuous) return Error{.message = "mujoco has no continuous collision detection"};
    if (scene.restitution > 0) return Error{.message = "mujoco has no restitution parameter"};
    for (const Joint& joint : scene.joints) {
        if (joint.kind == JointKind::rod) return Error{.message = "mujoco does not support rods"};
        if (joint.misaligned_anchor_b)
            return Error{.message = "misaligned joints are not implemented for mujoco"};
        if (joint.motor && joint.motor->max_torque > weak && mode.find("implicit") == mode.npos)
            return Error{.message = "strong motors require mujoco's implicit integrator"};
    }
    for (const Body& body : scene.bodies)
        if (body.motion == Motion::kinematic)
            return Error{.message = "driven bodies are not implemented for mujoco"};
    std::string sites;
    for (std::size_t j = 0; j < scene.joints.size(); j++)
        if (scene.joints[j].kind == JointKind::spring && scene.joints[j].a == ground)
            sites += TreeText::site("sa", j, scene.joints[j].anchor);
    return "<mujoco>\n<compiler angle=\"radian\"/>\n" + size_of(scene) + option_of(scene, mode) +
           "<default><geom condim=\"" + (scene.friction > 0 ? "3" : "1") +
           "\" friction=" + triple({scene.friction, 0, 0}) + "/></default>\n" + assets_of(scene) +
           "<worldbody>\n" + sites + TreeText(scene, tree).children_of(ground) + "</worldbody>\n" +
           springs_of(scene) + loops_of(scene, tree) + motors_of(tree) + "</mujoco>\n";
}

}  // namespace jostle::bench::accuracy
