// Model of a robot: main body, arms on slides with springs that compress, or on hinges, and cages.
import * as THREE from "three";
import { unpacked } from "./flight.js";
import { ArmPath } from "./joints.js";

const TURNS = 7;
const WIRE = 0.0022;
const AHEAD = new THREE.Vector3(1, 0, 0);

/** A helix of length 1 along x, to be scaled. */
function helix(radius, turns = TURNS, wire = WIRE) {
  class Helix extends THREE.Curve {
    getPoint(u, target = new THREE.Vector3()) {
      const angle = 2 * Math.PI * turns * u;
      return target.set(u, radius * Math.cos(angle), radius * Math.sin(angle));
    }
  }
  return new THREE.TubeGeometry(new Helix(), turns * 14, wire, 5);
}

/** A cylinder of length 1 along x, from 0 to 1. */
function rod(radius, sides = 14) {
  const shape = new THREE.CylinderGeometry(radius, radius, 1, sides);
  return shape.rotateZ(-Math.PI / 2).translate(0.5, 0, 0);
}

/** A seat of a spring along x. */
function ring(unit, paint) {
  return new THREE.Mesh(new THREE.CylinderGeometry(0.0155 * unit, 0.0155 * unit, 0.006 * unit, 20).rotateZ(Math.PI / 2), paint);
}

/** Lay an object that extends along x from one point towards another. */
function laid(object, from, to) {
  const way = to.clone().sub(from);
  object.position.copy(from);
  object.quaternion.setFromUnitVectors(new THREE.Vector3(1, 0, 0), way.normalize());
  return object;
}

/** A hull of which the triangles are given. */
function solid(mesh, paint) {
  const shape = new THREE.BufferGeometry();
  shape.setAttribute("position", new THREE.BufferAttribute(unpacked(mesh.vertices), 3));
  shape.setIndex(new THREE.BufferAttribute(new Uint32Array(unpacked(mesh.triangles)), 1));
  const flat = shape.toNonIndexed();
  flat.computeVertexNormals();
  return new THREE.Mesh(flat, paint);
}

/** An arrow whose head keeps its size when scaled: shaft and head are separate. */
export class Arrow {
  constructor(colour, radius, opacity) {
    this.group = new THREE.Group();
    const paint = new THREE.MeshBasicMaterial({ color: colour, depthTest: false, transparent: true, opacity });
    this.shaft = new THREE.Mesh(rod(radius, 10), paint);
    this.head = new THREE.Mesh(new THREE.ConeGeometry(3 * radius, 8 * radius, 14).rotateZ(-Math.PI / 2), paint);
    this.size = 8 * radius;
    this.shaft.renderOrder = this.head.renderOrder = 10;
    this.group.add(this.shaft, this.head);
    this.along = new THREE.Vector3(1, 0, 0);
    this.way = new THREE.Vector3();
  }

  /** Place it at a point along a vector. */
  show(from, vector) {
    const length = this.way.set(...vector).length();
    this.group.visible = length > 1e-4;
    if (!this.group.visible) return;
    this.group.position.set(...from);
    this.group.quaternion.setFromUnitVectors(this.along, this.way.divideScalar(length));
    const head = Math.min(this.size, 0.6 * length);
    this.head.scale.setScalar(head / this.size);
    this.head.position.x = length - 0.5 * head;
    this.shaft.scale.x = Math.max(length - head, 1e-5);
  }

  hide() {
    this.group.visible = false;
  }
}

