// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A GLB scene as three.js reads and plays it. In the browser, bundled by the test.

import * as THREE from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";

window.readGlb = async (base64) => {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const gltf = await new GLTFLoader().parseAsync(bytes.buffer, "");
  const mixer = new THREE.AnimationMixer(gltf.scene);
  for (const clip of gltf.animations) {
    const action = mixer.clipAction(clip);
    action.setLoop(THREE.LoopOnce);
    action.clampWhenFinished = true;
    action.play();
  }
  let surface = null;
  const features = [];
  gltf.scene.traverse((node) => {
    if (node.isMesh && node.morphTargetInfluences) surface = node;
    if (node.userData.strength !== undefined) features.push(node);
  });
  window.glb = {
    duration: Math.max(...gltf.animations.map((clip) => clip.duration)),
    vertices: surface?.geometry.getAttribute("position").count,
    targets: surface?.morphTargetInfluences.length,
    features: features.map((node) => ({ name: node.name, ...node.userData })),

    /** The vertices of the surface, and place and size of the features, at a time. */
    at(time) {
      mixer.setTime(time);
      gltf.scene.updateMatrixWorld(true);
      const p = new THREE.Vector3(), points = [];
      for (let v = 0; v < this.vertices; ++v) points.push(...surface.getVertexPosition(v, p).applyMatrix4(surface.matrixWorld).toArray());
      const spheres = features.map((node) => ({
        place: node.getWorldPosition(new THREE.Vector3()).toArray(),
        size: node.scale.x, // not getWorldScale(), which gives 1 for nodes of no size
      }));
      return { points, spheres };
    },
  };
};
