// Obstacles, the path flown, and aids to see depth and direction.
import * as THREE from "three";
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { unpacked } from "./flight.js";
import { ArmPath } from "./joints.js";
import { toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";

/** Faces that meet at less than this are shaded as one [rad]; edges sharper than this are drawn [deg]. */
const SMOOTH = 0.6;
const EDGE = 25;
/** Depth by which what stands on a plane may reach below it and cast its shadow there [m]. */
const UNDER = 0.02;
/** Most lines of a grid in one direction: beyond them it has wider meshes. */
const MOST_LINES = 200;
/** Radius of the rod of a hanging obstacle [m]. */
const ROD = 0.004;

const vector = (v) => new THREE.Vector3(...v);

/** Lines of a grid on a rectangle, with a given spacing [m] or, of a long one, some times that, from its centre. */
function grid(centre, across, along, least, colour, opacity) {
  const places = [];
  const a = across.length();
  const b = along.length();
  let step = least;
  while (2 * Math.max(a, b) > MOST_LINES * step) step *= 2;
  const u = across.clone().normalize();
  const v = along.clone().normalize();
  const line = (from, to) => places.push(...from.toArray(), ...to.toArray());
  const at = (x, y) => centre.clone().addScaledVector(u, x).addScaledVector(v, y);
  const stops = (half) => {
    const found = [-half, half];
    for (let x = Math.ceil(-half / step) * step; x < half; x += step) found.push(x);
    return found;
  };
  for (const x of stops(a)) line(at(x, -b), at(x, b));
  for (const y of stops(b)) line(at(-a, y), at(a, y));
  const shape = new THREE.BufferGeometry();
  shape.setAttribute("position", new THREE.Float32BufferAttribute(places, 3));
  return new THREE.LineSegments(shape, new THREE.LineBasicMaterial({ color: colour, transparent: true, opacity, depthWrite: false }));
}

/** A box from a face inwards. */
function slab(thing, depth, colour, opacity, from = 0) {
  const across = vector(thing.across);
  const along = vector(thing.along);
  const normal = vector(thing.normal);
  const shape = new THREE.BoxGeometry(2 * across.length(), 2 * along.length(), depth);
  const paint = new THREE.MeshStandardMaterial({
    color: colour, transparent: true, opacity, roughness: 0.9, depthWrite: false, side: THREE.DoubleSide,
  });
  const mesh = new THREE.Mesh(shape, paint);
  const axes = new THREE.Matrix4().makeBasis(across.normalize(), along.normalize(), normal);
  mesh.quaternion.setFromRotationMatrix(axes);
  mesh.position.copy(vector(thing.centre)).addScaledVector(normal, -from - 0.5 * depth);
  mesh.renderOrder = 1;
  return mesh;
}

/** A shape of the user's own: a piece of its surface, of which each pixel shows the nearest part alone. */
function surface(thing, colour) {
  const shape = new THREE.BufferGeometry();
  shape.setAttribute("position", new THREE.BufferAttribute(unpacked(thing.vertices), 3));
  shape.setAttribute("normal", new THREE.BufferAttribute(unpacked(thing.normals), 3));
  shape.setIndex(Array.from(unpacked(thing.triangles)));
  const depths = new THREE.Mesh(shape, new THREE.MeshBasicMaterial({ colorWrite: false, transparent: true, side: THREE.DoubleSide }));
  const faces = new THREE.Mesh(shape, new THREE.MeshStandardMaterial({
    color: colour, transparent: true, opacity: 0.55, roughness: 0.85, depthWrite: false, side: THREE.DoubleSide,
  }));
  [depths, faces].forEach((one, k) => (one.renderOrder = 3 + k));
  return new THREE.Group().add(depths, faces);
}

/**
 * Closed bodies with sharp edges: of each pixel only the nearest face is drawn, so that they are
 * evenly translucent, and nothing below the ground.
 */
function body(thing, colours, colour, floor) {
  const welded = weldedBody(thing);
  const shape = toCreasedNormals(welded, SMOOTH);
  const clippingPlanes = floor === null ? [] : [new THREE.Plane(new THREE.Vector3(0, 0, 1), -floor)];
  const depths = new THREE.Mesh(shape, new THREE.MeshBasicMaterial({ colorWrite: false, transparent: true, clippingPlanes }));
  const faces = new THREE.Mesh(shape, new THREE.MeshStandardMaterial({
    color: colour, transparent: true, opacity: 0.72, roughness: 0.85, depthWrite: false, clippingPlanes,
    stencilWrite: true, stencilRef: 1, stencilFunc: THREE.NotEqualStencilFunc, stencilZPass: THREE.ReplaceStencilOp,
  })); // by the stencil each pixel once, where faces of two bodies coincide, too
  const edges = new THREE.LineSegments(new THREE.EdgesGeometry(welded, EDGE), new THREE.LineBasicMaterial({
    color: colours.ink, transparent: true, opacity: 0.35, depthWrite: false, clippingPlanes,
  }));
  welded.dispose();
  [depths, faces, edges].forEach((one, k) => (one.renderOrder = 3 + k));
  return new THREE.Group().add(depths, faces, edges);
}

function weldedBody(thing) {
  const welded = new THREE.BufferGeometry();
  welded.setAttribute("position", new THREE.BufferAttribute(unpacked(thing.vertices), 3));
  welded.setIndex(Array.from(unpacked(thing.triangles)));
  return welded;
}

/** Name of what an obstacle is drawn as, its own or its type: one line of the legend. */
export const kindOf = (thing) => `${thing.name || thing.kind}${thing.kind !== "mesh" || thing.track < 0 ? "" : ", moving"}`;

/** What has one colour: faces of a kind, and what goes by one name. */
const shadeKey = (thing) => (thing.kind === "mesh" ? kindOf(thing) : thing.kind);

/** Quiet colours of obstacles by name: mat and ground have their own, the first other one that of a wall. */
export function shadesOf(things, colours) {
  const keys = [...new Set(things.map(shadeKey))];
  const others = keys.filter((key) => key !== "mat" && key !== "ground");
  others.sort((a, b) => (b === "wall") - (a === "wall"));
  const shade = (key) => (others.includes(key) ? colours.shapes[others.indexOf(key) % colours.shapes.length] : colours[key]);
  return new Map(things.map((thing) => [kindOf(thing), shade(shadeKey(thing))]));
}

/**
 * Vertical shadow of a closed body on a horizontal plane; null of what reaches below it.
 *
 * Each pixel is darkened once, as by the stencil.  What it holds is drawn as the body is, flat.
 */
function shadowOf(thing, level, floor) {
  if (thing.kind !== "mesh" || thing.normals) return null;
  const welded = weldedBody(thing);
  welded.computeBoundingBox();
  if (welded.boundingBox.min.z < level - UNDER && (floor === null || welded.boundingBox.max.z <= level)) return null;
  const paint = new THREE.MeshBasicMaterial({
    color: "#000000", transparent: true, opacity: 0.14, depthWrite: false, side: THREE.DoubleSide,
    stencilWrite: true, stencilRef: 2, stencilFunc: THREE.NotEqualStencilFunc, stencilZPass: THREE.ReplaceStencilOp,
  });
  const mesh = new THREE.Mesh(welded, paint);
  mesh.renderOrder = 2;
  mesh.frustumCulled = false; // its bounds are those of the body
  return mesh;
}

/** A group that flattens a shadow onto its plane. */
function flattened(level, shadow) {
  const group = new THREE.Group().add(shadow);
  group.scale.z = 0;
  group.position.z = level + 0.002;
  return group;
}

/** Shadow of an obstacle at rest, where it stands; null if it has none. */
export function restingShadow(thing, level, floor) {
  const shadow = shadowOf(thing, level, floor);
  return shadow && flattened(level, shadow);
}

/** An obstacle of a colour; bodies end at the height of the ground, if there is any. */
export function obstacle(thing, colours, shades, floor = null) {
  const group = new THREE.Group();
  const shade = shades.get(kindOf(thing)) ?? colours.wall;
  if (thing.kind === "mesh") return thing.normals ? group.add(surface(thing, shade)) : body(thing, colours, shade, floor);
  const centre = vector(thing.centre);
  const lift = vector(thing.normal).multiplyScalar(0.001);
  const lines = (opacity, colour, step) =>
    grid(centre.clone().add(lift), vector(thing.across), vector(thing.along), step, colour, opacity);
  if (thing.kind === "ground") {
    group.add(slab(thing, 0.004, colours.ground, 0.35), lines(0.55, colours.faint, 0.25));
  } else if (thing.kind === "mat") {
    group.add(slab(thing, thing.thickness, colours.mat, 0.2), lines(0.55, colours.mat, 0.1));
    group.add(slab(thing, 0.04, colours.wall, 0.25, thing.thickness));
  } else {
    group.add(slab(thing, 0.04, shade, 0.22), lines(0.5, shade, 0.1));
  }
  return group;
}

/** An obstacle that moves, with the rod on which it hangs. */
export class Mover {
  /**
   * @param track of the flight's scene
   * @param things what is drawn of it, where it was placed
   * @param level height of the plane of shadows
   */
  constructor(track, things, colours, shades, floor, level) {
    this.origin = vector(track.origin);
    this.body = new THREE.Group().add(...things.map((thing) => obstacle(thing, colours, shades, floor)));
    const shadows = things.map((thing) => shadowOf(thing, level, floor)).filter(Boolean);
    this.shadow = new THREE.Group();
    if (shadows.length) this.shadow.add(...shadows);
    this.group = new THREE.Group().add(this.body, flattened(level, this.shadow));
    this.turn = new THREE.Quaternion();
    this.rod = null;
    if (!track.rod.length) return;
    this.pivot = vector(track.rod);
    const shape = new THREE.CylinderGeometry(ROD, ROD, 1, 10).translate(0, 0.5, 0);
    this.rod = new THREE.Mesh(shape, new THREE.MeshStandardMaterial({ color: colours.metal, roughness: 0.6 }));
    this.rod.position.copy(this.pivot);
    this.group.add(this.rod);
  }

  /** Show a pose {position, quaternion} of flight.js. */
  show(pose) {
    const [w, x, y, z] = pose.quaternion;
    this.turn.set(x, y, z, w);
    this.body.quaternion.copy(this.turn);
    this.body.position.copy(this.origin).negate().applyQuaternion(this.turn).add(vector(pose.position));
    this.shadow.quaternion.copy(this.body.quaternion);
    this.shadow.position.copy(this.body.position);
    if (!this.rod) return;
    const along = vector(pose.position).sub(this.pivot);
    this.rod.scale.y = along.length();
    this.rod.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), along.normalize());
  }
}

