// SPDX-License-Identifier: MIT
//
// The predictor for hosts that are not C++: browsers, by way of
// WebAssembly (clients/web/src/prediction/predictor.ts). What it foresees, and how it is put right,
// is in jostle/client/predictor.h.
//
// Whatever is more than a number goes through one list of numbers: the host asks for room, fills
// it, and calls what reads it; what answers more than a number has put it there. A call that reads
// more numbers than there is room for, or numbers that mean nothing, does nothing and answers 0.
// One thread at a time for each predictor.
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

// Room for so many numbers; what was there stays as far as it fits. Good until the next call that
// asks for room, or that answers with numbers. 0: more than 2^24.
JOSTLE_EXPORT(numbers) double* jostle_predictor_buffer(JostlePredictor*, uint32_t count);

// A stream begins: gravity in m/s^2, ticks a second, sub-steps of a tick (0: 8). All bodies are
// forgotten, and who is followed.
JOSTLE_EXPORT(begin)
void jostle_predictor_begin(JostlePredictor*, double tick_hz, double x, double y, double z,
                            uint32_t substeps);

// There is a body: type 0 static, 1 kinematic, 2 dynamic; mass in kg of a dynamic one. One that was
// there is another one now.
JOSTLE_EXPORT(add_body)
void jostle_predictor_add_body(JostlePredictor*, uint32_t entity, uint32_t type, double mass);
// How it moves, where that is not as usual: dampings (1/s), gravity scale, locks (AxisLocks), and
// what else moves it there: 1 a module of the server (Entity.drivable), 2 joints (Entity.jointed),
// 3 both. After add_body.
JOSTLE_EXPORT(set_body)
void jostle_predictor_set_body(JostlePredictor*, uint32_t entity, double linear_damping,
                               double angular_damping, double gravity_scale, uint32_t locks,
                               uint32_t moved_by);
JOSTLE_EXPORT(remove_body) void jostle_predictor_remove_body(JostlePredictor*, uint32_t entity);
// Its shapes, as shape_encoding.h has them. The host calls it when it is asked (below), and once
// for each body. 1: they were understood.
JOSTLE_EXPORT(set_shapes)
uint32_t jostle_predictor_set_shapes(JostlePredictor*, uint32_t entity, uint32_t count);
// The host's: the predictor wants the shapes of a body.
JOSTLE_IMPORT(request_shapes)
void jostle_predictor_request_shapes(JostlePredictor*, uint32_t entity);

// Whose motion is foreseen; 0: nobody's.
JOSTLE_EXPORT(follow) void jostle_predictor_follow(JostlePredictor*, uint32_t entity);

// Inputs of that number (from 1) that are meant for a tick (from 1). One of the same number as the
// last comes in its place. Impulses in N s; points and targets of the world in m.
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
// What is held by who drives. Numbers: so many axes, -1 to 1.
JOSTLE_EXPORT(steer)
void jostle_predictor_steer(JostlePredictor*, uint32_t sequence, uint32_t tick, uint32_t axes,
                            uint32_t buttons);
// What became of one: it was applied (1) in that tick, or it was not (0).
JOSTLE_EXPORT(result)
void jostle_predictor_result(JostlePredictor*, uint32_t sequence, uint32_t tick, uint32_t applied);

// How bodies move in the next frame, if that was told. Numbers, for each in rising order of entity:
// entity, velocity of the centre of mass (3), spin (3), in the whole numbers of `jostle.motion`
// (proto/WIRE.md, "Channels").
JOSTLE_EXPORT(motions) uint32_t jostle_predictor_velocities(JostlePredictor*, uint32_t bodies);
// What the client drives, after a tick (proto/WIRE.md, "Driven things"); good until the next.
// Numbers: the letters of the module's tag, then the words. 1: they were taken.
JOSTLE_EXPORT(drive)
uint32_t jostle_predictor_control(JostlePredictor*, uint32_t entity, uint32_t tick,
                                  uint32_t letters, uint32_t words);
// A frame of the server. Numbers, for each of its bodies in rising order of entity: entity,
// position (3), rotation (4: x y z w), whether it rests (0 or 1). Bodies that were not added are
// left out.
JOSTLE_EXPORT(frame)
uint32_t jostle_predictor_frame(JostlePredictor*, uint32_t number, uint32_t bodies);

// Whose poses a picture takes from here: how many, and their entities as numbers.
JOSTLE_EXPORT(drawn) uint32_t jostle_predictor_predicted(JostlePredictor*);
// The picture of now, in us of the host's clock, at that place of the input clock, in ticks.
// Numbers, for each of drawn(): entity, position (3), rotation (4), as interpolated; who is nowhere
// is left out. They are replaced by what is to be drawn. Answers how many there are.
JOSTLE_EXPORT(sample)
uint32_t jostle_predictor_sample(JostlePredictor*, double position, double now_us, uint32_t bodies);

// 0 frames that were compared, 1 corrections among them, 2 steps that were taken, 3 greatest error
// of the last frame in m, 4 bodies that are foreseen, 5 bodies whose shapes could not be used, 6
// times that what is driven was compared, 7 corrections among them, 8 error of the last one in m.
JOSTLE_EXPORT(figure) double jostle_predictor_stat(const JostlePredictor*, uint32_t which);

#ifdef __cplusplus
}
#endif
