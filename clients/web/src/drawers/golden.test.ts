// The golden bytes of every module, read as their headers say and drawn. What they must mean is what tests/modules/golden made.

import { create } from '@bufbuild/protobuf';
import { describe, expect, it } from 'vitest';
import { EntitySchema, type Entity } from '../gen/jostle/v1/play_pb';
import { heightAt } from '../water';
import { boats, readBoats } from './boat';
import { characters, readCharacters } from './character';
import { destructibles, readWholes } from './destruction';
import { fields, lookOf, readFields } from './fields';
import { broken, golden } from './golden';
import { bonesOf, ragdolls, readFigures } from './ragdoll';
import { testDrawing } from './test_drawing';
import { readCars, vehicles } from './vehicle';

const capsules = (ids: number[], name = ''): Map<number, Entity> =>
  new Map(
    ids.map((id) => {
      const shapes = [{ kind: { case: 'capsule' as const, value: { radius: 0.3, halfLength: 0.6 } } }];
      return [id, create(EntitySchema, { id, name, mass: 1, shapes })];
    }),
  );
const from = (first: number, count: number) => Array.from({ length: count }, (_, k) => first + k);

describe('golden bytes', () => {
  it('of a boat: full ahead, the rudder half to the right, the screw in the water', () => {
    const [boat, ...others] = readBoats(golden('boat'))!;
    expect(others).toEqual([]);
    expect(boat).toMatchObject({ entity: 1, throttle: 1, wet: true });
    expect(boat!.rudder).toBeCloseTo(0.5, 2);
    boat!.screw.forEach((x, axis) => expect(x).toBeCloseTo([0, -0.4, 2.4][axis]!, 3));
    for (const bytes of broken(golden('boat'))) expect(readBoats(bytes)).toBeUndefined();
    const drawing = testDrawing();
    boats.draw!(golden('boat'), drawing);
    expect(drawing.solids.countOf('box')).toBe(2);
    expect(drawing.solids.countOf('sphere')).toBeGreaterThan(3); // foam
    expect(boats.steering!.entities(golden('boat'))).toEqual([1]);
  });

  it('of characters: one walks to the right, one crouches, one is in the air', () => {
    const bytes = golden('character');
    const [walks, crouches, jumps] = readCharacters(bytes)!;
    expect(walks).toMatchObject({ entity: 2, rigid: false, crouched: false, ground: 'on ground' });
    expect(walks!.heading).toBeCloseTo(-Math.PI / 2, 1);
    expect(walks!.speed).toBeCloseTo(3, 1);
    expect(crouches).toMatchObject({ entity: 3, rigid: true, crouched: true, ground: 'on ground' });
    expect(jumps).toMatchObject({ entity: 4, ground: 'in the air' });
    expect(jumps!.rising).toBeCloseTo(5 - (9.81 * 20) / 60, 0);
    // Three characters are also two and a part of one, or one.
    for (const part of broken(bytes)) if (part.length % 8 !== 0) expect(readCharacters(part)).toBeUndefined();
    const drawing = testDrawing(undefined, capsules([2, 3, 4]));
    characters.draw!(bytes, drawing);
    expect(drawing.solids.countOf('sphere')).toBe(3 * 5); // face, hands, feet
    expect(characters.steering!.words!(bytes, 3)).toBe('0.0 m/s · crouched');
  });

  it('of two walls: one whole, one that lost its middle', () => {
    const bytes = golden('destruction');
    const [whole, hit] = readWholes(bytes)!;
    expect(whole).toEqual({ pieces: 1, bonds: 69, bondsAtFirst: 69 });
    expect(hit!.pieces).toBeGreaterThan(1);
    expect(hit!.bonds).toBeLessThan(69);
    for (const part of broken(bytes)) expect(readWholes(part)).toBeUndefined();
    expect(destructibles.words!(bytes)).toBe('2 walls in 4 pieces · 84 % of the bonds hold');
  });

  it('of fields: waves that have run on for half a second, wind, an attraction and a blast', () => {
    const bytes = golden('fields');
    const { waters, others, blasts } = readFields(bytes)!;
    expect(waters).toHaveLength(1);
    const [long, short] = waters[0]!.waves;
    expect(waters[0]).toMatchObject({ level: 0.5, density: 1000 });
    expect(long).toMatchObject({ amplitude: 0.25, length: 16 });
    expect(long!.heading).toBeCloseTo(0.4, 3);
    expect(short!.heading).toBeCloseTo(2 * Math.PI - 0.5, 3);
    const omega = Math.sqrt((9.81 * 2 * Math.PI) / 16);
    expect(long!.omega).toBeCloseTo(omega, 5);
    expect(long!.phase).toBeCloseTo(2 * Math.PI - (omega * 31) / 60, 3);
    expect(others).toEqual([
      { kind: 'turbulence', wind: [2, 0, -1], speed: 1.5 },
      { kind: 'central', point: [1, 2, 3] },
    ]);
    expect(blasts).toEqual([{ point: [4, 5, 6], radius: 7 }]);
    for (const part of broken(bytes)) expect(readFields(part)).toBeUndefined();
  });

  it('of fields are drawn: water that runs on, a flash, and arrows and rings only in the debug view', () => {
    const plain = testDrawing(undefined, undefined, { seconds: 0.25 });
    fields.draw!(golden('fields'), plain);
    expect(plain.water.drawn).toHaveLength(1);
    expect(plain.flashes).toEqual([[4, 5, 6, 7, 0]]);
    expect(plain.lines.count).toBe(0);
    // The height over a place, by the formula of waves.h with the scene's own time.
    const time = 31 / 60 + 0.25;
    const wave = (amplitude: number, length: number, heading: number, phase: number) => {
      const number = (2 * Math.PI) / length;
      const along = Math.cos(heading) * 3 + Math.sin(heading) * 4;
      return amplitude * Math.cos(number * along - Math.sqrt(9.81 * number) * time + phase);
    };
    const right = 0.5 + wave(0.25, 16, 0.4, 0) + wave(0.125, 6, -0.5, 1);
    expect(heightAt(plain.water.drawn[0]!, 3, 4)).toBeCloseTo(right, 3);
    expect(lookOf(readFields(golden('fields'))!.waters[0]!, 0).waves).toHaveLength(2);
    const debug = testDrawing(undefined, undefined, { debug: true });
    fields.draw!(golden('fields'), debug);
    expect(debug.lines.count).toBe(81 * 6 + 3 * 32 * 2);
  });

  it('of figures: a limp and a powered one, eleven bones each, dressed as people', () => {
    const bytes = golden('ragdoll');
    const figures = readFigures(bytes)!;
    expect(figures).toEqual([
      { entity: 2, mode: 'limp' },
      { entity: 13, mode: 'powered' },
    ]);
    for (const part of broken(bytes)) if (part.length % 5 !== 0) expect(readFigures(part)).toBeUndefined();
    const entities = new Map([...capsules(from(2, 22)), ...capsules([24], 'walker')]);
    expect(bonesOf(figures, entities)).toEqual([from(2, 11), from(13, 11)]);
    const colors = ragdolls.dress!(bytes, entities);
    expect(colors.size).toBe(22);
    expect(colors.get(3)).toBe(colors.get(5)); // chest and upper arm: the shirt
    expect(colors.get(4)).toBe(colors.get(7)); // head and lower arm: skin
    expect(colors.get(3)).not.toBe(colors.get(14)); // the other's shirt
    const drawing = testDrawing(undefined, entities);
    ragdolls.draw!(bytes, drawing);
    expect(drawing.solids.countOf('sphere')).toBe(2 * 3); // eyes and hair
  });

  it('of a car: pulls away to the right on four wheels', () => {
    const bytes = golden('vehicle');
    const [car] = readCars(bytes)!;
    expect(car).toMatchObject({ entity: 2, gear: 1 });
    expect(car!.engine).toBeGreaterThan(0.13);
    expect(car!.wheels).toHaveLength(4);
    const [left, right, rearLeft] = car!.wheels;
    for (const wheel of car!.wheels) {
      expect(wheel.radius).toBeCloseTo(0.33, 2);
      expect(wheel.width).toBeCloseTo(0.22, 2);
      expect(wheel.touches).toBe(true);
      expect(wheel.spin).toBeGreaterThan(5);
    }
    expect(left!.steering).toBeCloseTo(0.3, 3);
    expect(rearLeft!.steering).toBeCloseTo(0, 3);
    expect(left!.center[0]).toBeCloseTo(-0.8, 3);
    expect(right!.center[0]).toBeCloseTo(0.8, 3);
    for (const part of broken(bytes)) expect(readCars(part)).toBeUndefined();
    const drawing = testDrawing();
    vehicles.draw!(bytes, drawing);
    expect(drawing.solids.countOf('cylinder')).toBe(8);
    expect(vehicles.steering!.words!(bytes, 2)).toMatch(/^\d+ km\/h · gear 1$/);
  });
});