/** A faint horizontal grid under flights without ground, for depth only. */
export function reference(box, colours) {
  const size = box.getSize(new THREE.Vector3());
  const middle = box.getCenter(new THREE.Vector3());
  middle.z = box.min.z;
  const half = (x) => Math.max(0.8, Math.ceil((0.5 * x + 0.4) * 4) / 4);
  return grid(middle, new THREE.Vector3(half(size.x), 0, 0), new THREE.Vector3(0, half(size.y), 0), 0.25, colours.faint, 0.35);
}

/** The rail of a slider, through the main body. */
export function rail(flight, colours) {
  const axis = vector(flight.guide).normalize();
  const along = [];
  for (let i = 0; i < flight.n; i += Math.max(1, Math.floor(flight.n / 200))) {
    along.push(axis.dot(vector(flight.position.subarray(3 * i, 3 * i + 3))));
  }
  const from = Math.min(...along) - 0.5;
  const length = Math.max(...along) + 0.5 - from;
  const shape = new THREE.CylinderGeometry(0.008, 0.008, length, 12).rotateZ(-Math.PI / 2).translate(length / 2, 0, 0);
  const mesh = new THREE.Mesh(shape, new THREE.MeshStandardMaterial({ color: colours.metal, transparent: true, opacity: 0.5 }));
  mesh.quaternion.setFromUnitVectors(new THREE.Vector3(1, 0, 0), axis);
  const start = vector(flight.position.subarray(0, 3));
  mesh.position.copy(start).addScaledVector(axis, from - axis.dot(start));
  return mesh;
}

