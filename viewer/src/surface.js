// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The moving surface: the frames' positions and normals stay on the graphics card, which mixes two of them.

import * as THREE from "three";
import { MAP_SIZE, mapBytes } from "./colors.js";
import { VERTEX_STRIDE } from "./scene.js";

/** Of what is painted: far from all colours of fields, to those who do not tell red from green as well. */
export const PAINT = [0.84, 0.05, 0.55];

const VERTEX_SHADER = /* glsl */ `
  attribute vec4 positionA, positionB; // three coordinates, and the field
  attribute vec2 normalA, normalB;
  attribute vec4 paint; // whether it is painted, and whether it is under the brush
  uniform vec3 offsetA, offsetB;
  uniform float stepLength, share;
  varying vec3 vNormal, vView;
  varying float vValue;
  varying vec2 vPaint;

  vec3 unfolded(vec2 e) {
    vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
    return n;
  }

  void main() {
    vec3 place = mix(stepLength * positionA.xyz + offsetA, stepLength * positionB.xyz + offsetB, share);
    vec4 view = modelViewMatrix * vec4(place, 1.0);
    vNormal = normalMatrix * normalize(mix(unfolded(normalA), unfolded(normalB), share));
    vView = -view.xyz;
    vValue = mix(positionA.w, positionB.w, share) / 65535.0;
    vPaint = paint.xy;
    gl_Position = projectionMatrix * view;
  }
`;

// Light comes with the eye: from the upper left, with a soft light from below and a bright rim.
const FRAGMENT_SHADER = /* glsl */ `
  uniform sampler2D map;
  uniform vec3 plain;
  uniform bool hasField;
  uniform float opacity;
  varying vec3 vNormal, vView;
  varying float vValue;
  varying vec2 vPaint;

  void main() {
    vec3 n = normalize(vNormal), eye = normalize(vView);
    if (!gl_FrontFacing) n = -n;
    vec3 color = hasField ? texture2D(map, vec2((vValue * ${(MAP_SIZE - 1).toFixed(1)} + 0.5) / ${MAP_SIZE.toFixed(1)}, 0.5)).rgb : plain;
    // the brush is a light veil, paint covers what is there, within an edge that is seen on any colour
    vec3 ink = vec3(${PAINT.map((c) => c.toFixed(3)).join(", ")});
    color = mix(color, ink, 0.35 * step(0.5, vPaint.y));
    color = mix(color, vec3(1.0), step(0.38, vPaint.x));
    color = mix(color, mix(ink, vec3(1.0), 0.2 * step(0.5, vPaint.y)), step(0.5, vPaint.x));
    color *= color;
    vec3 key = vec3(-0.43, 0.62, 0.66), fill = vec3(0.72, -0.25, 0.65);
    float light = 0.30 + 0.16 * n.y + 0.72 * max(dot(n, key), 0.0) + 0.16 * max(dot(n, fill), 0.0);
    float rim = pow(1.0 - max(dot(n, eye), 0.0), 3.0);
    float shine = pow(max(dot(n, normalize(key + eye)), 0.0), 36.0);
    color = color * light + 0.10 * rim + 0.07 * shine;
    gl_FragColor = vec4(sqrt(color), opacity);
  }
`;

/** Unit normals in two 16-bit numbers each: the octahedron unfolded on a square. */
function normalsOf(numbers, faces, n) {
  const sums = new Float32Array(3 * n);
  for (let i = 0; i < faces.length; i += 3) {
    const a = faces[i], b = faces[i + 1], c = faces[i + 2];
    const p = VERTEX_STRIDE * a, q = VERTEX_STRIDE * b, r = VERTEX_STRIDE * c;
    const ux = numbers[q] - numbers[p], uy = numbers[q + 1] - numbers[p + 1], uz = numbers[q + 2] - numbers[p + 2];
    const wx = numbers[r] - numbers[p], wy = numbers[r + 1] - numbers[p + 1], wz = numbers[r + 2] - numbers[p + 2];
    const x = uy * wz - uz * wy, y = uz * wx - ux * wz, z = ux * wy - uy * wx;
    for (const v of [3 * a, 3 * b, 3 * c]) {
      sums[v] += x;
      sums[v + 1] += y;
      sums[v + 2] += z;
    }
  }
  const folded = new Int16Array(2 * n);
  for (let v = 0; v < n; ++v) {
    let x = sums[3 * v], y = sums[3 * v + 1];
    const z = sums[3 * v + 2], length = Math.abs(x) + Math.abs(y) + Math.abs(z);
    if (!(length > 0)) continue;
    x /= length;
    y /= length;
    if (z < 0) [x, y] = [(1 - Math.abs(y)) * (x < 0 ? -1 : 1), (1 - Math.abs(x)) * (y < 0 ? -1 : 1)];
    folded[2 * v] = Math.round(32767 * x);
    folded[2 * v + 1] = Math.round(32767 * y);
  }
  return folded;
}

