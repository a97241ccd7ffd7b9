// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Features as spheres of glass on the surface.

import * as THREE from "three";

const VERTEX_SHADER = /* glsl */ `
  attribute vec4 place;  // centre and radius
  attribute vec4 tint;   // colour and opacity
  attribute float mark;  // 1: selected
  varying vec3 vNormal, vView;
  varying vec4 vTint;
  varying float vMark;

  void main() {
    vec4 view = modelViewMatrix * vec4(place.xyz + place.w * position, 1.0);
    vNormal = normalMatrix * position;
    vView = -view.xyz;
    vTint = tint;
    vMark = mark;
    gl_Position = projectionMatrix * view;
  }
`;

// Clear in the middle, so that the surface is seen, and full at the rim.
const FRAGMENT_SHADER = /* glsl */ `
  uniform float strength, marked;
  varying vec3 vNormal, vView;
  varying vec4 vTint;
  varying float vMark;

  void main() {
    vec3 n = normalize(vNormal), eye = normalize(vView);
    float facing = clamp(dot(n, eye), 0.0, 1.0);
    float rim = pow(1.0 - facing, 2.0);
    float shine = pow(max(dot(n, normalize(vec3(-0.43, 0.62, 0.66) + eye)), 0.0), 48.0);
    float edge = smoothstep(0.42, 0.34, facing) * vMark;
    float alpha = clamp(0.36 + 0.62 * rim + 0.5 * shine + 0.45 * edge, 0.0, 1.0);
    vec3 color = mix(vTint.rgb * (0.86 + 0.22 * n.y) + 0.55 * shine, vec3(1.0, 0.86, 0.25), edge);
    gl_FragColor = vec4(color, alpha * vTint.a * max(strength, marked * vMark));
  }
`;

/** Of what is behind the surface, this much is seen; of what is selected, more, and always. */
const SEEN_THROUGH = 0.3, SELECTED_THROUGH = 0.7;

export class Spheres {
  constructor(scene) {
    this.scene = scene;
    const n = Math.max(scene.features.length, 1);
    const ball = new THREE.SphereGeometry(1, 24, 14);
    this.geometry = new THREE.InstancedBufferGeometry();
    this.geometry.setIndex(ball.getIndex());
    this.geometry.setAttribute("position", ball.getAttribute("position"));
    this.place = new THREE.InstancedBufferAttribute(new Float32Array(4 * n), 4);
    this.tint = new THREE.InstancedBufferAttribute(new Float32Array(4 * n), 4);
    this.mark = new THREE.InstancedBufferAttribute(new Float32Array(n), 1);
    for (const [name, attribute] of Object.entries({ place: this.place, tint: this.tint, mark: this.mark })) {
      attribute.setUsage(THREE.DynamicDrawUsage);
      this.geometry.setAttribute(name, attribute);
    }
    this.group = new THREE.Group();
    this.hidden = this.layer(SEEN_THROUGH, SELECTED_THROUGH, THREE.GreaterDepth, 2);
    this.layer(1, 1, THREE.LessEqualDepth, 3);
    this.isThrough = true;
    this.shown = [];
  }

  layer(strength, marked, depthFunc, renderOrder) {
    const mesh = new THREE.Mesh(
      this.geometry,
      new THREE.ShaderMaterial({
        uniforms: { strength: { value: strength }, marked: { value: marked } },
        vertexShader: VERTEX_SHADER,
        fragmentShader: FRAGMENT_SHADER,
        transparent: true,
        depthWrite: false,
        depthFunc,
      }),
    );
    mesh.frustumCulled = false;
    mesh.renderOrder = renderOrder;
    this.group.add(mesh);
    return mesh;
  }

  /** Whether those behind the surface are seen, and how well through a surface of that opacity. */
  setThrough(isThrough, opacity) {
    this.isThrough = isThrough;
    this.hidden.material.uniforms.strength.value = isThrough ? Math.max(SEEN_THROUGH, 1 - opacity) : 0;
    this.hidden.material.uniforms.marked.value = Math.max(SELECTED_THROUGH, 1 - opacity);
  }

  /** Places the spheres that are seen at a time, the farthest first. */
  update(time, { shown, selected, features }, camera) {
    this.shown = [];
    this.scene.features.forEach((feature, index) => {
      if (!features) return;
      const opacity = this.scene.opacity(feature, time);
      if (!shown[index] || (opacity === 0 && index !== selected)) return;
      const centre = this.scene.place(feature, time).map((x, c) => x - this.scene.centre[c]);
      // what is selected stays in sight, however faint, while time goes on
      this.shown.push({ index, feature, centre: new THREE.Vector3(...centre), opacity: index === selected ? Math.max(opacity, 0.25) : opacity });
    });
    this.shown.sort((a, b) => b.centre.distanceToSquared(camera.position) - a.centre.distanceToSquared(camera.position));
    this.shown.forEach(({ index, feature, centre, opacity }, i) => {
      this.place.setXYZW(i, centre.x, centre.y, centre.z, feature.radius);
      this.tint.setXYZW(i, ...feature.color, opacity);
      this.mark.setX(i, index === selected ? 1 : 0);
    });
    for (const attribute of [this.place, this.tint, this.mark]) attribute.needsUpdate = true;
    this.geometry.instanceCount = this.shown.length;
    this.group.visible = this.shown.length > 0;
  }

  /**
   * The index of the feature under a ray, or -1. Of several, the one that is hit closest to its centre; those behind
   * the surface, which is `reach` away, only if there is no other.
   */
  pick(ray, reach) {
    let best = -1, least = Infinity;
    for (const { index, feature, centre } of this.shown) {
      const off = ray.distanceToPoint(centre) / feature.radius;
      if (off > 1) continue;
      const isBehind = centre.distanceTo(ray.origin) > reach + feature.radius;
      if (isBehind && !this.isThrough) continue;
      const cost = off + (isBehind ? 2 : 0);
      if (cost < least) {
        least = cost;
        best = index;
      }
    }
    return best;
  }
}