/** The path of a flight: grey before the first touch, coloured as forces in contact, its own colour after. */
export class Path {
  constructor(flight, colours, resolution) {
    const touches = flight.impacts;
    const first = touches.length ? touches[0][0] : Infinity;
    const places = [];
    const paints = [];
    const before = new THREE.Color(colours.before);
    const during = new THREE.Color(colours.force);
    const after = new THREE.Color(flight.colour);
    this.times = [];
    let last = -Infinity;
    for (let i = 0; i < flight.n; i++) {
      const t = flight.t[i];
      if (t - last < 1e-3 && i < flight.n - 1) continue; // 1 ms is a few mm of path
      last = t;
      this.times.push(t);
      places.push(...flight.position.subarray(3 * i, 3 * i + 3));
      const inside = touches.some(([begin, end]) => t >= begin && t <= end);
      paints.push(...(inside ? during : t < first ? before : after).toArray());
    }
    const make = (opacity, width) => {
      const shape = new LineGeometry();
      shape.setPositions(places);
      shape.setColors(paints);
      const paint = new LineMaterial({ vertexColors: true, linewidth: width, transparent: true, opacity, depthWrite: false });
      paint.resolution.copy(resolution);
      const line = new Line2(shape, paint);
      line.computeLineDistances();
      return line;
    };
    this.whole = make(0.3, 1.2);
    this.flown = make(1, 2.6);
    this.group = new THREE.Group();
    this.group.add(this.whole, this.flown);
  }

