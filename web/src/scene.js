// Three-dimensional view of one flight or several.
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { palette } from "./colours.js";
import { estimateAt, flightOf, hasEstimate, impactBefore, largestForce, poseAt, roundBelow, touchOf, unpacked } from "./flight.js";
import { reachOfArm } from "./joints.js";
import { Arrow, Robot, disposed } from "./robot.js";
import { Mover, Path, Shadow, compass, joined, kindOf, moved, obstacle, rail, reference, restingShadow, shadesOf } from "./surroundings.js";

/** Length of the arrow of a round force near the largest [m]; distance of robots side by side [m]. */
const ROUND_ARROW = 0.22;
const BETWEEN = 0.2;
/** Flights with bodies wider than this are not put side by side, but in one place [m]. */
const WIDEST = 2.5;
/** Vehicles of one world that are farther from their middle are not all in the view that follows them [m]. */
const APART = 1.0;
/** Flights whose first touches differ by more than this are aligned [s]. */
const TOGETHER = 5e-3;
/** Nearest and farthest that is seen, and largest distance of the camera from where it looks [m]; on long flights it sees farther. */
const [NEAREST, SIGHT, FARTHEST] = [0.02, 80, 30];
/** Nearest that is seen from far away, over the distance of the camera from where it looks. */
const CLOSE = 0.01;
const FOLLOWING = ["follow", "front", "side", "top"];
export const CAMERAS = ["follow", "free", "front", "side", "top", "impact"];
/** A moving picture slower than this is drawn with fewer pixels [ms], at least this share of them along each side. */
const SLOW = 100;
const COARSEST = 0.4;
/** Time after the last drawing at which a picture is drawn with all its pixels [ms]. */
const STILL = 400;

/** Radius of a robot with its cages [m]. */
const reachOf = (flight) => Math.max(...flight.arms.map((arm) => reachOfArm(arm) + arm.cage_radius));

/** Give flights their colours, and align their first touches. */
export function together(scenes, colours, align = true) {
  const flights = scenes.map(flightOf);
  const robots = colours.robots;
  flights.forEach((flight, k) => {
    const rigid = !flight.arms.some((arm) => arm.compliant);
    flight.colour = flights.length > 1 ? robots[k % robots.length] : robots[rigid ? 1 : 0];
    flight.glow = colours.force;
    flight.index = k;
    flight.shift = 0;
  });
  const touches = flights.map(touchOf);
  const first = touches.find((touch) => touch !== null);
  touches.forEach((touch, k) => {
    if (align && touch !== null && Math.abs(first - touch) > TOGETHER) flights[k].shift = first - touch;
  });
  return flights;
}

/**
 * A view of flights inside an element.
 *
 * @param element element to fill; its size is that of the view
 * @param options.flights scenes from springback.interfaces.replay.scene.plain, or flights
 * @param options.compare "side" or "ghost": all but the first flight translucent, in one place
 * @param options.align align flights that touch at different times
 * @param options.onCamera called with the view, one of CAMERAS, when it is selected, and with "" when the user has moved the camera
 * @param options.onDrawn called after each drawing
 */
