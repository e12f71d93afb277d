// SPDX-License-Identifier: MIT
#include "tools/ctl/inspection_text.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "jostle/base/format_text.h"
#include "tools/common/table.h"
#include "tools/ctl/attribute_arguments.h"

namespace jostle::ctl {

using common::Align, common::Table, common::sanitized;

namespace {

std::string text_of(double number) {
    return format_text("%.5g", number + 0.0);  // not -0
}

std::string text_of(const v1::Vec3& v) {
    return text_of(v.x()) + "  " + text_of(v.y()) + "  " + text_of(v.z());
}

std::string owner_text(std::uint32_t owner) {
    return owner == 0 ? "no client" : "client " + std::to_string(owner);
}

std::string entity_text(std::uint32_t entity) {
    return entity == 0 ? "the world" : std::to_string(entity);
}

// The name of the field that holds its parameters, such as "hinge".
std::string kind_of(const v1::Joint& joint) {
    const auto* const field = joint.GetDescriptor()->FindFieldByNumber(joint.kind_case());
    return field ? field->name() : "unknown";
}

std::string coordinate_unit(const v1::Joint& joint) {
    return joint.has_hinge() ? " rad" : joint.has_slider() || joint.has_distance() ? " m" : "";
}

std::string coordinate_text(const v1::InspectedJoint& joint) {
    const std::string unit = coordinate_unit(joint.joint());
    return unit.empty() ? "-" : text_of(joint.coordinate()) + unit;
}

// One line per property.
class Lines {
public:
    void add(const std::string& name, const std::string& value, const std::string& unit = {}) {
        text_ += name + std::string(name.size() < 18 ? 18 - name.size() : 1, ' ') + value +
                 (unit.empty() ? "" : " " + unit) + "\n";
    }
    std::string text() const { return text_; }

private:
    std::string text_;
};

std::string contacts_table(const v1::InspectedBody& body) {
    Table table({{"ENTITY", Align::right},
                 {"SHAPES"},
                 {"NORMAL"},
                 {"POINTS", Align::right},
                 {"DEEPEST M", Align::right},
                 {"IMPULSE N S", Align::right}});
    for (const v1::InspectedContact& contact : body.contacts()) {
        double impulse = 0, separation = 0;
        for (const v1::InspectedContactPoint& point : contact.points()) {
            impulse += point.impulse();
            separation = std::min(separation, point.separation());
        }
        table.add(
            {std::to_string(contact.entity()),
             std::to_string(contact.shape()) + " with " + std::to_string(contact.other_shape()),
             text_of(contact.normal()), std::to_string(contact.points_size()), text_of(separation),
             text_of(impulse)});
    }
    return table.text();
}

std::string joints_table(const v1::InspectedBody& body) {
    Table table({{"JOINT", Align::right},
                 {"KIND"},
                 {"BODIES"},
                 {"OWNER"},
                 {"COORDINATE", Align::right},
                 {"FORCE N", Align::right},
                 {"TORQUE N M", Align::right}});
    for (const v1::InspectedJoint& joint : body.joints())
        table.add({std::to_string(joint.id()), kind_of(joint.joint()),
                   entity_text(joint.entity_a()) + " and " + entity_text(joint.entity_b()),
                   owner_text(joint.owner()), coordinate_text(joint), text_of(joint.force()),
                   text_of(joint.torque())});
    return table.text();
}

std::string count_title(const std::string& title, std::uint32_t count, int listed) {
    std::string text = "\n" + title + ": " + std::to_string(count);
    if (static_cast<std::uint32_t>(listed) < count)
        text += ", of which " + std::to_string(listed) + " are listed";
    return text + "\n";
}

std::string body_text(const v1::InspectedBody& body) {
    Lines lines;
    lines.add("entity", std::to_string(body.entity()) +
                            (body.name().empty() ? "" : " \"" + sanitized(body.name()) + "\""));
    const bool is_dynamic = body.type() == v1::BODY_TYPE_DYNAMIC;
    lines.add("type", std::string(body.frozen()                            ? "static, frozen"
                                  : is_dynamic                             ? "dynamic"
                                  : body.type() == v1::BODY_TYPE_KINEMATIC ? "kinematic"
                                                                           : "static") +
                          (body.asleep() ? ", asleep" : ""));
    lines.add("owner", owner_text(body.owner()));
    lines.add("position", text_of(body.position()), "m");
    const v1::Quat& turn = body.rotation();
    lines.add("rotation",
              format_text("%.5g  %.5g  %.5g  %.5g", turn.x(), turn.y(), turn.z(), turn.w()),
              "(x y z w)");
    lines.add("velocity", text_of(body.linear_velocity()), "m/s");
    lines.add("angular velocity", text_of(body.angular_velocity()), "rad/s");
    if (is_dynamic) {
        lines.add("mass", text_of(body.mass()), "kg");
        lines.add("center of mass", text_of(body.center_of_mass()), "m");
        lines.add("inertia",
                  text_of(body.inertia_x().x()) + "  " + text_of(body.inertia_y().y()) + "  " +
                      text_of(body.inertia_z().z()),
                  "kg m^2 (diagonal)");
        lines.add("kinetic energy", text_of(body.kinetic_energy()), "J");
        lines.add("gravity scale", text_of(body.gravity_scale()));
        lines.add("island", "bodies: " + std::to_string(body.island_bodies()) + ", lowest entity " +
                                std::to_string(body.island()));
    }
    for (int k = 0; k < body.materials_size(); k++) {
        const v1::InspectedMaterial& material = body.materials(k);
        lines.add("shape " + std::to_string(k),
                  "density " + text_of(material.density()) + " kg/m^3, friction " +
                      text_of(material.friction()) + ", restitution " +
                      text_of(material.restitution()));
    }
    for (const v1::Attribute& attribute : body.attributes())
        lines.add("attribute",
                  sanitized(attribute.key()) + " = " + sanitized(value_text(attribute), 80));
    std::string text = lines.text();
    if (body.contact_count() > 0)
        text += count_title("contacts", body.contact_count(), body.contacts_size()) +
                contacts_table(body);
    if (body.joint_count() > 0)
        text += count_title("joints", body.joint_count(), body.joints_size()) + joints_table(body);
    return text;
}

std::string joint_text(const v1::InspectedJoint& joint) {
    Lines lines;
    lines.add("joint", std::to_string(joint.id()));
    lines.add("kind", kind_of(joint.joint()));
    lines.add("bodies", entity_text(joint.entity_a()) + " and " + entity_text(joint.entity_b()));
    lines.add("owner", owner_text(joint.owner()));
    lines.add("anchor a", text_of(joint.anchor_a()), "m");
    lines.add("anchor b", text_of(joint.anchor_b()), "m");
    if (!coordinate_unit(joint.joint()).empty()) lines.add("coordinate", coordinate_text(joint));
    lines.add("force", text_of(joint.force()), "N");
    lines.add("torque", text_of(joint.torque()), "N m");
    const auto limit = [](double value, const char* unit) {
        return value == 0 ? std::string("unbreakable") : text_of(value) + " " + unit;
    };
    lines.add("breaks at", limit(joint.joint().break_force(), "N") + ", " +
                               limit(joint.joint().break_torque(), "N m"));
    return lines.text();
}

}  // namespace

std::string inspection_text(const v1::InspectResponse& response) {
    const std::string tick = "after tick " + std::to_string(response.tick()) + "\n";
    return tick +
           (response.has_joint() ? joint_text(response.joint()) : body_text(response.body()));
}

}  // namespace jostle::ctl