  /** Draw the path up to an instant thick. */
  show(time) {
    let count = 0;
    let high = this.times.length;
    while (count < high) {
      const middle = (count + high) >> 1;
      if (this.times[middle] <= time) count = middle + 1;
      else high = middle;
    }
    this.flown.geometry.instanceCount = Math.max(count - 1, 0);
  }

  resize(resolution) {
    this.whole.material.resolution.copy(resolution);
    this.flown.material.resolution.copy(resolution);
  }
}

/** Vertical shadow on a horizontal plane: cages and body as discs, and a plumb line. */
export class Shadow {
  constructor(flight, level, colours) {
    this.level = level;
    this.group = new THREE.Group();
    this.paths = flight.arms.map((arm) => new ArmPath(arm));
    const paint = () => new THREE.MeshBasicMaterial({ color: "#000000", transparent: true, opacity: 0.16, depthWrite: false });
    const disc = (radius) => {
      const mesh = new THREE.Mesh(new THREE.CircleGeometry(radius, 36), paint());
      mesh.renderOrder = 2;
      this.group.add(mesh);
      return mesh;
    };
    this.body = disc(0.045);
    this.cages = flight.arms.map((arm) => disc(arm.cage_radius));
    const shape = new THREE.BufferGeometry();
    shape.setAttribute("position", new THREE.Float32BufferAttribute([0, 0, 0, 0, 0, 1], 3));
    this.plumb = new THREE.Line(shape, new THREE.LineBasicMaterial({ color: colours.faint, transparent: true, opacity: 0.6 }));
    this.group.add(this.plumb);
    this.turn = new THREE.Quaternion();
    this.at = new THREE.Vector3();
  }