export class Surface {
  constructor(scene) {
    this.scene = scene;
    this.frames = [];
    this.map = new THREE.DataTexture(new Uint8Array(4 * MAP_SIZE), MAP_SIZE, 1);
    this.map.minFilter = this.map.magFilter = THREE.LinearFilter;
    this.uniforms = {
      offsetA: { value: new THREE.Vector3() },
      offsetB: { value: new THREE.Vector3() },
      stepLength: { value: scene.step },
      share: { value: 0 },
      map: { value: this.map },
      plain: { value: new THREE.Color() },
      hasField: { value: false },
      opacity: { value: 1 },
    };
    this.geometry = new THREE.BufferGeometry();
    this.geometry.setIndex(new THREE.BufferAttribute(scene.faces, 1));
    this.paint = new THREE.BufferAttribute(new Uint8Array(4 * scene.vertices), 4, true);
    this.geometry.setAttribute("paint", this.paint);
    const parameters = { uniforms: this.uniforms, vertexShader: VERTEX_SHADER, fragmentShader: FRAGMENT_SHADER };
    this.mesh = new THREE.Mesh(
      this.geometry,
      new THREE.ShaderMaterial({ ...parameters, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }),
    );
    // under a clear surface: of several layers, the nearest one alone is blended
    this.depth = new THREE.Mesh(
      this.geometry,
      new THREE.ShaderMaterial({ ...parameters, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1, colorWrite: false }),
    );
    this.depth.visible = false;
    this.mesh.add(this.depth);
    this.wires = new THREE.Mesh(
      this.geometry,
      new THREE.ShaderMaterial({
        uniforms: { ...this.uniforms, ink: { value: new THREE.Color() } },
        vertexShader: VERTEX_SHADER,
        fragmentShader: "uniform vec3 ink; void main() { gl_FragColor = vec4(ink, 0.28); }",
        wireframe: true,
        transparent: true,
        depthWrite: false,
      }),
    );
    this.wires.visible = false;
    this.wires.renderOrder = 1;
    for (const mesh of [this.mesh, this.depth, this.wires]) mesh.frustumCulled = false; // three does not know where the shader puts it
    this.setTime(0);
  }

  frame(k) {
    if (this.frames[k] === undefined) {
      const numbers = this.scene.positions[k];
      this.frames[k] = {
        position: new THREE.BufferAttribute(numbers, VERTEX_STRIDE),
        normal: new THREE.BufferAttribute(normalsOf(numbers, this.scene.faces, this.scene.vertices), 2, true),
      };
    }
    return this.frames[k];
  }

  setTime(time) {
    const { from, to, share } = this.scene.interval(time);
    const a = this.frame(from), b = this.frame(to);
    this.geometry.setAttribute("positionA", a.position);
    this.geometry.setAttribute("positionB", b.position);
    this.geometry.setAttribute("normalA", a.normal);
    this.geometry.setAttribute("normalB", b.normal);
    // what wireframes and others ask for the number of vertices
    this.geometry.setAttribute("position", a.position);
    this.uniforms.offsetA.value.fromArray(this.scene.offset(from));
    this.uniforms.offsetB.value.fromArray(this.scene.offset(to));
    this.uniforms.share.value = share;
  }

