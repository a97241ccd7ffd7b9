// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Camera, pointer and drawing. Draws only when something has changed.

import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Spheres } from "./spheres.js";
import { Surface } from "./surface.js";

const FIELD_OF_VIEW = 30;
const SLOW_FRAME = 1 / 28; // s: when frames take longer while something moves, fewer pixels are drawn
const FAST_FRAME = 1 / 55;
const LEAST_PIXELS = 0.5;
const GROUND_CLEARANCE = 0.04; // of the body's size: as low over the ground as the eye goes by itself
const CLICK_RADIUS = 5; // pixels between press and release: more is a drag

/**
 * The axis that points upwards is not in most files. Bodies are usually modelled on a ground at height 0: if that holds
 * for z, in some frame, and not for y, it is z; otherwise y.
 */
export function upAxis(boxes) {
  const standsOnGround = (c) => boxes.some(({ min, max }) => Math.abs(min[c]) < 0.02 * (max[c] - min[c]));
  return standsOnGround(2) && !standsOnGround(1) ? "z" : "y";
}

/** Whether the processor draws, and not a graphics card. */
function isSoftwareRenderer() {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (gl === null) return false; // three.js will say so
  const names = gl.getExtension("WEBGL_debug_renderer_info");
  const name = gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

export class Stage {
  constructor(canvas, scene, state) {
    this.canvas = canvas;
    this.scene = scene;
    this.state = state;
    THREE.ColorManagement.enabled = false; // the shaders do it
    // Without a graphics card, smooth edges take as long as all the rest: then, only still pictures have them.
    this.isSlow = isSoftwareRenderer();
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: !this.isSlow, alpha: true, powerPreference: "high-performance" });
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.world = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 100);
    this.surface = new Surface(scene);
    this.spheres = new Spheres(scene);
    this.world.add(this.surface.mesh, this.surface.wires, this.spheres.group);
    this.makeControls();
    this.pixels = 1;
    this.frameTimes = [];
    this.body = this.bodySize();
    state.set({ up: scene.view?.up ?? upAxis(scene.boxes) });
    this.ground = null;
    this.told = null; // the direction to the camera when the whole body is shown, if somebody else says so
    this.home = { target: new THREE.Vector3(), distance: 1 }; // of that view; the target as from what is followed
    this.onClick = () => {}; // what a click without a drag does, where on the canvas; with the shift key?
    this.onDrawn = () => {};
    this.addPointer();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
    state.subscribe((changed) => this.apply(changed));
    this.apply(state.values);
    this.resetView();
  }

  makeControls() {
    this.controls?.dispose();
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.18;
    this.controls.zoomToCursor = true;
    this.setButtons();
    this.controls.addEventListener("change", () => this.invalidate());
  }

  /** Where the left button paints, the right one turns. */
  setButtons() {
    const { ROTATE, DOLLY, PAN } = THREE.MOUSE;
    this.controls.mouseButtons = this.state.values.painting ? { LEFT: ROTATE, MIDDLE: PAN, RIGHT: ROTATE } : { LEFT: ROTATE, MIDDLE: DOLLY, RIGHT: PAN };
  }

  bodySize() {
    return Math.max(...this.scene.boxes.map(({ min, max }) => Math.hypot(...min.map((x, c) => max[c] - x))), 1e-9);
  }

  apply(changed) {
    const s = this.state.values;
    if ("time" in changed) {
      this.surface.setTime(s.time);
      if (s.follow) this.followTo(this.followedCentre(s.time));
    }
    if ("follow" in changed) {
      this.home?.target.add(this.origin());
      this.followed = s.follow ? this.followedCentre(s.time) : null;
      this.home?.target.sub(this.origin());
    }
    if ("field" in changed) this.surface.setField(s.field);
    if ("map" in changed) this.surface.setMap(s.map);
    if ("wires" in changed) this.surface.wires.visible = s.wires;
    if ("hidden" in changed || "opacity" in changed) this.spheres.setThrough(s.hidden, s.opacity);
    if ("opacity" in changed) this.surface.setOpacity(s.opacity);
    if ("up" in changed) this.setUp();
    if ("painting" in changed) this.setButtons();
    if ("theme" in changed) this.setColors();
    this.invalidate();
  }

  setColors() {
    const style = getComputedStyle(document.documentElement);
    this.surface.setColors(style.getPropertyValue("--clay").trim(), style.getPropertyValue("--ink").trim());
    this.grounds();
  }

  setUp() {
    this.camera.up.set(0, this.state.values.up === "y" ? 1 : 0, this.state.values.up === "z" ? 1 : 0);
    this.makeControls(); // they look at the direction at construction only
    this.grounds();
    if (this.framed) this.resetView();
  }

  /** A grid under the lowest point, fading out. */
  grounds() {
    if (this.ground) {
      this.world.remove(this.ground);
      this.ground.geometry.dispose();
    }
    const up = this.state.values.up === "z" ? 2 : 1, low = this.scene.box.min[up] - this.scene.centre[up];
    const lines = 12, cell = this.body / 6, points = [], alphas = [];
    const add = (a, b) => {
      const p = [a, b];
      p.splice(up, 0, low);
      points.push(...p);
      alphas.push(Math.max(0, 1 - Math.hypot(a, b) / (lines * cell)) ** 1.5);
    };
    for (let i = -lines; i <= lines; ++i)
      for (let j = -lines; j < lines; ++j) {
        add(i * cell, j * cell);
        add(i * cell, (j + 1) * cell);
        add(j * cell, i * cell);
        add((j + 1) * cell, i * cell);
      }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
    geometry.setAttribute("alpha", new THREE.Float32BufferAttribute(alphas, 1));
    const ink = new THREE.Color(getComputedStyle(document.documentElement).getPropertyValue("--grid").trim() || "#888");
    this.ground = new THREE.LineSegments(
      geometry,
      new THREE.ShaderMaterial({
        uniforms: { ink: { value: ink } },
        vertexShader: `attribute float alpha; varying float vAlpha;
          void main() { vAlpha = alpha; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
        fragmentShader: "uniform vec3 ink; varying float vAlpha; void main() { gl_FragColor = vec4(ink, 0.55 * vAlpha); }",
        transparent: true,
        depthWrite: false,
      }),
    );
    this.world.add(this.ground);
  }

  bodyCentre(time) {
    const { from, to, share } = this.scene.interval(time), a = this.scene.boxes[from], b = this.scene.boxes[to];
    const middle = (box, c) => (box.min[c] + box.max[c]) / 2 - this.scene.centre[c];
    return new THREE.Vector3(...[0, 1, 2].map((c) => middle(a, c) + share * (middle(b, c) - middle(a, c))));
  }

  followedCentre(time) {
    return new THREE.Vector3(...this.scene.centreAt(time));
  }

  /** Where the body is in all frames, seen from where it goes. */
  followedBox(time) {
    const now = this.scene.centreAt(time), min = [Infinity, Infinity, Infinity], max = [-Infinity, -Infinity, -Infinity];
    this.scene.boxes.forEach((box, k) => {
      for (let c = 0; c < 3; ++c) {
        const shift = now[c] - this.scene.centres[k][c];
        min[c] = Math.min(min[c], box.min[c] + shift);
        max[c] = Math.max(max[c], box.max[c] + shift);
      }
    });
    return { min, max };
  }

  followTo(centre) {
    if (this.followed) {
      const move = centre.clone().sub(this.followed);
      this.camera.position.add(move);
      this.controls.target.add(move);
    }
    this.followed = centre;
  }

  /** Shows the whole body, from where the program that made the page says, or from the front and the side, a little above. */
  resetView() {
    const follow = this.state.values.follow, time = this.state.values.time;
    const box = follow ? this.followedBox(time) : this.scene.box;
    const target = new THREE.Vector3(...box.min.map((x, c) => (x + box.max[c]) / 2 - this.scene.centre[c]));
    const size = box.min.map((x, c) => box.max[c] - x);
    // along the longer horizontal side
    const up = this.state.values.up;
    const isWide = up === "y" ? size[0] >= size[2] : size[0] >= size[1];
    const told = this.told ?? (this.scene.view?.up === up ? this.scene.view.direction : undefined);
    const direction = told ? new THREE.Vector3(...told) : up === "y"
      ? new THREE.Vector3(isWide ? 0.45 : 1, 0.28, isWide ? 1 : 0.45)
      : new THREE.Vector3(isWide ? 0.45 : 1, isWide ? -1 : -0.45, 0.28);
    const distance = this.distanceFor(box, target, direction.normalize());
    this.home = { target: target.clone().sub(this.origin()), distance };
    this.look(target, direction, distance);
    this.framed = true;
    this.touched = false;
  }

  /** From how far the box fills the picture. */
  distanceFor(box, target, direction) {
    const camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, this.camera.aspect);
    camera.up.copy(this.camera.up);
    camera.position.copy(direction);
    camera.lookAt(0, 0, 0);
    camera.updateMatrixWorld();
    const tangent = Math.tan((FIELD_OF_VIEW * Math.PI) / 360), margin = 1.12;
    let distance = 0;
    for (let i = 0; i < 8; ++i) {
      const corner = new THREE.Vector3(...[0, 1, 2].map((c) => ((i >> c) & 1 ? box.max[c] : box.min[c]) - this.scene.centre[c]));
      corner.sub(target).applyQuaternion(camera.quaternion.clone().invert());
      distance = Math.max(distance, corner.z + (margin * Math.abs(corner.y)) / tangent, corner.z + (margin * Math.abs(corner.x)) / (tangent * camera.aspect));
    }
    return distance;
  }

  look(target, direction, distance) {
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(direction, distance);
    this.camera.near = this.body / 500;
    this.camera.far = this.body * 100;
    this.controls.minDistance = this.body / 50;
    this.controls.maxDistance = this.body * 30;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.invalidate();
  }

  /** Goes close to a feature, to the side of it from which it is seen. */
  approach(feature) {
    const time = this.state.values.time;
    const place = new THREE.Vector3(...this.scene.place(feature, time).map((x, c) => x - this.scene.centre[c]));
    const outward = place.clone().sub(this.bodyCentre(time)).normalize();
    const direction = this.camera.position.clone().sub(this.controls.target).normalize();
    if (direction.dot(outward) < 0.2) direction.addScaledVector(outward, 1.2).normalize();
    const distance = Math.max(9 * feature.radius, this.body / 2.5);
    this.look(place, this.aboveGround(place, direction, distance), distance);
    this.touched = true;
  }

  /** The direction, lifted as far as it takes for the eye not to be below the ground. */
  aboveGround(place, direction, distance) {
    const up = this.state.values.up === "z" ? "z" : "y", c = up === "z" ? 2 : 1;
    const lowest = this.scene.box.min[c] - this.scene.centre[c] + GROUND_CLEARANCE * this.body;
    const least = Math.min((lowest - place[up]) / distance, 0.95);
    if (direction[up] >= least) return direction;
    const lifted = direction.clone();
    lifted[up] = 0;
    if (lifted.lengthSq() < 1e-12) lifted.x = 1;
    lifted.setLength(Math.sqrt(1 - least * least));
    lifted[up] = least;
    return lifted;
  }

  /** From where views are measured: the body while that is followed. */
  origin() {
    return this.followed ?? new THREE.Vector3();
  }

  /** The eye and what it looks at; null if nobody has moved it. */
  ownView() {
    if (!this.touched) return null;
    const from = this.origin();
    return [this.camera.position, this.controls.target].flatMap((p) => p.clone().sub(from).toArray());
  }

  setView(numbers) {
    const from = this.origin();
    const [eye, target] = [0, 3].map((i) => new THREE.Vector3(...numbers.slice(i, i + 3)).add(from));
    const direction = eye.sub(target), distance = direction.length();
    if (!(distance > 0)) return;
    this.look(target, direction.normalize(), distance);
    this.framed = this.touched = true;
  }

  /** The view relative to that of the whole body, for another body: direction, target, distance. */
  relativeView() {
    const { target } = this.controls, { home } = this, offset = this.camera.position.clone().sub(target), distance = offset.length();
    const moved = target.clone().sub(this.origin()).sub(home.target).divideScalar(home.distance);
    return { direction: offset.divideScalar(distance).toArray(), moved: moved.toArray(), distance: distance / home.distance };
  }

  setRelativeView({ direction, moved, distance }) {
    const { home } = this, target = new THREE.Vector3(...moved).multiplyScalar(home.distance).add(home.target).add(this.origin());
    this.look(target, new THREE.Vector3(...direction).normalize(), distance * home.distance);
    this.framed = this.touched = true;
  }

  zoom(factor) {
    this.touched = true;
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
    this.invalidate();
  }

  turn(sideways, upwards) {
    this.touched = true;
    const offset = this.camera.position.clone().sub(this.controls.target);
    const side = new THREE.Vector3().crossVectors(this.camera.up, offset).normalize();
    const angle = offset.angleTo(this.camera.up), margin = 0.05;
    const lift = Math.min(Math.max(upwards, angle - Math.PI + margin), angle - margin);
    offset.applyAxisAngle(this.camera.up, sideways).applyAxisAngle(side.applyAxisAngle(this.camera.up, sideways), -lift);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.invalidate();
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    const ratio = Math.min(window.devicePixelRatio, 2) * this.pixels;
    this.renderer.setPixelRatio(this.isSlow && this.isStill ? Math.max(ratio, 2) : ratio);
    this.renderer.setSize(clientWidth, clientHeight, false);
    if (this.framed && !this.touched) this.resetView();
    this.invalidate();
  }

  /** How many CSS pixels a unit of length has, so far from the eye. */
  pixelsAt(distance) {
    return this.canvas.clientHeight / 2 / Math.tan((FIELD_OF_VIEW * Math.PI) / 360) / distance;
  }

  /** Where on the canvas a feature is: CSS pixels, and the radius of its sphere. */
  project(feature) {
    const p = this.projectPlace(this.scene.place(feature, this.state.values.time));
    return { ...p, radius: feature.radius * this.pixelsAt(p.distance) };
  }

  /** Where on the canvas a place is; `moved`, if any, has the times from and to which it goes along with the body. */
  projectPlace(coordinates, moved = null) {
    this.camera.updateMatrixWorld();
    const place = new THREE.Vector3(...coordinates.map((x, c) => x - this.scene.centre[c]));
    if (moved) place.add(this.followedCentre(moved.to)).sub(this.followedCentre(moved.from));
    const distance = place.distanceTo(this.camera.position), p = place.project(this.camera);
    return { x: ((p.x + 1) / 2) * this.canvas.clientWidth, y: ((1 - p.y) / 2) * this.canvas.clientHeight, distance, isInFront: p.z < 1 };
  }

  /** From the eye through a point of the canvas. */
  rayThrough(x, y) {
    const caster = new THREE.Raycaster();
    const point = new THREE.Vector2((2 * x) / this.canvas.clientWidth - 1, 1 - (2 * y) / this.canvas.clientHeight);
    this.camera.updateMatrixWorld();
    caster.setFromCamera(point, this.camera);
    return caster.ray;
  }

  /** The feature at a point of the canvas, or -1. */
  featureAt(x, y) {
    const ray = this.rayThrough(x, y);
    if (this.spheres.pick(ray, Infinity) < 0) return -1;
    return this.spheres.pick(ray, this.surface.hit(ray, this.state.values.time)?.distance ?? Infinity);
  }

  /** Whether the surface hides the sphere of a feature. Linear in the triangles. */
  isCovered(feature) {
    const p = this.project(feature);
    return (this.surfaceAt(p.x, p.y)?.distance ?? Infinity) < p.distance - feature.radius;
  }

  /** The surface at a point of the canvas, see Surface.hit(). */
  surfaceAt(x, y) {
    return this.surface.hit(this.rayThrough(x, y), this.state.values.time);
  }

  addPointer() {
    this.pressed = null;
    this.canvas.addEventListener("pointerdown", (event) => {
      this.pressed = { x: event.offsetX, y: event.offsetY };
      this.touched = true;
    });
    this.canvas.addEventListener("pointercancel", () => (this.pressed = null));
    this.canvas.addEventListener("wheel", () => (this.touched = true), { passive: true });
    this.canvas.addEventListener("pointerup", (event) => {
      const { pressed } = this;
      this.pressed = null;
      if (pressed && Math.hypot(event.offsetX - pressed.x, event.offsetY - pressed.y) < CLICK_RADIUS)
        this.onClick(event.offsetX, event.offsetY, event.shiftKey);
    });
    this.canvas.addEventListener("dblclick", (event) => {
      const i = this.featureAt(event.offsetX, event.offsetY);
      if (i >= 0) this.approach(this.scene.features[i]);
      else this.resetView();
    });
  }

  invalidate() {
    this.isStale = true;
  }

  /** To be called in every animation frame, with the seconds since the last one. */
  draw(elapsed, isMoving) {
    this.controls.update();
    this.adapt(elapsed, isMoving);
    if (!this.isStale) return false;
    this.isStale = false;
    this.spheres.update(this.state.values.time, this.state.values, this.camera);
    this.renderer.render(this.world, this.camera);
    this.onDrawn();
    return true;
  }

  /** Fewer pixels while it is too slow; all of them for a picture that stands still. */
  adapt(elapsed, isMoving) {
    const isStill = !isMoving && !this.pressed;
    if (isStill !== this.isStill) {
      this.isStill = isStill;
      this.setPixels(isStill ? 1 : (this.pixelsInMotion ?? 1));
    }
    if (isStill) {
      this.frameTimes = [];
      return;
    }
    this.frameTimes.push(elapsed);
    if (this.frameTimes.length < 12) return;
    const median = this.frameTimes.sort((a, b) => a - b)[6];
    this.frameTimes = [];
    if (median > SLOW_FRAME && this.pixels > LEAST_PIXELS) this.setPixels(Math.max(LEAST_PIXELS, this.pixels * 0.75));
    else if (median < FAST_FRAME && this.pixels < 1) this.setPixels(Math.min(1, this.pixels * 1.15));
    this.pixelsInMotion = this.pixels;
  }

  setPixels(share) {
    this.pixels = share;
    this.resize();
  }

  /** Draws what is seen at full size, for a picture. To be called right before the canvas is read. */
  drawFully() {
    this.isStill = true;
    this.setPixels(1);
    this.draw(0, false);
  }
}