export function createScene(element, { flights = [], compare = "side", align = true, onCamera = () => {}, onDrawn = () => {} } = {}) {
  const state = { compare, align, magnified: 1, camera: "follow", t: 0, all: [], hidden: new Set(), flights: [], forces: true, path: true, estimate: false, share: 1 };
  let colours = palette();
  element.classList.add("picture");
  const labels = document.createElement("div");
  labels.className = "force-labels";
  const legend = document.createElement("div");
  legend.className = "scene-legend";

  let renderer = null;
  try {
    renderer = new THREE.WebGLRenderer({ antialias: true, alpha: false, stencil: true, powerPreference: "high-performance" });
  } catch {
    const sorry = document.createElement("p");
    sorry.className = "no-graphics";
    sorry.textContent = "This browser cannot draw 3-D graphics (WebGL is off); plots and numbers work.";
    element.append(sorry);
  }
  const world = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(38, 1, NEAREST, SIGHT);
  camera.up.set(0, 0, 1);
  const corner = new THREE.Scene();
  const cornerCamera = new THREE.OrthographicCamera(-1.9, 1.9, 1.9, -1.9, 0.1, 20);
  cornerCamera.up.set(0, 0, 1);
  const sky = new THREE.HemisphereLight("#ffffff", "#9aa4b0", 2.1);
  const sun = new THREE.DirectionalLight("#ffffff", 2.0);
  sun.position.set(-2, -3, 5);
  world.add(sky, sun);
  let controls = null;
  let content = new THREE.Group();
  let actors = [];
  let asked = 0;
  let askedAt = 0;
  let drawnAt = -Infinity;
  let resting = 0;
  let slowness = 0;
  const resolution = new THREE.Vector2(1, 1);

  if (renderer) {
    renderer.localClippingEnabled = true;
    element.append(renderer.domElement, labels, legend);
    renderer.domElement.setAttribute("role", "img");
    renderer.domElement.setAttribute("aria-label", "The flight in three dimensions, with numbers beside it.");
    controls = new OrbitControls(camera, renderer.domElement);
    controls.enableDamping = false;
    controls.minDistance = 0.15;
    controls.maxDistance = FARTHEST;
    controls.addEventListener("change", draw);
    let held = false;
    controls.addEventListener("start", () => (held = true));
    controls.addEventListener("end", () => (held = false));
    controls.addEventListener("change", () => {
      if (held && state.camera !== "follow") onCamera(""); // it still follows, from another side
    });
  }

  /** Schedule one drawing. */
  function draw() {
    if (!renderer || asked) return;
    askedAt = performance.now();
    asked = requestAnimationFrame(drawn);
  }

  /** Fewer pixels while a picture moves too slowly, all of them when it has come to rest. */
  function pacePixels() {
    const now = performance.now();
    const moves = askedAt - drawnAt < STILL;
    drawnAt = now;
    clearTimeout(resting);
    if (moves) slowness = 0.7 * slowness + 0.3 * (now - askedAt);
    if (slowness > SLOW && state.share > COARSEST) {
      state.share = Math.max(COARSEST, 0.7 * state.share);
      slowness = 0.5 * SLOW;
    }
    setPixels(moves ? state.share : 1);
    if (moves && state.share < 1) resting = setTimeout(draw, STILL);
  }

  function setPixels(share) {
    const ratio = Math.min(devicePixelRatio || 1, 2) * share;
    if (Math.abs(renderer.getPixelRatio() - ratio) > 1e-3) renderer.setPixelRatio(ratio);
  }

  function drawn() {
    asked = 0;
    if (!renderer || !element.clientWidth || !element.clientHeight) return;
    pacePixels();
    render();
    onDrawn();
  }

  function render() {
    const width = element.clientWidth;
    const height = element.clientHeight;
    renderer.setViewport(0, 0, width, height);
    renderer.setScissorTest(false);
    renderer.setClearColor(colours.background, 1);
    camera.near = Math.max(NEAREST, CLOSE * camera.position.distanceTo(controls.target)); // depths of far views are coarse else
    camera.updateProjectionMatrix();
    renderer.render(world, camera);
    const side = Math.min(104, 0.24 * Math.min(width, height));
    cornerCamera.position.copy(camera.position).sub(controls.target).setLength(6);
    cornerCamera.up.copy(camera.up);
    cornerCamera.lookAt(0, 0, 0);
    renderer.autoClear = false;
    renderer.clearDepth();
    renderer.setViewport(6, 6, side, side);
    renderer.render(corner, cornerCamera);
    renderer.autoClear = true;
    placeLabels(width, height);
  }

  // -- flights ------------------------------------------------------------------------------------

  /** Horizontal direction along the first wall, to the left when flying north; y without a wall. */
  function leftward() {
    const wall = state.flights[0].obstacles.find((one) => one.kind === "wall" || one.kind === "mat");
    const left = wall && Math.abs(wall.normal[2]) < 0.9 ? new THREE.Vector3(...wall.across).normalize() : new THREE.Vector3(0, 1, 0);
    return left.y < 0 ? left.negate() : left;
  }

  /** Horizontal direction into the first wall, or north. */
  const forward = () => leftward().applyAxisAngle(camera.up, -Math.PI / 2);

  /** Width of the bodies of built-in shapes across the flights [m]. */
  function widthOfBodies(across) {
    const at = new THREE.Vector3();
    let [low, high] = [Infinity, -Infinity];
    for (const one of state.flights.flatMap((flight) => flight.obstacles)) {
      if (one.kind !== "mesh" || one.normals) continue;
      const places = unpacked(one.vertices);
      for (let k = 0; k < places.length; k += 3) {
        const aside = at.fromArray(places, k).dot(across);
        [low, high] = [Math.min(low, aside), Math.max(high, aside)];
      }
    }
    return Math.max(0, high - low);
  }

  /** Numbers of the worlds that are shown; vehicles of one world are in one place. */
  const worlds = () => [...new Set(state.flights.map((flight) => flight.world))];

  /** Width of the places of vehicles that share a world, across the flights [m]. */
  function widthOfPlaces(across) {
    const shared = state.flights.filter((one) => state.flights.some((other) => other !== one && other.world === one.world));
    const at = new THREE.Vector3();
    let [low, high] = [Infinity, -Infinity];
    for (const { position } of shared) {
      for (let k = 0; k < position.length; k += 3) {
        const aside = at.fromArray(position, k).dot(across);
        [low, high] = [Math.min(low, aside), Math.max(high, aside)];
      }
    }
    return Math.max(0, high - low);
  }

  /** "side" or "ghost": as chosen, unless bodies in the way would stand in each other. */
  const comparison = () => (tooWide() ? "ghost" : state.compare);
  const tooWide = () => worlds().length > 1 && widthOfBodies(leftward()) > WIDEST;

  function offsets() {
    if (comparison() !== "side") return state.flights.map(() => [0, 0, 0]);
    const across = leftward();
    const reach = Math.max(...state.flights.map(reachOf));
    const apart = Math.max(2 * reach + widthOfPlaces(across), widthOfBodies(across)) + BETWEEN;
    const all = worlds();
    const middle = 0.5 * (all.length - 1);
    return state.flights.map(({ world }) => across.clone().multiplyScalar((middle - all.indexOf(world)) * apart).toArray());
  }

  /** Replace the flights; the camera is kept if requested. */
  function replace(scenes, { keepCamera = true } = {}) {
    colours = palette();
    state.all = together(scenes, colours, state.align);
    state.flights = state.all.filter((_, k) => !state.hidden.has(k));
    if (renderer) rebuild();
    if (!keepCamera) setCamera(state.camera);
    show(state.t);
  }

  function rebuild() {
    disposed(content);
    content = new THREE.Group();
    world.add(content);
    corner.children.slice().forEach(disposed);
    corner.add(compass(colours));
    labels.replaceChildren();
    const places = offsets();
    const boxes = new THREE.Box3();
    const most = Math.max(...state.flights.map(largestForce), 0);
    const scale = most > 0 ? ROUND_ARROW / roundBelow(most) : 0;
    state.floor = floorOf(places);
    actors = state.flights.map((flight, k) => {
      const group = new THREE.Group();
      group.position.set(...places[k]);
      content.add(group);
      const ghost = flight.world !== worlds()[0] && comparison() === "ghost";
      const robot = new Robot(flight, { colour: flight.colour, opacity: ghost ? 0.35 : 1 }, colours);
      const path = new Path(flight, colours, resolution);
      const arrows = flight.part.map(() => new Arrow(colours.force, 0.007, ghost ? 0.4 : 0.95));
      const shadow = new Shadow(flight, state.floor, colours);
      shadow.group.visible = !ghost || state.flights.length === 2; // of many in one place they are a blot
      const estimate = hasEstimate(flight) ? new Robot(flight, { colour: colours.ink, opacity: 0.35 }, colours) : null;
      if (estimate) group.add(estimate.group);
      group.add(robot.group, path.group, shadow.group, ...arrows.map((arrow) => arrow.group));
      if (flight.guide.length) group.add(rail(flight, colours));
      const box = new THREE.Box3();
      const stride = Math.max(1, Math.floor(flight.n / 400));
      for (let i = 0; i < flight.n; i += stride) {
        box.expandByPoint(new THREE.Vector3(...flight.position.subarray(3 * i, 3 * i + 3)));
      }
      boxes.union(box.translate(group.position));
      const several = state.flights.length > 1;
      const names = flight.part.map(() => {
        const name = document.createElement("span");
        labels.append(name);
        if (several) name.style.color = flight.colour;
        return name;
      });
      return { flight, group, robot, estimate, path, arrows, shadow, scale, names, ghost, contacts: [], movers: [] };
    });
    const things = state.flights.flatMap((flight, k) => flight.obstacles.filter((one) => one.track < 0).map((one) => moved(one, places[k])));
    const ground = things.some((one) => one.kind === "ground") ? state.floor : null;
    state.shadows = [];
    state.shades = shadesOf(state.flights.flatMap((flight) => flight.obstacles), colours);
    joined(things).forEach((thing) => {
      const shadow = restingShadow(thing, state.floor, ground);
      if (shadow) state.shadows.push(shadow);
      for (const drawn of [obstacle(thing, colours, state.shades, ground), shadow]) {
        if (!drawn) continue;
        drawn.position.add(new THREE.Vector3(...(thing.moved ?? [0, 0, 0])));
        content.add(drawn);
      }
    });
    actors.forEach((actor) => {
      actor.movers = actor.flight.bodies.map((track, k) => new Mover(track, actor.flight.obstacles.filter((one) => one.track === k), colours, state.shades, ground, state.floor));
      for (const mover of actor.movers) actor.group.add(mover.group);
    });
    state.box = boxes.clone();
    letFar();
    if (ground === null) {
      boxes.min.z = state.floor;
      content.add(reference(boxes, colours));
    }
    tellLegend();
  }

  /** Height of the plane of shadows: the ground, else slightly below the flight. */
  function floorOf() {
    const level = Math.max(...state.flights.flatMap((f) => f.obstacles.filter((o) => o.kind === "ground").map((o) => o.centre[2])));
    if (Number.isFinite(level)) return level;
    let lowest = Infinity;
    for (const flight of state.flights) for (let i = 2; i < 3 * flight.n; i += 3) lowest = Math.min(lowest, flight.position[i]);
    return lowest - 0.45;
  }

  function tellLegend() {
    const most = Math.max(...state.flights.map(largestForce), 0);
    legend.replaceChildren();
    const entry = (kind, text) => {
      const line = document.createElement("span");
      line.className = `key ${kind}`;
      line.textContent = text;
      legend.append(line);
    };
    if (state.flights.length > 1) {
      state.flights.forEach((flight) => {
        entry("robot", flight.label);
        legend.lastChild.style.setProperty("--colour", flight.colour);
      });
    }
    if (state.estimate && state.flights.some(hasEstimate)) entry("estimate", "estimated pose");
    if (most > 0 && state.forces) {
      const round = roundBelow(most);
      entry("force", `contact force, each at its point, ${round} N is ${100 * ROUND_ARROW} cm`);
    }
    if (state.flights.some((f) => f.thrust.some((x) => x > 0))) entry("thrust", "thrust");
    const kinds = new Set(state.flights.flatMap((f) => f.obstacles.map(kindOf)));
    if (comparison() !== state.compare) entry("words", "overlaid: the obstacles are too wide to be put side by side");
    if (state.magnified !== 1) entry("travel", `arm travel × ${state.magnified}, not to scale`);
    for (const kind of kinds) {
      entry("obstacle", kind);
      legend.lastChild.style.setProperty("--colour", state.shades?.get(kind) ?? colours.wall);
    }
  }

  function placeLabels(width, height) {
    const at = new THREE.Vector3();
    const taken = [];
    for (const actor of actors) {
      actor.names.forEach((name, j) => {
        const contact = actor.contacts[j];
        name.hidden = !state.forces || !contact || contact.size < 0.5;
        if (name.hidden) return;
        at.set(...contact.point).addScaledVector(new THREE.Vector3(...contact.force), actor.scale);
        at.add(actor.group.position).project(camera);
        name.hidden = at.z > 1 || Math.abs(at.x) > 1 || Math.abs(at.y) > 1;
        name.textContent = `${contact.size.toFixed(contact.size < 10 ? 1 : 0)} N`;
        const x = Math.min(Math.max(((at.x + 1) / 2) * width, 24), width - 24);
        const lowest = Math.min(Math.max(((1 - at.y) / 2) * height - 12, 10), height - 10);
        const free = (y) => y >= 10 && !taken.some(([a, b]) => Math.abs(a - x) < 50 && Math.abs(b - y) < 18);
        const y = (actor.ghost ? [0, 1, 2, 3] : [0]).map((k) => lowest - 20 * k).find(free); // of each flight in one place
        name.hidden = y === undefined;
        if (name.hidden) return;
        taken.push([x, y]);
        name.style.transform = `translate(${x}px, ${y}px) translate(-50%, -50%)`;
      });
    }
  }

  // -- time and camera ----------------------------------------------------------------------------

  let followed = null;
  let struck = null; // where the view of the impact looks

  function middle() {
    const places = actors.map((actor) => actor.robot.group.position.clone().add(actor.group.position));
    return places.reduce((a, b) => a.add(b), new THREE.Vector3()).divideScalar(places.length || 1);
  }

  /** Show the flights at a time [s]. */
  function show(t) {
    state.t = t;
    state.poses = state.flights.map((flight) => poseAt(flight, t));
    actors.forEach((actor, k) => {
      const pose = state.poses[k];
      actor.robot.show(pose, state.magnified);
      actor.path.group.visible = state.path;
      actor.path.show(pose.own);
      if (actor.estimate) {
        actor.estimate.group.visible = state.estimate;
        if (state.estimate) actor.estimate.show(estimateAt(actor.flight, t), state.magnified);
      }
      actor.shadow.show(pose);
      actor.movers.forEach((mover, j) => mover.show(pose.bodies[j]));
      actor.contacts = pose.contacts;
      actor.arrows.forEach((arrow, j) => {
        const contact = pose.contacts[j];
        if (contact && state.forces) arrow.show(contact.point, contact.force.map((x) => actor.scale * x));
        else arrow.hide();
      });
    });
    if (renderer && actors.length && state.camera === "impact") {
      const now = impactPlace();
      if (struck && now.distanceTo(struck) > 1e-9) {
        const moved = now.clone().sub(struck);
        camera.position.add(moved);
        controls.target.add(moved);
        controls.update();
      }
      struck = now;
    }
    if (renderer && actors.length && FOLLOWING.includes(state.camera)) {
      const now = middle();
      if (followed) {
        const moved = now.clone().sub(followed);
        camera.position.add(moved);
        controls.target.add(moved);
      }
      followed = now;
      controls.update();
    }
    draw();
  }

  /** Distance at which a sphere fills the view. */
  function farFrom(radius) {
    const half = THREE.MathUtils.degToRad(camera.fov / 2);
    const narrow = Math.min(1, camera.aspect);
    return radius / Math.sin(Math.atan(Math.tan(half) * narrow));
  }

  /** Box around the flights with their robots. */
  const whole = () => state.box.clone().expandByScalar(Math.max(...state.flights.map(reachOf)) + 0.1);
  const halfOf = (box) => 0.5 * box.getSize(new THREE.Vector3()).length();

  /** Let the camera go as far as it must to see whole flights, and see as far. */
  function letFar() {
    if (!renderer) return;
    const half = halfOf(whole());
    controls.maxDistance = Math.max(FARTHEST, 1.5 * farFrom(half));
    camera.far = Math.max(SIGHT, 2 * controls.maxDistance + 2 * half);
  }

  function look(target, from) {
    controls.target.copy(target);
    camera.position.copy(target).add(from);
    controls.update();
  }

  /** Select a view, one of CAMERAS. */
  function setCamera(mode) {
    state.camera = CAMERAS.includes(mode) ? mode : "follow";
    followed = struck = null;
    onCamera(state.camera);
    if (!renderer || !actors.length) return;
    const reach = Math.max(...state.flights.map(reachOf));
    const places = actors.map((actor) => actor.group.position);
    const apart = places[0].distanceTo(places[places.length - 1]) / 2;
    const radius = reach + apart + scattered() + 0.1;
    const row = worlds().length > 2 && apart > 0; // seen along the flight, as wide as the view
    const near = row ? Math.max(farFrom(reach + 0.2), radius / (Math.tan(THREE.MathUtils.degToRad(camera.fov / 2)) * camera.aspect) + reach) : farFrom(radius);
    const box = whole();
    const centre = box.getCenter(new THREE.Vector3());
    const before = row ? forward().negate().addScaledVector(leftward(), -0.25).setZ(0.5).normalize() : new THREE.Vector3(-0.62, -0.66, 0.42).normalize();
    if (state.camera === "free") look(centre, before.clone().multiplyScalar(farFrom(halfOf(box))));
    else if (state.camera === "impact") look((struck = impactPlace()), row ? before.clone().multiplyScalar(near) : new THREE.Vector3(-0.45, -0.62, 0.5).normalize().multiplyScalar(farFrom(radius + 0.05)));
    else {
      followed = middle();
      const from = { follow: before, front: forward().setZ(0.12), side: leftward().negate().setZ(0.12), top: new THREE.Vector3(0, -0.001, 1) }[state.camera];
      look(followed.clone(), from.clone().normalize().multiplyScalar(state.camera === "side" ? farFrom(radius) : near));
    }
    draw();
  }

  /** Where the first, middle and last point of a flight are in the picture: right and up from −1 to 1, and depth likewise. */
  function seenEnds(flight, group) {
    const at = new THREE.Vector3();
    return [0, flight.n >> 1, flight.n - 1].map((k) => at.fromArray(flight.position, 3 * k).add(group.position).project(camera).toArray());
  }

  /** Largest distance of vehicles that share a world from the middle between them now, as far as the view follows [m]. */
  function scattered() {
    const away = actors.map(({ flight, robot }) => {
      const beside = actors.filter((other) => other.flight.world === flight.world);
      const places = beside.map((other) => other.robot.group.position.clone());
      const centre = places.reduce((a, b) => a.add(b), new THREE.Vector3()).divideScalar(beside.length);
      return centre.distanceTo(robot.group.position);
    });
    return Math.min(Math.max(...away), APART);
  }

  /** Centre of the robots as they began the impacts that are under way or were the last; before all, at first touch. */
  function impactPlace() {
    const at = state.flights.map((flight, k) => {
      const pose = poseAt(flight, impactBefore(flight, state.t) ?? touchOf(flight) ?? flight.begin);
      return new THREE.Vector3(...pose.position).add(actors[k].group.position);
    });
    return at.reduce((a, b) => a.add(b), new THREE.Vector3()).divideScalar(at.length);
  }

  function resize() {
    if (!renderer) return;
    const width = element.clientWidth;
    const height = element.clientHeight;
    if (!width || !height) return;
    setPixels(1);
    renderer.setSize(width, height, false);
    const before = camera.aspect;
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    if (actors.length) letFar();
    resolution.set(width, height);
    actors.forEach((actor) => actor.path.resize(resolution));
    if (Math.abs(before / camera.aspect - 1) > 0.15) setCamera(state.camera);
    draw();
  }

  const watching = new ResizeObserver(resize);
  watching.observe(element);
  const scheme = matchMedia("(prefers-color-scheme: dark)");
  const recolour = () => replace(state.all);
  scheme.addEventListener("change", recolour);

  function dispose() {
    watching.disconnect();
    scheme.removeEventListener("change", recolour);
    cancelAnimationFrame(asked);
    clearTimeout(resting);
    disposed(content);
    corner.children.slice().forEach(disposed);
    controls?.dispose();
    renderer?.dispose();
    element.replaceChildren();
  }

  resize();
  if (flights.length) replace(flights, { keepCamera: false });
  return {
    show,
    replace,
    setCamera,
    resize,
    dispose,
    /** "side" or "ghost". */
    setCompare(mode) {
      state.compare = mode;
      if (state.flights.length) replace(state.all, { keepCamera: false });
    },
    /** "side" or "ghost": how the flights are shown, as chosen if they can be. */
    get compared() {
      return comparison();
    },
    /** "side" or "ghost": how they were chosen to be shown. */
    get wantedCompare() {
      return state.compare;
    },
    /** True if the obstacles are too wide to be put side by side. */
    get tooWide() {
      return tooWide();
    },
    /** Show or hide a flight by its number, or "forces", "path", "estimate". */
    setShown(what, on) {
      if (typeof what !== "number") {
        state[what] = on;
        tellLegend();
        show(state.t);
        return;
      }
      if (on) state.hidden.delete(what);
      else state.hidden.add(what);
      replace(state.all, { keepCamera: false });
    },
    /** The picture: a canvas that is valid until the end of this task, drawn again with all its pixels or just drawn. */
    canvas(again = true) {
      if (again && renderer) {
        setPixels(1);
        render();
      }
      return renderer?.domElement ?? null;
    },
    /** Set the factor of arm compressions. */
    setMagnified(times) {
      state.magnified = times;
      tellLegend();
      show(state.t);
    },
    /** The flights that are shown. */
    get flights() {
      return state.flights;
    },
    /** All flights, the hidden ones, too. */
    get all() {
      return state.all;
    },
    get camera() {
      return state.camera;
    },
    /** Numbers of what is shown. */
    pose: () => ({ t: state.t, camera: state.camera, target: controls?.target.toArray(), pixels: state.share, flights: state.poses ?? [],
      places: actors.map(({ group, robot }) => robot.group.position.clone().add(group.position).toArray()), // where they are drawn
      ends: actors.map(({ robot }) => robot.ends()),
      seen: actors.map(({ flight, group }) => seenEnds(flight, group)),
      connections: actors.map(({ robot }) => robot.connections()),
      estimates: state.estimate ? state.flights.map((flight) => (hasEstimate(flight) ? estimateAt(flight, state.t) : null)) : [] }),
    /** Boxes around the shadows of obstacles, of those at rest first, for tests [m]. */
    shadows: () => [...state.shadows, ...actors.flatMap(({ movers }) => movers.map(({ shadow }) => shadow))].map((one) => {
      one.updateWorldMatrix(true, true);
      const box = new THREE.Box3().setFromObject(one, true);
      return [...box.min.toArray(), ...box.max.toArray()];
    }),
    /** Graphics resources in use, for tests of leaks. */
    memory: () => ({ ...renderer?.info.memory }),
  };
}
