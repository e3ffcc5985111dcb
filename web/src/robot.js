// Model of a robot: main body, sliding arms, springs that compress, cages.
import * as THREE from "three";
import { unpacked } from "./flight.js";

const TURNS = 7;
const WIRE = 0.0022;

/** A helix of length 1 along x, to be scaled. */
function helix(radius) {
  class Helix extends THREE.Curve {
    getPoint(u, target = new THREE.Vector3()) {
      const angle = 2 * Math.PI * TURNS * u;
      return target.set(u, radius * Math.cos(angle), radius * Math.sin(angle));
    }
  }
  return new THREE.TubeGeometry(new Helix(), TURNS * 14, WIRE, 5);
}

/** A cylinder of length 1 along x, from 0 to 1. */
function rod(radius, sides = 14) {
  const shape = new THREE.CylinderGeometry(radius, radius, 1, sides);
  return shape.rotateZ(-Math.PI / 2).translate(0.5, 0, 0);
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
    this.most = flight.max_thrust || 1;
    this.bar = 1.2 * span;
  }

  #arm(arm, { metal, dark, own, spring, paint, colours, unit, faded, look }) {
    const frame = new THREE.Group();
    frame.rotation.z = Math.atan2(arm.direction[1], arm.direction[0]);
    this.group.add(frame);
    const stroke = arm.length - arm.shortest;
    const end = new THREE.Group(); // moves with the end of the arm
    frame.add(end);
    const parts = { end, frame, free: arm.length };
    const collar = 0.13 * arm.length; // distance of the spring's outer seat from the end of the arm
    if (arm.compliant) {
      const seat = Math.max(0.24 * arm.length, arm.shortest - collar - 0.8 * stroke);
      const tube = new THREE.Mesh(rod(0.0075 * unit), metal);
      tube.scale.x = arm.shortest - 0.5 * collar;
      const slide = new THREE.Mesh(rod(0.0045 * unit), own);
      slide.position.x = -(arm.length - seat) + 0.3 * collar;
      slide.scale.x = -slide.position.x;
      const ring = () => new THREE.Mesh(new THREE.CylinderGeometry(0.0155 * unit, 0.0155 * unit, 0.006 * unit, 20).rotateZ(Math.PI / 2), dark);
      const fixed = ring();
      fixed.position.x = seat;
      const moving = ring();
      moving.position.x = -collar;
      const coil = new THREE.Mesh(helix(0.0125 * unit), spring);
      coil.position.x = seat;
      frame.add(tube, fixed, coil);
      end.add(slide, moving);
      Object.assign(parts, { coil, seat, collar });
    } else {
      const tube = new THREE.Mesh(rod(0.007 * unit), metal);
      tube.scale.x = arm.length;
      frame.add(tube);
    }
    const motor = new THREE.Mesh(new THREE.CylinderGeometry(0.013 * unit, 0.013 * unit, 0.024 * unit, 18).rotateX(Math.PI / 2), dark);
    motor.position.z = 0.008 * unit;
    const reach = 0.62 * arm.cage_radius;
    const disc = new THREE.Mesh(
      new THREE.CircleGeometry(reach, 36),
      paint(colours.thrust, { transparent: true, opacity: 0.16 * look.opacity, side: THREE.DoubleSide, depthWrite: false }),
    );
    disc.position.z = 0.022 * unit;
    const blades = new THREE.Mesh(new THREE.BoxGeometry(2 * reach, 0.012 * unit, 0.0015), dark);
    blades.position.z = 0.023 * unit;
    const cagePaint = paint(look.colour, { roughness: 0.4 });
    const cage = new THREE.Mesh(new THREE.TorusGeometry(arm.cage_radius - 0.0035 * unit, 0.0035 * unit, 10, 72), cagePaint);
    end.add(motor, disc, blades, cage);
    const glass = paint(look.colour, { transparent: true, opacity: 0.22 * look.opacity, depthWrite: false });
    const hulls = new THREE.Group(); // in body axes, from the end of the arm
    hulls.rotation.z = -frame.rotation.z;
    for (const one of arm.hulls) hulls.add(solid(one, glass));
    end.add(hulls);
    for (let k = 0; k < 3; k++) {
      const strut = new THREE.Mesh(rod(0.0016 * unit, 6), metal);
      strut.rotation.z = (2 * Math.PI * (k + 0.5)) / 3;
      strut.scale.x = arm.cage_radius - 0.004 * unit;
      end.add(strut);
    }
    const thrust = new THREE.Mesh(
      new THREE.CylinderGeometry(0.006 * unit, 0.006 * unit, 1, 12).rotateX(Math.PI / 2).translate(0, 0, 0.5),
      paint(colours.thrust, { transparent: true, opacity: 0.8 * look.opacity, emissive: colours.thrust, emissiveIntensity: 0.3 }),
    );
    thrust.position.z = 0.024 * unit;
    end.add(thrust);
    return Object.assign(parts, { blades, cagePaint, thrust, spin: arm.spin });
  }

  /** Show a pose of flight.js, with arm compressions multiplied by `magnified`. */
  show(pose, magnified = 1) {
    this.group.position.set(...pose.position);
    const [w, x, y, z] = pose.quaternion;
    this.group.quaternion.set(x, y, z, w);
    const touching = new Set(pose.contacts.filter(Boolean).map((one) => one.part));
    this.arms.forEach((arm, j) => {
      const pressed = Math.min(magnified * (arm.free - pose.armLengths[j]), 0.4 * arm.free);
      const length = magnified === 1 ? pose.armLengths[j] : arm.free - pressed;
      arm.end.position.x = length;
      if (arm.coil) arm.coil.scale.x = Math.max(length - arm.collar - arm.seat, 0.004);
      arm.blades.rotation.z = arm.spin * pose.own * 60; // as in slow motion
      const bar = (this.bar * pose.thrust[j]) / this.most;
      arm.thrust.visible = bar > 1e-3;
      arm.thrust.scale.z = Math.max(bar, 1e-3);
      arm.cagePaint.color.set(touching.has(j) ? this.flight.glow : this.flight.colour);
    });
    this.hulls.forEach((glass, k) => {
      glass.color.set(touching.has(this.arms.length + k) ? this.flight.glow : this.flight.colour);
    });
  }
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