  /** Shows the i-th field, or none if there is no such one. */
  setField(i) {
    const field = this.scene.fields[i];
    this.uniforms.hasField.value = field !== undefined;
    if (field === undefined) return;
    // above the top of the colours there is no other one
    const heights = Uint16Array.from({ length: 256 }, (_, level) => Math.round(65535 * Math.min(level / field.top_level, 1)));
    this.scene.positions.forEach((numbers, k) => {
      const values = field.values[k];
      for (let v = 0; v < values.length; ++v) numbers[VERTEX_STRIDE * v + 3] = heights[values[v]];
      if (this.frames[k] !== undefined) this.frames[k].position.needsUpdate = true;
    });
  }

  /** Marks the vertices that are painted, and those under the brush. */
  setPaint(painted, brushed) {
    this.paint.array.fill(0);
    for (const v of painted) this.paint.array[4 * v] = 255;
    for (const v of brushed) this.paint.array[4 * v + 1] = 255;
    this.paint.needsUpdate = true;
  }

  setOpacity(opacity) {
    this.uniforms.opacity.value = opacity;
    const isClear = opacity < 1;
    this.depth.visible = isClear;
    if (this.mesh.material.transparent === isClear) return;
    this.mesh.material.transparent = isClear;
    this.mesh.material.needsUpdate = true;
  }

  setMap(name) {
    this.map.image.data.set(mapBytes(name));
    this.map.needsUpdate = true;
  }

  setColors(plain, ink) {
    this.uniforms.plain.value.setStyle(plain);
    this.wires.material.uniforms.ink.value.setStyle(ink);
  }

  /** Where all vertices are at a time, in the stage's coordinates. */
  pointsAt(time) {
    if (this.points?.time === time) return this.points.points;
    const { from, to, share } = this.scene.interval(time);
    const a = this.scene.positions[from], b = this.scene.positions[to];
    const o = this.scene.offset(from), p = this.scene.offset(to), step = this.scene.step;
    const points = new Float32Array(3 * this.scene.vertices);
    for (let v = 0; v < this.scene.vertices; ++v)
      for (let c = 0; c < 3; ++c) {
        const x = o[c] + step * a[VERTEX_STRIDE * v + c], y = p[c] + step * b[VERTEX_STRIDE * v + c];
        points[3 * v + c] = x + share * (y - x);
      }
    this.points = { time, points };
    return points;
  }

  /** Where a ray meets the surface first: { distance, triangle, barycentric }; null if it does not. Linear in the triangles. */
  hit({ origin, direction }, time) {
    const points = this.pointsAt(time), faces = this.scene.faces;
    const { x: dx, y: dy, z: dz } = direction;
    let distance = Infinity, nearest = -1, second = 0, third = 0;
    for (let i = 0; i < faces.length; i += 3) {
      const a = 3 * faces[i], b = 3 * faces[i + 1], c = 3 * faces[i + 2];
      const ax = points[a], ay = points[a + 1], az = points[a + 2];
      const px = points[b] - ax, py = points[b + 1] - ay, pz = points[b + 2] - az;
      const qx = points[c] - ax, qy = points[c + 1] - ay, qz = points[c + 2] - az;
      const ox = origin.x - ax, oy = origin.y - ay, oz = origin.z - az;
      // Cramer's rule for origin + t direction = a + u p + v q
      const hx = dy * qz - dz * qy, hy = dz * qx - dx * qz, hz = dx * qy - dy * qx;
      const scale = px * hx + py * hy + pz * hz;
      const u = (ox * hx + oy * hy + oz * hz) / scale;
      if (!(u >= 0 && u <= 1)) continue;
      const kx = oy * pz - oz * py, ky = oz * px - ox * pz, kz = ox * py - oy * px;
      const v = (dx * kx + dy * ky + dz * kz) / scale;
      if (!(v >= 0 && u + v <= 1)) continue;
      const t = (qx * kx + qy * ky + qz * kz) / scale;
      if (t > 0 && t < distance) [distance, nearest, second, third] = [t, i, u, v];
    }
    if (nearest < 0) return null;
    return { distance, triangle: [...faces.subarray(nearest, nearest + 3)], barycentric: [1 - second - third, second, third] };
  }
}