export class Robot {
  /**
   * @param flight of flight.js
   * @param look {colour, opacity} and the palette
   */
  constructor(flight, look, colours) {
    this.flight = flight;
    this.group = new THREE.Group();
    const faded = look.opacity < 1;
    const paint = (colour, more = {}) =>
      new THREE.MeshStandardMaterial({
        color: colour, roughness: 0.55, metalness: 0.15, transparent: faded, opacity: look.opacity,
        depthWrite: !faded, ...more,
      });
    const metal = paint(colours.metal);
    const dark = paint(colours.dark);
    const own = paint(look.colour);
    const spring = paint(colours.force, { metalness: 0.4, roughness: 0.35 });
    const span = Math.max(...flight.arms.map((arm) => arm.length));
    const unit = span / 0.19; // scale of all thicknesses, 1 for the paper's robots

    const hub = new THREE.Mesh(new THREE.CylinderGeometry(0.042 * unit, 0.042 * unit, 0.026 * unit, 28), dark);
    hub.rotation.x = Math.PI / 2;
    const lid = new THREE.Mesh(new THREE.CylinderGeometry(0.032 * unit, 0.04 * unit, 0.014 * unit, 28), own);
    lid.rotation.x = Math.PI / 2;
    lid.position.z = 0.02 * unit;
    const nose = new THREE.Mesh(new THREE.ConeGeometry(0.012 * unit, 0.034 * unit, 16).rotateZ(-Math.PI / 2), own);
    nose.position.set(0.056 * unit, 0, 0.004 * unit);
    this.group.add(hub, lid, nose);

    this.hulls = flight.hull.map((hull) => {
      const glass = paint(look.colour, { transparent: true, opacity: 0.22 * look.opacity, depthWrite: false });
      if (hull.meshes.length) {
        for (const one of hull.meshes) this.group.add(solid(one, glass));
        return glass;
      }
      const sphere = new THREE.Mesh(new THREE.SphereGeometry(hull.radius, 32, 20), glass);
      sphere.position.set(...hull.centre);
      this.group.add(sphere);
      return glass;
    });
    this.arms = flight.arms.map((arm) => this.#arm(arm, { metal, dark, own, spring, paint, colours, unit, faded, look }));
    this.springs = flight.neighbours.map(({ first, second }) => {
      const coil = new THREE.Mesh(helix(0.0075 * unit, 16, 0.0014 * unit), spring);
      this.group.add(coil);
      return { coil, first, second, from: new THREE.Vector3(), to: new THREE.Vector3(), way: new THREE.Vector3() };
    });
    this.open = new THREE.Color(colours.force);
    this.shut = new THREE.Color(colours.dark);
    this.rotors = flight.rotors.map((rotor) => this.#rotor(rotor, { dark, paint, colours, unit, look }));
    this.most = flight.max_thrust || 1;
    this.bar = 1.2 * span;
  }

  #arm(arm, { metal, dark, own, spring, paint, colours, unit, faded, look }) {
    const frame = new THREE.Group();
    this.group.add(frame);
    const azimuth = Math.atan2(arm.direction[1], arm.direction[0]);
    const end = new THREE.Group(); // moves with the end of the arm
    frame.add(end);
    const path = new ArmPath(arm);
    const parts = { end, frame, free: arm.length, path, hung: arm.joint.length > 0 };
    const tip = new THREE.Group(); // at the end, turned as the arm points
    const tools = { frame, end, metal, dark, own, spring, unit };
    if (parts.hung) {
      tip.rotation.z = azimuth;
      if (!arm.compliant) this.#strut(path.start, 0.007, tools);
      else if (path.second) parts.middle = this.#onTwo(path, tools);
      else if (path.isHinge) this.#hinge(path, tools);
      else Object.assign(parts, this.#slide(arm, path, tools));
      parts.latches = arm.latch.map((latch) => this.#latch(latch, path, { ...tools, middle: parts.middle, paint, colours }));
    } else {
      frame.rotation.z = azimuth;
      Object.assign(parts, this.#planar(arm, tools));
    }
    end.add(tip);
    const cagePaint = paint(look.colour, { roughness: 0.4 });
    const cage = new THREE.Mesh(new THREE.TorusGeometry(arm.cage_radius - 0.0035 * unit, 0.0035 * unit, 10, 72), cagePaint);
    if (arm.caged) tip.add(cage);
    const glass = paint(look.colour, { transparent: true, opacity: 0.22 * look.opacity, depthWrite: false });
    const hulls = new THREE.Group(); // in body axes, from the end of the arm
    hulls.rotation.z = -azimuth;
    for (const one of arm.hulls) hulls.add(solid(one, glass));
    tip.add(hulls);
    for (let k = 0; k < (arm.caged ? 3 : 0); k++) {
      const strut = new THREE.Mesh(rod(0.0016 * unit, 6), metal);
      strut.rotation.z = (2 * Math.PI * (k + 0.5)) / 3;
      strut.scale.x = arm.cage_radius - 0.004 * unit;
      tip.add(strut);
    }
    return Object.assign(parts, { cagePaint, tip, seat: hulls });
  }

  /** A rotor on the main body or at the end of an arm, with the bar of its thrust. */
  #rotor({ arm, offset, axis, level, spin, radius }, { dark, paint, colours, unit, look }) {
    const rotor = new THREE.Group();
    rotor.position.set(...offset);
    const aim = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 0, 1), new THREE.Vector3(...axis));
    rotor.quaternion.copy(aim);
    (arm < 0 ? this.group : this.arms[arm].seat).add(rotor);
    const motor = new THREE.Mesh(new THREE.CylinderGeometry(0.013 * unit, 0.013 * unit, 0.024 * unit, 18).rotateX(Math.PI / 2), dark);
    motor.position.z = 0.008 * unit;
    const disc = new THREE.Mesh(
      new THREE.CircleGeometry(radius, 36),
      paint(colours.thrust, { transparent: true, opacity: 0.16 * look.opacity, side: THREE.DoubleSide, depthWrite: false }),
    );
    disc.position.z = 0.022 * unit;
    const blades = new THREE.Mesh(new THREE.BoxGeometry(2 * radius, 0.012 * unit, 0.0015), dark);
    blades.position.z = 0.023 * unit;
    const thrust = new THREE.Mesh(
      new THREE.CylinderGeometry(0.006 * unit, 0.006 * unit, 1, 12).rotateX(Math.PI / 2).translate(0, 0, 0.5),
      paint(colours.thrust, { transparent: true, opacity: 0.8 * look.opacity, emissive: colours.thrust, emissiveIntensity: 0.3 }),
    );
    thrust.position.z = 0.024 * unit;
    rotor.add(motor, disc, blades, thrust);
    return { rotor, blades, thrust, spin, aim, level: level ? this.arms[arm] : null };
  }

  /** An arm in the body plane: its frame points along it. */
  #planar(arm, { frame, end, metal, dark, own, spring, unit }) {
    const stroke = arm.length - arm.shortest;
    const collar = 0.13 * arm.length; // distance of the spring's outer seat from the end of the arm
    if (!arm.compliant) {
      const tube = new THREE.Mesh(rod(0.007 * unit), metal);
      tube.scale.x = arm.length;
      frame.add(tube);
      return {};
    }
    const seat = Math.max(0.24 * arm.length, arm.shortest - collar - 0.8 * stroke);
    const tube = new THREE.Mesh(rod(0.0075 * unit), metal);
    tube.scale.x = arm.shortest - 0.5 * collar;
    const slide = new THREE.Mesh(rod(0.0045 * unit), own);
    slide.position.x = -(arm.length - seat) + 0.3 * collar;
    slide.scale.x = -slide.position.x;
    const fixed = ring(unit, dark);
    fixed.position.x = seat;
    const moving = ring(unit, dark);
    moving.position.x = -collar;
    const coil = new THREE.Mesh(helix(0.0125 * unit), spring);
    coil.position.x = seat;
    frame.add(tube, fixed, coil);
    end.add(slide, moving);
    return { coil, seat, collar };
  }

