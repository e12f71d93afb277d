// SPDX-License-Identifier: MIT
//
// C interface of the predictor, for hosts other than C++: browsers by way of WebAssembly
// (clients/web/sdk/src/prediction/predictor.ts). jostle/client/predictor.h documents prediction and
// correction.
//
// Arguments and results of more than one number use one buffer of numbers. The host requests the
// buffer, fills it, and calls the function that reads it. A function that returns several numbers
// writes them into the buffer. A call that would read more numbers than the buffer has, or invalid
// numbers, has no effect and returns 0. One thread at a time per predictor.
#pragma once

#include <stdint.h>

#ifdef __wasm__
#define JOSTLE_EXPORT(name) __attribute__((export_name(#name)))
#define JOSTLE_IMPORT(name) __attribute__((import_module("jostle"), import_name(#name)))
#else
#define JOSTLE_EXPORT(name)
#define JOSTLE_IMPORT(name)
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct JostlePredictor JostlePredictor;

JOSTLE_EXPORT(create) JostlePredictor* jostle_predictor_create(void);
JOSTLE_EXPORT(destroy) void jostle_predictor_destroy(JostlePredictor*);

// Returns the buffer with room for `count` numbers; existing numbers are preserved as far as they
// fit. Valid until the next call that resizes the buffer or returns numbers. Returns 0 if count is
// above 2^24.
JOSTLE_EXPORT(buffer) double* jostle_predictor_buffer(JostlePredictor*, uint32_t count);

// Starts a stream: tick rate in Hz, gravity in m/s^2, sub-steps per tick (0: 8). Discards all
// bodies and the followed entity.
JOSTLE_EXPORT(begin)
void jostle_predictor_begin(JostlePredictor*, double tick_hz, double x, double y, double z,
                            uint32_t substeps);

// Adds a body: type 0 static, 1 kinematic, 2 dynamic; mass in kg of a dynamic body. Replaces a body
// with the same entity.
JOSTLE_EXPORT(add_body)
void jostle_predictor_add_body(JostlePredictor*, uint32_t entity, uint32_t type, double mass);
// Sets the motion parameters of a body that differ from the defaults: damping (1/s), gravity scale,
// locks (AxisLocks), and its other movers on the server: 1 a module (Entity.controllable), 2 joints
// (Entity.jointed), 3 both. Call it after add_body.
JOSTLE_EXPORT(set_body)
void jostle_predictor_set_body(JostlePredictor*, uint32_t entity, double linear_damping,
                               double angular_damping, double gravity_scale, uint32_t locks,
                               uint32_t moved_by);
JOSTLE_EXPORT(remove_body) void jostle_predictor_remove_body(JostlePredictor*, uint32_t entity);
// Sets the shapes of a body, encoded as in shape_encoding.h. The host calls it after
// request_shapes, once per body. Returns 1 if the shapes are valid.
JOSTLE_EXPORT(set_shapes)
uint32_t jostle_predictor_set_shapes(JostlePredictor*, uint32_t entity, uint32_t count);
// Implemented by the host: the predictor requests the shapes of a body.
JOSTLE_IMPORT(request_shapes)
void jostle_predictor_request_shapes(JostlePredictor*, uint32_t entity);

// Selects the entity whose motion is predicted; 0: none.
JOSTLE_EXPORT(follow) void jostle_predictor_follow(JostlePredictor*, uint32_t entity);

// Inputs with a sequence number (from 1), meant for a tick (from 1). An input with the same number
// as the last one replaces it. Impulses in N s; points and targets in world coordinates, m.
JOSTLE_EXPORT(push)
void jostle_predictor_push(JostlePredictor*, uint32_t sequence, uint32_t tick, uint32_t entity,
                           double x, double y, double z);
JOSTLE_EXPORT(push_at)
void jostle_predictor_push_at(JostlePredictor*, uint32_t sequence, uint32_t tick, uint32_t entity,
                              double x, double y, double z, double point_x, double point_y,
                              double point_z);
JOSTLE_EXPORT(grab)
void jostle_predictor_grab(JostlePredictor*, uint32_t sequence, uint32_t tick, uint32_t entity,
                           double x, double y, double z);
JOSTLE_EXPORT(drag)
void jostle_predictor_drag(JostlePredictor*, uint32_t sequence, uint32_t tick, double x, double y,
                           double z);
JOSTLE_EXPORT(release)
void jostle_predictor_release(JostlePredictor*, uint32_t sequence, uint32_t tick);
// Control state of the controlled entity. Buffer: `axes` numbers, each -1 to 1.
JOSTLE_EXPORT(steer)
void jostle_predictor_steer(JostlePredictor*, uint32_t sequence, uint32_t tick, uint32_t axes,
                            uint32_t buttons);
// Result of an input: applied (1) in that tick, or rejected (0).
JOSTLE_EXPORT(result)
void jostle_predictor_result(JostlePredictor*, uint32_t sequence, uint32_t tick, uint32_t applied);

// Velocities of bodies in the next frame, if they were received. Buffer, per body in ascending
// order of entity: entity, velocity of the centre of mass (3), angular velocity (3), in the integer
// units of `jostle.motion` (proto/WIRE.md, "Channels").
JOSTLE_EXPORT(velocities) uint32_t jostle_predictor_velocities(JostlePredictor*, uint32_t bodies);
// State of the controlled entity after a tick (proto/WIRE.md, "Controlled entity"); valid until the
// next one. Buffer: the characters of the module's tag, then the words. Returns 1 if they are
// accepted.
JOSTLE_EXPORT(control)
uint32_t jostle_predictor_control(JostlePredictor*, uint32_t entity, uint32_t tick,
                                  uint32_t letters, uint32_t words);
// A frame of the server. Buffer, per body in ascending order of entity: entity, position (3),
// rotation (4: x y z w), at rest (0 or 1). Bodies that were not added are ignored.
JOSTLE_EXPORT(frame)
uint32_t jostle_predictor_frame(JostlePredictor*, uint32_t number, uint32_t bodies);

// Returns the number of bodies whose rendered poses the predictor provides; their entities are in
// the buffer.
JOSTLE_EXPORT(predicted) uint32_t jostle_predictor_predicted(JostlePredictor*);
// Computes the poses of a rendered frame: `position` of the input clock in ticks, `now_us` on the
// host's clock. Buffer, for each body of drawn(): entity, position (3), rotation (4), as
// interpolated; bodies without a pose are omitted. The poses to render replace them. Returns their
// number.
JOSTLE_EXPORT(sample)
uint32_t jostle_predictor_sample(JostlePredictor*, double position, double now_us, uint32_t bodies);

// Statistics: 0 compared frames, 1 corrections, 2 simulated steps, 3 largest error of the last
// frame in m, 4 predicted bodies, 5 bodies whose shapes were invalid, 6 compared states of the
// controlled entity, 7 corrections of it, 8 error of the last one in m.
JOSTLE_EXPORT(stat) double jostle_predictor_stat(const JostlePredictor*, uint32_t which);

#ifdef __cplusplus
}
#endif
