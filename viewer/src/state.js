// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the page shows at the moment. Whoever wants to know of changes subscribes.

export class State {
  constructor(values) {
    this.values = values;
    this.listeners = [];
  }

  subscribe(listener) {
    this.listeners.push(listener);
  }

  /** Takes over values; tells the listeners those that are different from before. */
  set(values) {
    const changed = {};
    for (const [name, value] of Object.entries(values))
      if (this.values[name] !== value) changed[name] = this.values[name] = value;
    if (Object.keys(changed).length > 0) for (const listener of this.listeners) listener(changed);
  }

  toggle(name) {
    this.set({ [name]: !this.values[name] });
  }
}
