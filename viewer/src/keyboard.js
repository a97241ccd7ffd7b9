// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Keyboard shortcuts, and the text that explains them.

/** Keys, what they do, and how; `isSingle`: not beside a second animation. `viewer` is what main.js gives. */
export function shortcuts(viewer) {
  const { state, player, stage, painter } = viewer;
  return [
    { keys: [" "], shown: "Space", text: "play or pause", run: () => player.toggle() },
    { keys: ["ArrowLeft"], shown: "←", text: "one frame back", run: () => player.step(-1) },
    { keys: ["ArrowRight"], shown: "→", text: "one frame on", run: () => player.step(1) },
    { keys: ["Home"], shown: "Home", text: "to the beginning", run: () => player.step(-Infinity) },
    { keys: ["End"], shown: "End", text: "to the end", run: () => player.step(Infinity) },
    { keys: ["["], shown: "[", text: "slower", run: () => player.faster(-1) },
    { keys: ["]"], shown: "]", text: "faster", run: () => player.faster(1) },
    { keys: ["ArrowUp", "p"], shown: "↑ p", text: "feature before, in the table's order", run: () => viewer.next(-1) },
    { keys: ["ArrowDown", "n"], shown: "↓ n", text: "next feature", run: () => viewer.next(1) },
    { keys: ["Enter", "f"], shown: "Enter f", text: "go close to the selected feature", run: () => viewer.approach() },
    { keys: ["r"], shown: "r", text: "show the whole body", run: () => stage?.resetView() },
    { keys: ["a", "d"], shown: "a d", text: "turn left, right", run: (key) => stage?.turn(key === "a" ? -0.2 : 0.2, 0) },
    { keys: ["w", "s"], shown: "w s", text: "turn up, down", run: (key) => stage?.turn(0, key === "w" ? 0.15 : -0.15) },
    { keys: ["+", "=", "-"], shown: "+ −", text: "closer, farther", run: (key) => stage?.zoom(key === "-" ? 1.15 : 1 / 1.15) },
    { keys: ["c"], shown: "c", text: "next field on the surface", run: () => viewer.nextField() },
    { keys: ["m"], shown: "m", text: "next colour map", run: () => viewer.nextMap() },
    { keys: ["x"], shown: "x", text: "features behind the surface", run: () => state.toggle("hidden") },
    { keys: ["e"], shown: "e", text: "edges of the mesh", run: () => state.toggle("wires") },
    { keys: ["v"], shown: "v", text: "follow the body", run: () => state.toggle("follow") },
    { keys: ["u"], shown: "u", text: "other axis up", run: () => state.set({ up: state.values.up === "y" ? "z" : "y" }) },
    { keys: ["t"], shown: "t", text: "light or dark", run: () => viewer.toggleTheme() },
    { keys: ["b"], isSingle: true, shown: "b", text: "paint, or be done with it", run: () => painter.toggle() },
    { keys: ["1", "2", "3"], isSingle: true, shown: "1 2 3", text: "painting: paint, erase, turn", run: (key) => painter.choose(Number(key) - 1) },
    { keys: [",", "."], isSingle: true, shown: ", .", text: "painting: smaller, larger brush", run: (key) => painter.resize(key === "," ? -1 : 1) },
    { keys: ["z", "y"], isSingle: true, shown: "z y", text: "painting: undo, redo", run: (key) => painter.back(key === "z" ? -1 : 1) },
    { keys: ["k"], shown: "k", text: "curve of the selected feature's vertex, or of none", run: () => viewer.probeSelected() },
    { keys: ["g"], shown: "g", text: "table: group by place", run: () => state.toggle("grouped") },
    { keys: ["l"], shown: "l", text: "ranks on the spheres", run: () => state.toggle("labels") },
    { keys: ["j"], shown: "j", text: "trajectory of the selected place", run: () => state.toggle("trail") },
    { keys: ["o"], shown: "o", text: "clearer surface, then opaque again", run: () => viewer.nextOpacity() },
    { keys: ["q"], isSingle: true, shown: "q", text: "measure between two points", run: () => viewer.measure.toggle() },
    { keys: ["i"], shown: "i", text: "save the picture", run: () => viewer.savePicture() },
    { keys: ["?", "h"], shown: "? h", text: "this help", run: () => viewer.toggleHelp() },
    { keys: ["Escape"], shown: "Esc", text: "select nothing", run: () => viewer.selectNone() },
  ];
}

/** Keys that a control in the focus needs for itself. */
function isTaken(target, key) {
  if (target.closest("dialog[open]")) return true;
  if (target.matches("select, textarea, input:not([type=range], [type=checkbox], [type=radio])")) return true;
  if (target.matches("input[type=radio]")) return key.startsWith("Arrow");
  if (target.matches("input[type=range]")) return key.startsWith("Arrow") || key === "Home" || key === "End";
  if (target.matches("button, input[type=checkbox], a, summary")) return key === " " || key === "Enter";
  return false;
}

export function listen(viewer, list) {
  const all = shortcuts(viewer).filter(({ isSingle }) => !isSingle || !viewer.companion);
  for (const { shown, text } of all) {
    const item = document.createElement("div");
    const term = document.createElement("dt");
    for (const key of shown.split(" ")) term.append(Object.assign(document.createElement("kbd"), { textContent: key }), " ");
    item.append(term, Object.assign(document.createElement("dd"), { textContent: text }));
    list.append(item);
  }
  document.addEventListener("keydown", (event) => {
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const isCommand = (event.ctrlKey || event.metaKey) && ["z", "y"].includes(key); // as everywhere
    if (((event.ctrlKey || event.metaKey) && !isCommand) || event.altKey || isTaken(event.target, event.key)) return;
    if (isCommand) {
      if (viewer.painter.back(key === "y" || event.shiftKey ? 1 : -1)) event.preventDefault();
      return;
    }
    const shortcut = all.find(({ keys }) => keys.includes(key));
    if (shortcut === undefined) return;
    event.preventDefault();
    shortcut.run(key);
  });
}
