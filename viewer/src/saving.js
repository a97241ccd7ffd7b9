// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Features as files: what the table lists, or the selected one. The columns and members are those that detect_features
// writes, so that whatever reads its files reads these.

const COORDINATES = ["x", "y", "z"];

/** Members of a feature in the order of the files. */
const MEMBERS = [
  "rank", "vertex", "frame", "time", "position", "sigma", "tau", "radius", "response", "amplitude", "fit", "strength",
  "place", "parent", "rest_position", "triangle", "barycentric_coordinates", "at_scale_limit", "file_vertices",
];

const HEADS = {
  position: COORDINATES,
  rest_position: COORDINATES.map((c) => `rest_${c}`),
  triangle: [0, 1, 2].map((i) => `triangle_${i}`),
  barycentric_coordinates: [0, 1, 2].map((i) => `barycentric_${i}`),
};

export function csvText(features) {
  const members = MEMBERS.filter((name) => features.some((f) => name in f));
  const cells = (f) => members.flatMap((name) => (name in HEADS ? f[name] : Array.isArray(f[name]) ? f[name].join(" ") : (f[name] ?? "")));
  const lines = [members.flatMap((name) => HEADS[name] ?? name), ...features.map(cells)];
  return lines.map((line) => `${line.join(",")}\n`).join("");
}

export function jsonText(features, scene, filter) {
  const { frames, frame_duration, bounding_box_diagonal, mean_edge_length = 0 } = scene;
  const animation = { vertices: scene.all_vertices, faces: scene.all_faces, frames, frame_duration, bounding_box_diagonal, mean_edge_length };
  const member = (f) => Object.fromEntries(MEMBERS.filter((name) => name in f).map((name) => [name, f[name]]));
  return `{"format": "animated-mesh-features", "version": 1,\n "animation": ${JSON.stringify(animation)},\n` +
    ` "parameters": ${JSON.stringify({ title: scene.title, selected_by: filter })},\n` +
    ` "features": [${features.map((f) => `\n  ${JSON.stringify(member(f))}`).join(",")}]}\n`;
}

/** A name for a file of this scene. */
export const fileName = (scene, what, ending) =>
  `${[scene.title || "animation", ...what].join("_").replace(/[^\p{L}\p{N}.-]+/gu, "_")}.${ending}`;

/** Lets the browser save something. */
export function save(name, content, type) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}
