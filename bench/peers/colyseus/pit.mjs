// The scene of balls.json in Rapier: the bodies that this benchmark needs, not every field of a scene file.
import { readFileSync } from 'node:fs';
import RAPIER from '@dimforge/rapier3d-compat';

const DENSITY = 1000; // kg/m^3, the default of a scene file

const vector = (v = {}) => ({ x: v.x ?? 0, y: v.y ?? 0, z: v.z ?? 0 });

// Each body at the places of its `repeat` entries, which multiply.
function* places(body) {
  let all = [vector(body.position)];
  for (const { count, offset } of body.repeat ?? [])
    all = all.flatMap((p) =>
      Array.from({ length: count }, (_, k) => ({
        x: p.x + k * (offset.x ?? 0),
        y: p.y + k * (offset.y ?? 0),
        z: p.z + k * (offset.z ?? 0),
      })),
    );
  yield* all;
}

function colliderOf(shape) {
  const { box, sphere, position, friction } = shape;
  const half = vector(box?.half_extents);
  const collider = sphere
    ? RAPIER.ColliderDesc.ball(sphere.radius)
    : RAPIER.ColliderDesc.cuboid(half.x, half.y, half.z);
  const at = vector(position);
  return collider.setTranslation(at.x, at.y, at.z).setFriction(friction).setDensity(DENSITY);
}

const KINDS = {
  BODY_TYPE_STATIC: () => RAPIER.RigidBodyDesc.fixed(),
  BODY_TYPE_KINEMATIC: () => RAPIER.RigidBodyDesc.kinematicVelocityBased(),
  BODY_TYPE_DYNAMIC: () => RAPIER.RigidBodyDesc.dynamic(),
};

// The Rapier world of a scene file, and the bodies that clients see: all that are not static.
export async function buildWorld(path) {
  await RAPIER.init();
  const scene = JSON.parse(readFileSync(path, 'utf8'));
  const world = new RAPIER.World(vector(scene.world.gravity));
  world.timestep = 1 / scene.world.hz;
  const moving = [];
  for (const body of scene.bodies)
    for (const at of places(body)) {
      const type = body.type ?? 'BODY_TYPE_DYNAMIC';
      const made = world.createRigidBody(KINDS[type]().setTranslation(at.x, at.y, at.z));
      made.setAngvel(vector(body.angular_velocity), true);
      for (const shape of body.shapes) world.createCollider(colliderOf(shape), made);
      if (type !== 'BODY_TYPE_STATIC') moving.push(made);
    }
  return { world, moving, hz: scene.world.hz };
}