  show(pose) {
    const [w, x, y, z] = pose.quaternion;
    this.turn.set(x, y, z, w);
    const level = this.level + 0.003;
    this.body.position.set(pose.position[0], pose.position[1], level);
    this.cages.forEach((cage, j) => {
      this.paths[j].at(pose.armLengths[j], this.at, null, pose.bends[j]);
      this.at.applyQuaternion(this.turn);
      cage.position.set(pose.position[0] + this.at.x, pose.position[1] + this.at.y, level);
    });
    this.plumb.position.set(pose.position[0], pose.position[1], level);
    this.plumb.scale.z = Math.max(pose.position[2] - level, 1e-4);
  }
}

/** A letter that faces the camera. */
function letter(text, colour) {
  const canvas = document.createElement("canvas");
  canvas.width = 128;
  canvas.height = 64;
  const pen = canvas.getContext("2d");
  pen.font = "600 40px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillStyle = colour;
  pen.fillText(text, 64, 32);
  const map = new THREE.CanvasTexture(canvas);
  map.colorSpace = THREE.SRGBColorSpace;
  const sprite = new THREE.Sprite(new THREE.SpriteMaterial({ map, depthTest: false, transparent: true }));
  sprite.scale.set(0.9, 0.45, 1);
  return sprite;
}

/** World axes for a corner of the view: x north, y west, z up. */
export function compass(colours) {
  const group = new THREE.Group();
  const axes = { "x N": [1, 0, 0], "y W": [0, 1, 0], "z up": [0, 0, 1] };
  Object.entries(axes).forEach(([name, axis]) => {
    const arrow = new THREE.ArrowHelper(vector(axis), new THREE.Vector3(), 1, colours.ink, 0.28, 0.16);
    const sign = letter(name, colours.ink);
    sign.position.set(...axis).multiplyScalar(1.38);
    group.add(arrow, sign);
  });
  return group;
}

const sum = (a, b) => a.map((x, k) => x + b[k]);

/** An obstacle, shifted. */
export const moved = (one, by) => (one.kind === "mesh" ? { ...one, moved: by } : { ...one, centre: sum(one.centre, by) });

const dot = (a, b) => a.reduce((total, x, k) => total + x * b[k], 0);

/** Merge rectangles in one plane, so that they have no seam and do not flicker. */
export function joined(things) {
  const found = new Map();
  for (const one of things) {
    const flat = one.kind !== "mesh";
    const name = flat
      ? [one.kind, one.thickness, ...one.normal, dot(one.normal, one.centre)].map((x) => (x.toFixed ? x.toFixed(4) : x)).join()
      : `${one.name} ${one.key} ${one.moved}`;
    const other = found.get(name);
    found.set(name, !other ? one : flat ? union(other, one) : larger(other, one));
  }
  return [...found.values()];
}

/** Of two pieces of the same obstacles, cut off elsewhere, the one with more in it. */
function larger(a, b) {
  const [one, other] = [a, b].map((thing) => {
    const box = new THREE.Box3().setFromArray(unpacked(thing.vertices));
    return thing.triangles.shape[0] + 0.01 * box.getSize(new THREE.Vector3()).length();
  });
  return other > one ? b : a;
}

function union(a, b) {
  const result = { ...a, centre: a.centre.slice() };
  for (const axis of ["across", "along"]) {
    const half = Math.hypot(...a[axis]);
    const unit = a[axis].map((x) => x / half);
    const reach = Math.abs(dot(unit, b.across)) + Math.abs(dot(unit, b.along));
    const off = dot(unit, b.centre) - dot(unit, a.centre);
    const low = Math.min(-half, off - reach);
    const high = Math.max(half, off + reach);
    result[axis] = unit.map((x) => (x * (high - low)) / 2);
    result.centre = result.centre.map((x, k) => x + (unit[k] * (low + high)) / 2);
  }
  return result;
}