  /** A straight part of the main body, from its centre. */
  #strut(to, radius, { frame, metal, unit }) {
    const tube = new THREE.Mesh(rod(radius * unit), metal);
    tube.scale.x = Math.max(to.length(), 1e-6);
    frame.add(laid(tube, new THREE.Vector3(), to));
  }

  /** A slide that points anywhere: a strut to the seat of its spring, and the spring along the slide. */
  #slide(arm, path, { frame, end, metal, dark, own, spring, unit }) {
    const collar = 0.13 * path.start.length();
    const behind = path.start.distanceTo(path.anchor);
    const stroke = arm.length - arm.shortest;
    const way = laid(new THREE.Group(), path.anchor, path.start); // x is the distance from the seat
    const tube = new THREE.Mesh(rod(0.0075 * unit), metal);
    tube.scale.x = Math.max(behind - stroke - 0.5 * collar, 1e-6);
    const coil = new THREE.Mesh(helix(0.0125 * unit), spring);
    way.add(tube, ring(unit, dark), coil);
    const carried = new THREE.Group(); // with its end, as the slide points
    carried.quaternion.copy(way.quaternion);
    const slide = new THREE.Mesh(rod(0.0045 * unit), own);
    slide.position.x = -behind + 0.3 * collar;
    slide.scale.x = -slide.position.x;
    const moving = ring(unit, dark);
    moving.position.x = -collar;
    carried.add(slide, moving);
    frame.add(way);
    end.add(carried);
    this.#strut(path.anchor, 0.0075, { frame, metal, unit });
    return { coil, seat: arm.length - behind, collar };
  }

  /** A hinge: a strut to its pin, and the arm beyond it, which turns about the pin. */
  #hinge(path, { frame, end, metal, dark, own, unit }) {
    this.#strut(path.anchor, 0.0075, { frame, metal, unit });
    const pin = new THREE.Mesh(new THREE.CylinderGeometry(0.0105 * unit, 0.0105 * unit, 0.028 * unit, 20), dark);
    pin.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), path.axis.clone().normalize());
    pin.position.copy(path.anchor);
    frame.add(pin);
    const arm = new THREE.Mesh(rod(0.006 * unit), own);
    const back = path.anchor.clone().sub(path.start);
    arm.scale.x = back.length();
    end.add(laid(arm, new THREE.Vector3(), back));
  }

  /** Two joints: a strut to the first pin, an arm from there to the second one, and the arm beyond it. */
  #onTwo(path, { frame, end, metal, dark, own, unit }) {
    const middle = new THREE.Group(); // turned by the first joint alone, about where the free end is then
    frame.add(middle);
    const pin = (one, parent, place) => {
      const bolt = new THREE.Mesh(new THREE.CylinderGeometry(0.0105 * unit, 0.0105 * unit, 0.028 * unit, 20), dark);
      bolt.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), one.axis.clone().normalize());
      bolt.position.copy(place);
      parent.add(bolt);
    };
    const outer = path.second;
    const foot = path.isHinge ? path.anchor : new THREE.Vector3();
    if (path.isHinge) {
      this.#strut(path.anchor, 0.0075, { frame, metal, unit });
      pin(path, frame, path.anchor);
    }
    const from = path.anchor.clone().sub(path.start);
    const to = outer.isHinge ? outer.anchor.clone().sub(path.start) : new THREE.Vector3();
    if (outer.isHinge) pin(outer, middle, to);
    const span = (begin, stop, parent) => {
      const tube = new THREE.Mesh(rod(0.006 * unit), own);
      tube.scale.x = Math.max(begin.distanceTo(stop), 1e-6);
      parent.add(laid(tube, begin, stop));
    };
    if (path.isHinge) span(from, to, middle);
    else span(foot, path.start.clone().add(to), frame); // along which it slides
    if (outer.isHinge) span(new THREE.Vector3(), to, end);
    return middle;
  }

  /** A latch: a face on what moves, and one before it on what carries the joint, held from there. */
  #latch(latch, whole, { frame, end, middle, metal, unit, paint, colours }) {
    const isSecond = latch.joint === 1;
    const path = isSecond ? whole.second : whole;
    const [carrier, mover] = isSecond ? [middle ?? frame, end] : [frame, middle ?? end];
    const origin = carrier === frame ? new THREE.Vector3() : whole.start; // from which places in the carrier count
    const face = new THREE.Vector3(...latch.face);
    const thick = 0.006 * unit;
    const glow = paint(colours.dark);
    const plate = () => {
      const radius = (path.isHinge ? 0.011 : 0.019) * unit; // wider than the seats of springs
      const shape = new THREE.CylinderGeometry(radius, radius, thick, 20);
      return new THREE.Mesh(shape.rotateZ(-Math.PI / 2), glow);
    };
    const along = path.along.clone().normalize(); // against the way in which the arm gives in
    const towards = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(1, 0, 0), along);
    const [held, moving] = [plate(), plate()];
    held.quaternion.copy(towards);
    moving.quaternion.copy(towards);
    held.position.copy(face).addScaledVector(along, 1.1 * thick).sub(origin);
    moving.position.copy(face).sub(whole.start);
    const bracket = new THREE.Mesh(rod(0.0028 * unit, 8), metal);
    const foot = path.anchor.clone().addScaledVector(along, path.isHinge ? thick : 0).sub(origin);
    bracket.scale.x = Math.max(foot.distanceTo(held.position), 1e-6);
    carrier.add(held, laid(bracket, foot, held.position));
    mover.add(moving);
    return { glow, held, moving, travel: latch.travel, isSecond };
  }

  /** Where springs between arms are drawn, from end to end, and the faces of latches; as `ends`. */
  connections() {
    this.group.updateWorldMatrix(true, true);
    const origin = this.group.parent?.position ?? new THREE.Vector3();
    const place = (object) => object.getWorldPosition(new THREE.Vector3()).sub(origin).toArray();
    const far = (coil) => coil.localToWorld(new THREE.Vector3(1, 0, 0)).sub(origin).toArray();
    return {
      springs: this.springs.map(({ coil }) => [place(coil), far(coil)]),
      latches: this.arms.flatMap(({ latches }) => latches ?? []).map(({ held, moving, glow }) => ({
        held: place(held), moving: place(moving), open: glow.color.equals(this.open),
      })),
    };
  }

  /** Of each arm, where its cage is drawn, the normal of its circle, and the axis of its own rotor, if it has one; from where
   * the group is put. */
  ends() {
    this.group.updateWorldMatrix(true, true);
    const origin = this.group.parent?.position ?? new THREE.Vector3();
    const own = (j) => this.rotors[this.flight.rotors.findIndex((one) => one.arm === j)]?.rotor;
    return this.arms.map(({ tip }, j) => ({
      centre: tip.getWorldPosition(new THREE.Vector3()).sub(origin).toArray(),
      normal: new THREE.Vector3(0, 0, 1).transformDirection(tip.matrixWorld).toArray(),
      thrust: own(j) ? new THREE.Vector3(0, 0, 1).transformDirection(own(j).matrixWorld).toArray() : null,
    }));
  }

  /** Show a pose of flight.js, with arm compressions multiplied by `magnified`. */
  show(pose, magnified = 1) {
    this.group.position.set(...pose.position);
    const [w, x, y, z] = pose.quaternion;
    this.group.quaternion.set(x, y, z, w);
    const touching = new Set(pose.contacts.filter(Boolean).map((one) => one.part));
    this.arms.forEach((arm, j) => {
      const length = magnified === 1 ? pose.armLengths[j] : arm.free - stretched(magnified * (arm.free - pose.armLengths[j]), arm);
      const bend = magnified === 1 ? (pose.bends[j] ?? 0) : stretched(magnified * (pose.bends[j] ?? 0), arm);
      if (arm.hung) arm.path.at(length, arm.end.position, arm.end.quaternion, bend);
      else arm.end.position.x = length;
      if (arm.middle) arm.path.at(length, arm.middle.position, arm.middle.quaternion);
      for (const latch of arm.latches ?? []) {
        const pressed = latch.isSecond ? -(pose.bends[j] ?? 0) : arm.free - pose.armLengths[j];
        latch.glow.color.copy(pressed > latch.travel ? this.open : this.shut);
      }
      arm.shown = length;
      arm.bend = bend;
      if (arm.coil) arm.coil.scale.x = Math.max(length - arm.collar - arm.seat, 0.004);
      arm.cagePaint.color.set(touching.has(j) ? this.flight.glow : this.flight.colour);
    });
    this.rotors.forEach((one, k) => {
      if (one.level) one.rotor.quaternion.copy(one.level.end.quaternion).invert().multiply(one.aim); // it does not turn with the arm
      one.blades.rotation.z = one.spin * pose.own * 60; // as in slow motion
      const bar = (this.bar * pose.thrust[k]) / this.most;
      one.thrust.visible = bar > 1e-3;
      one.thrust.scale.z = Math.max(bar, 1e-3);
    });
    for (const { coil, first, second, from, to, way } of this.springs) {
      for (const [j, place] of [[first, from], [second, to]]) this.arms[j].path.at(this.arms[j].shown, place, null, this.arms[j].bend);
      const length = way.copy(to).sub(from).length();
      coil.position.copy(from);
      coil.quaternion.setFromUnitVectors(AHEAD, way.divideScalar(Math.max(length, 1e-6)));
      coil.scale.x = Math.max(length, 1e-6);
    }
    this.hulls.forEach((glass, k) => {
      glass.color.set(touching.has(this.arms.length + k) ? this.flight.glow : this.flight.colour);
    });
  }
}

/** A magnified compression as far as it can be shown [m]; arms on joints give way to either side. */
function stretched(pressed, arm) {
  const most = 0.4 * arm.free;
  return Math.min(arm.hung ? Math.max(pressed, -most) : pressed, most);
}

/** Free the graphics resources of an object and its children. */
export function disposed(object) {
  object.traverse((one) => {
    one.geometry?.dispose();
    for (const paint of [one.material].flat()) {
      paint?.map?.dispose();
      paint?.dispose?.();
    }
  });
  object.removeFromParent();
}
