// Decodes and renders the golden channels of every module. The expected values are those of
// tests/modules/golden.

import { create } from '@bufbuild/protobuf';
import { describe, expect, it } from 'vitest';
import { EntitySchema, type Entity } from '@jostle/client/gen/play_pb';
import { broken, goldenModule, withValue } from '../testing/golden_modules';
import { testRenderContext } from '../testing/test_render_context';
import { heightAt } from '../scene/water';
import { boats, readBoat } from './boat';
import { characters, readCharacter } from './character';
import { destructibles, readDestructibles } from './destruction';
import { fields, waterSurface, readFields, readWaters, waves } from './fields';
import { bonesOf, ragdolls, readMode } from './ragdoll';
import { readCar, vehicles } from './vehicle';

const capsules = (ids: number[], name = ''): Map<number, Entity> =>
  new Map(
    ids.map((id) => {
      const shapes = [{ kind: { case: 'capsule' as const, value: { radius: 0.3, halfLength: 0.6 } } }];
      return [id, create(EntitySchema, { id, name, mass: 1, shapes })];
    }),
  );
const from = (first: number, count: number) => Array.from({ length: count }, (_, k) => first + k);

describe('golden channels', () => {
  it('of a boat: full throttle, rudder half expected, propeller under water', () => {
    const data = goldenModule('boat');
    expect(data.map(({ entity }) => entity)).toEqual([1]);
    const { values } = data[0]!;
    const boat = readBoat(values)!;
    expect(boat).toMatchObject({ throttle: 1, wet: true });
    expect(boat.rudder).toBeCloseTo(0.5, 2);
    boat.propeller.forEach((x, axis) => expect(x).toBeCloseTo([0, -0.4, 2.4][axis]!, 3));
    for (const part of broken(values)) expect(readBoat(part)).toBeUndefined();
    const context = testRenderContext();
    boats.draw!(data, context);
    expect(context.solids.countOf('box')).toBe(2);
    expect(context.solids.countOf('sphere')).toBeGreaterThan(3); // foam
    expect(boats.steering!.statusText!(data[0]!)).toBe('');
    const dry = withValue(values, 5, 0);
    expect(boats.steering!.statusText!({ ...data[0]!, values: dry })).toBe('propeller out of the water');
  });

  it('of characters: one walking expected, one crouching, one airborne', () => {
    const data = goldenModule('character');
    expect(data.map(({ entity }) => entity)).toEqual([2, 3, 4]);
    const [walks, crouches, jumps] = data.map(({ values }) => readCharacter(values));
    expect(walks).toMatchObject({ rigid: false, crouched: false, ground: 'on ground' });
    expect(walks!.heading).toBeCloseTo(-Math.PI / 2, 1);
    expect(walks!.speed).toBeCloseTo(3, 1);
    expect(crouches).toMatchObject({ rigid: true, crouched: true, ground: 'on ground' });
    expect(jumps).toMatchObject({ ground: 'airborne' });
    expect(jumps!.verticalSpeed).toBeCloseTo(5 - (9.81 * 20) / 60, 0);
    for (const part of broken(data[0]!.values)) expect(readCharacter(part)).toBeUndefined();
    const context = testRenderContext(undefined, capsules([2, 3, 4]));
    characters.draw!(data, context);
    expect(context.solids.countOf('sphere')).toBe(3 * 5); // face, hands, feet
    expect(characters.steering!.statusText!(data[1]!)).toBe('0.0 m/s · crouched');
  });

  it('of two walls: one intact, one with a broken middle', () => {
    const data = goldenModule('destruction');
    expect(data.map(({ entity }) => entity)).toEqual([0]);
    const { values } = data[0]!;
    const [intact, hit] = readDestructibles(values)!;
    expect(intact).toEqual({ pieces: 1, bonds: 69, initialBonds: 69 });
    expect(hit!.pieces).toBeGreaterThan(1);
    expect(hit!.bonds).toBeLessThan(69);
    // A prefix of whole walls is valid.
    for (const part of broken(values)) if (part.length % 3 !== 0) expect(readDestructibles(part)).toBeUndefined();
    expect(destructibles.statusText!(data)).toBe('2 walls in 4 pieces · 84 % of the bonds intact');
  });

  it('of water: waves advanced by half a second', () => {
    const data = goldenModule('fields', 0);
    expect(data.map(({ entity }) => entity)).toEqual([0]);
    const { values } = data[0]!;
    const [water, ...others] = readWaters(values)!;
    expect(others).toEqual([]);
    const [long, short] = water!.waves;
    expect(water).toMatchObject({ level: 0.5, density: 1000 });
    expect(long).toMatchObject({ amplitude: 0.25, length: 16 });
    expect(long!.heading).toBeCloseTo(0.4, 3);
    expect(short!.heading).toBeCloseTo(2 * Math.PI - 0.5, 3);
    const omega = Math.sqrt((9.81 * 2 * Math.PI) / 16);
    expect(long!.omega).toBeCloseTo(omega, 5);
    expect(long!.phase).toBeCloseTo(2 * Math.PI - (omega * 31) / 60, 3);
    for (const part of broken(values)) if (part.length > 0) expect(readWaters(part)).toBeUndefined();
    expect(readWaters(new Int32Array([...values, ...values, ...values, ...values]))).toHaveLength(4);
    expect(readWaters(new Int32Array([...values, ...values, ...values, ...values, ...values]))).toBeUndefined();
  });

  it('of water sent earlier are advanced to the current time', () => {
    const data = goldenModule('fields', 0).map((one) => ({ ...one, seconds: 0.75 }));
    const context = testRenderContext();
    waves.draw!(data, context);
    expect(context.water.surfaces).toHaveLength(1);
    // The height at a position, by the formula of waves.h with the scene's own time.
    const time = 31 / 60 + 0.75;
    const wave = (amplitude: number, length: number, heading: number, phase: number) => {
      const number = (2 * Math.PI) / length;
      const along = Math.cos(heading) * 3 + Math.sin(heading) * 4;
      return amplitude * Math.cos(number * along - Math.sqrt(9.81 * number) * time + phase);
    };
    const expected = 0.5 + wave(0.25, 16, 0.4, 0) + wave(0.125, 6, -0.5, 1);
    expect(heightAt(context.water.surfaces[0]!, 3, 4)).toBeCloseTo(expected, 3);
    expect(waterSurface(readWaters(data[0]!.values)![0]!, 0).waves).toHaveLength(2);
  });

  it('of force fields: wind, attraction and blast, with arrows and rings only in the debug view', () => {
    const data = goldenModule('fields', 1);
    const { values } = data[0]!;
    expect(readFields(values)).toEqual({
      others: [
        { kind: 'turbulence', wind: [2, 0, -1], speed: 1.5 },
        { kind: 'central', point: [1, 2, 3] },
      ],
      blasts: [{ point: [4, 5, 6], radius: 7 }],
    });
    const withoutBlast = values.length - 4;
    for (const part of broken(values)) if (part.length !== withoutBlast) expect(readFields(part)).toBeUndefined();
    const plain = testRenderContext();
    fields.draw!(data, plain);
    expect(plain.flashes).toEqual([[4, 5, 6, 7, 0]]);
    expect(plain.lines.count).toBe(0);
    const debug = testRenderContext(undefined, undefined, { debug: true });
    fields.draw!(data, debug);
    expect(debug.lines.count).toBe(81 * 6 + 3 * 32 * 2);
  });

  it('of ragdolls: one limp and one powered, eleven bones each, colored as people', () => {
    const data = goldenModule('ragdoll');
    expect(data.map(({ entity, values }) => [entity, readMode(values)])).toEqual([
      [2, 'limp'],
      [13, 'powered'],
    ]);
    for (const part of broken(data[0]!.values)) expect(readMode(part)).toBeUndefined();
    expect(readMode(new Int32Array([3]))).toBeUndefined();
    const entities = new Map([...capsules(from(2, 22)), ...capsules([24], 'walker')]);
    expect(bonesOf([2, 13], entities)).toEqual([from(2, 11), from(13, 11)]);
    const colors = ragdolls.bodyColors!(data, entities);
    expect(colors.size).toBe(22);
    expect(colors.get(3)).toBe(colors.get(5)); // chest and upper arm: the shirt
    expect(colors.get(4)).toBe(colors.get(7)); // head and lower arm: skin
    expect(colors.get(3)).not.toBe(colors.get(14)); // the other's shirt
    const context = testRenderContext(undefined, entities);
    ragdolls.draw!(data, context);
    expect(context.solids.countOf('sphere')).toBe(2 * 3); // eyes and hair
  });

  it('of a car: accelerating to the expected on four wheels', () => {
    const data = goldenModule('vehicle');
    expect(data.map(({ entity }) => entity)).toEqual([2]);
    const { values } = data[0]!;
    const car = readCar(values)!;
    expect(car.gear).toBe(1);
    expect(car.engine).toBeGreaterThan(0.13);
    expect(car.wheels).toHaveLength(4);
    const [left, right, rearLeft] = car.wheels;
    for (const wheel of car.wheels) {
      expect(wheel.radius).toBeCloseTo(0.33, 2);
      expect(wheel.width).toBeCloseTo(0.22, 2);
      expect(wheel.touches).toBe(true);
      expect(wheel.spin).toBeGreaterThan(5);
    }
    expect(left!.steering).toBeCloseTo(0.3, 3);
    expect(rearLeft!.steering).toBeCloseTo(0, 3);
    expect(left!.center[0]).toBeCloseTo(-0.8, 3);
    expect(right!.center[0]).toBeCloseTo(0.8, 3);
    // A prefix of whole wheels is valid.
    for (const part of broken(values)) if (part.length % 9 !== 2) expect(readCar(part)).toBeUndefined();
    const context = testRenderContext();
    vehicles.draw!(data, context);
    expect(context.solids.countOf('cylinder')).toBe(8);
    expect(vehicles.steering!.statusText!(data[0]!)).toMatch(/^\d+ km\/h · gear 1$/);
  });
});
