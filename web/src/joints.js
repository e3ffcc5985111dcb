// Paths of the ends of arms: along their directions, or on joints as in springback.vehicle.arms.joints.
import * as THREE from "three";

const vector = ({ x, y, z }) => new THREE.Vector3(x, y, z);
/** A path of less curvature is straight [1/m]. */
const STRAIGHT = 1e-9;

/** Distance of the free end of an arm from the main body [m]. */
export const reachOfArm = (arm) => (arm.joint.length ? vector(arm.joint[0].path.end).length() : arm.length);

/** How far an arm has given way at a length [m] and the way of a second joint: on joints, to either side. */
export const given = (arm, length, bend = 0) =>
  arm.joint.length ? Math.max(Math.abs(arm.length - length), Math.abs(bend)) : arm.length - length;

/** Where the end of an arm is, in body axes. */
export class ArmPath {
  constructor(arm) {
    this.free = arm.length;
    this.along = new THREE.Vector3(...arm.direction);
    const [joint] = arm.joint;
    if (!joint) return;
    this.#take(joint);
    const [second] = arm.second;
    if (!second) return;
    this.second = new ArmPath({ length: 0, direction: arm.direction, joint: [second], second: [] });
    this.beyond = new THREE.Vector3();
    this.inner = new THREE.Quaternion();
  }

  #take(joint) {
    this.start = vector(joint.path.end);
    this.along = vector(joint.path.direction);
    this.inward = vector(joint.path.inward);
    this.axis = this.along.clone().cross(this.inward);
    this.curvature = joint.path.curvature;
    this.anchor = new THREE.Vector3(...joint.anchor);
  }

  get isHinge() {
    return this.curvature > STRAIGHT;
  }

  /** Set the end at a length [m] and the way of a second joint [m], and the turn of what is there. */
  at(length, end, turn = null, bend = 0) {
    if (this.second && bend !== 0) {
      this.#alone(length, end, this.inner);
      this.second.at(bend, this.beyond, turn);
      end.add(this.beyond.sub(this.start).applyQuaternion(this.inner)); // r = x1 + R1 (x2 - r0)
      turn?.premultiply(this.inner);
    } else this.#alone(length, end, turn);
  }

  /** The same of the first joint alone. */
  #alone(length, end, turn) {
    turn?.identity();
    if (!this.start) {
      end.copy(this.along).multiplyScalar(length);
      return;
    }
    const beyond = length - this.free;
    end.copy(this.start);
    if (!this.isHinge) {
      end.addScaledVector(this.along, beyond);
      return;
    }
    const angle = this.curvature * beyond;
    end.addScaledVector(this.along, Math.sin(angle) / this.curvature);
    end.addScaledVector(this.inward, (1 - Math.cos(angle)) / this.curvature);
    turn?.setFromAxisAngle(this.axis, angle);
  }
}
