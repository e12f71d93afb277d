// SPDX-License-Identifier: MIT
//
// The bodies that a deformable, such as a rope, is attached to or touches in a step: where they are
// in each part of a sub-step, how they respond, and the impulses that they receive. All dynamic
// ones are tied (island_ties.h), so one group of SubstepContext contains them. Impulses on bodies
// outside of that group act after the step. Grabs that hold the deformable (point_grab.h) are
// carried like bodies.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jostle/modules/island_ties.h"
#include "jostle/modules/point_grab.h"
#include "jostle/physics/nearby_shapes.h"
#include "jostle/physics/state_visitor.h"
#include "jostle/physics/step_listener.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

/// The support of an attachment: a body, a grab, or, if both are zero, the world.
struct Support {
    physics::BodyId body = {};
    std::uint32_t holder = 0;  ///< of the grab
};

/// A body or a grab in a sub-step of a deformable. Its motion includes the impulses of the
/// deformable.
struct CarriedBody {
    physics::BodyId id = {};
    std::uint32_t holder = 0;  ///< not 0: it is the grab of this holder
    physics::BodyType type = physics::BodyType::dynamic;
    bool in_group = false;  ///< otherwise it gets the impulses after the step
    physics::Vec3 center = {}, velocity = {}, spin = {};
    physics::Vec3 start_center = {};  ///< of the sub-step of the group: impulses act about it
    physics::Quat rotation = {};
    physics::Transform origin = {};  ///< of the body relative to its centre, body axes
    physics::BodyResponse response = {};
    physics::Vec3 impulse = {}, angular_impulse = {};    ///< N s, N m s: of this sub-step
    physics::Vec3 last = {}, last_angular = {};          ///< of the last sub-step
    physics::Vec3 expected = {}, expected_angular = {};  ///< that it got by push_as_before()
    std::uint32_t attached = 0, touching = 0;            ///< places that share its mass

    /// Whether impulses change its motion.
    bool is_pushed() const;
    /// Vector from the centre to a point of the body, given in its frame, m.
    physics::Vec3 arm_to(physics::Vec3 point) const;
    /// Motion of a point in the next h seconds without further impulses, m.
    physics::Vec3 travel_of(physics::Vec3 arm, double h) const;
    /// Applies an impulse at an arm from the centre, or an angular impulse. No effect on bodies
    /// that are not dynamic.
    void push(physics::Vec3 new_impulse, physics::Vec3 arm);
    void push_angular(physics::Vec3 new_impulse) { push_both({}, new_impulse); }

private:
    void push_both(physics::Vec3 linear, physics::Vec3 angular);
};

/// The bodies of one deformable. Contacts, ties and grabs belong to the state of its module; all
/// other data is that of the current step.
class CarriedBodies {
public:
    static constexpr std::uint32_t none = 0xffffffff;
    /// A deformable and its bodies rest below this speed, m/s.
    static constexpr double rest_speed = 0.05;

    // --- before a step ---
    /// Sets the supports of the attachments, and forgets contacts with bodies that were destroyed
    /// and grabs that are not supports.
    void begin_step(const physics::World& world, std::vector<Support> supports);
    /// Whether an attached body or one of the nearby ones moves, or a grab holds the deformable.
    bool any_moves(const physics::World& world, const physics::NearbyShapes& nearby) const;
    /// Forgets contacts that ended 10 steps ago.
    void forget_old_contacts();
    /// Ties the dynamic bodies among the attached ones, those touched recently and `others`, and
    /// wakes them.
    void tie(physics::World& world, std::span<const physics::BodyId> others = {});
    /// Finds the attached bodies and the nearby ones, as they are before the step.
    void find(const physics::World& world, const physics::NearbyShapes& nearby);
    /// Notes a contact with a dynamic body. Returns whether it is new.
    bool touch(physics::BodyId body);
    bool is_attached_to(physics::BodyId body) const;

    // --- the bodies found ---
    std::vector<CarriedBody>& all() { return bodies_; }
    const std::vector<CarriedBody>& all() const { return bodies_; }
    /// Of an attachment; null if it holds to the world.
    CarriedBody* attached(std::size_t index) {
        const std::uint32_t body = index < attached_.size() ? attached_[index] : none;
        return body == none ? nullptr : &bodies_[body];
    }
    /// Index in all() of a body of NearbyShapes::bodies(), or none.
    std::uint32_t index_of_nearby(std::size_t body) const { return nearby_[body]; }
    bool was_touched(physics::BodyId body) const;
    /// Highest speed of a centre, m/s.
    double greatest_speed() const;

    // --- in a sub-step ---
    /// Gives the bodies of a group the impulses of the last sub-step, which write() replaces.
    /// Deformables that share bodies call it before the first of them reads: each then carries its
    /// part of a body instead of the whole body.
    void push_as_before(physics::SubstepContext& group);
    /// Reads the motion of the bodies of a group, and applies the impulses to them. Null: no group.
    void read(const physics::SubstepContext* group);
    void write(physics::SubstepContext* group);
    /// Accelerates the grabs by their springs in the next h seconds.
    void pull_grabs(double h);
    /// Moves the shapes of the bodies to where they are.
    void place(physics::NearbyShapes& nearby) const;
    /// Moves the bodies by h seconds.
    void move(double h);

    // --- after a step ---
    /// Applies the impulses on bodies outside of the group. Sleeping bodies are not woken by those
    /// that would change their velocity by less than 0.02 m/s. Returns whether all bodies rest and
    /// no grab holds the deformable.
    bool finish_step(physics::World& world);
    bool all_asleep(const physics::World& world) const;

    // --- grabs ---
    /// The grab of a holder; null if there is none.
    PointGrab* grab(std::uint32_t holder);
    void add_grab(const PointGrab& grab);
    void remove_grab(std::uint32_t holder);
    const std::vector<PointGrab>& grabs() const { return grabs_; }
    /// Whether all these holders have a grab: loaded states are checked with it.
    bool has_grabs_of(std::span<const Support> supports);

    IslandTies& ties() { return ties_; }
    const IslandTies& ties() const { return ties_; }
    void visit(physics::StateVisitor& v);

private:
    // A dynamic body touched in the last steps.
    struct Touched {
        physics::BodyId body = {};
        std::uint32_t steps_since = 0;
    };
    // The impulses of the last sub-step on a body, for push_as_before().
    struct LastPush {
        physics::BodyId body = {};
        physics::Vec3 impulse = {}, angular_impulse = {};  // N s, N m s about the centre
    };
    std::uint32_t carry(const physics::World& world, physics::BodyId id);

    std::vector<Touched> touched_;       // sorted by body
    std::vector<PointGrab> grabs_;       // sorted by holder
    std::vector<LastPush> last_pushes_;  // sorted by body; empty without push_as_before()
    IslandTies ties_;

    std::vector<Support> supports_;        // per attachment
    std::vector<CarriedBody> bodies_;      // first those of the attachments
    std::vector<std::uint32_t> attached_;  // per attachment: index in bodies_, or none
    std::vector<std::uint32_t> nearby_;    // per nearby body
    bool pushes_as_before_ = false;        // in this step
};

}  // namespace jostle::modules
