// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/paraview_script.h"

#include "rendering/Palette.h"
#include "scenes/append_xml_text.h"
#include "scenes/colour_scales.h"
#include "views/Scene_views.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace Programs {

namespace {

const char* const script = R"(#!/usr/bin/env pvpython
"""Shows this folder in ParaView 5.6 or later: the moving surface and its features as spheres.

    paraview --script=show_in_paraview.py             a window; press play
    pvpython show_in_paraview.py PICTURE.png [TIME]   a picture, at a time in seconds; without a display:
                                                      xvfb-run -a pvpython show_in_paraview.py PICTURE.png

Spheres have the radius sqrt(2) sigma and are coloured by tau, red for short and blue for long.
"""

import os
import sys

from paraview import simple as pv

FIELD = @FIELD@  # None: the surface has no field
FIELD_TOP = @FIELD_TOP@
FIELD_COLOURS = @FIELD_COLOURS@  # from 0 to the top, at equal distances: red, green, blue from 0 to 1
TAUS = @TAUS@  # the shortest and the longest, in seconds
TAU_COLOURS = @TAU_COLOURS@  # from the shortest to the longest, at equal ratios
STRONGEST_TIME = @STRONGEST_TIME@  # of the strongest feature
UP = @UP@  # the axis that points up: 0, 1 or 2


def folder():
    """Where this script is; some versions of ParaView do not say."""
    for place in (os.path.dirname(os.path.abspath(globals().get("__file__", "."))), os.getcwd()):
        if os.path.exists(os.path.join(place, "surface.pvd")):
            return place
    raise RuntimeError("surface.pvd is not beside this script; start ParaView in its folder")


def colour(display, array, values, colours):
    """Colours what is displayed by an array of its points: colours[i] at values[i]."""
    pv.ColorBy(display, ("POINTS", array))
    table = pv.GetColorTransferFunction(array)
    table.AutomaticRescaleRangeMode = "Never"
    table.RGBPoints = [x for value, rgb in zip(values, colours) for x in [value] + rgb]
    table.ColorSpace = "RGB"
    return table


def show_key(display, view, table, title):
    display.SetScalarBarVisibility(view, True)
    bar = pv.GetScalarBar(table, view)
    bar.Title = title
    bar.ComponentTitle = ""
    bar.RangeLabelFormat = "%.2g"


def look(view, surface):
    """At the broader side of the surface, a little from the left and from above."""
    bounds = surface.GetDataInformation().GetBounds()
    size = [bounds[2 * i + 1] - bounds[2 * i] for i in range(3)]
    across, along = sorted((i for i in range(3) if i != UP), key=lambda i: size[i])
    direction = [0, 0, 0]
    direction[across], direction[along], direction[UP] = 0.85, 0.45, 0.25
    middle = [(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)]
    view.CameraFocalPoint = middle
    view.CameraPosition = [m + 3 * sum(size) * d for m, d in zip(middle, direction)]
    view.CameraViewUp = [float(i == UP) for i in range(3)]
    view.ResetCamera()
    view.GetActiveCamera().Dolly(1.3)  # what is reset has wide margins


def show():
    view = pv.GetActiveViewOrCreate("RenderView")
    surface = pv.PVDReader(FileName=os.path.join(folder(), "surface.pvd"))
    pv.RenameSource("surface", surface)
    display = pv.Show(surface, view)
    if FIELD is not None:
        last = len(FIELD_COLOURS) - 1
        table = colour(display, FIELD, [FIELD_TOP * i / last for i in range(last + 1)], FIELD_COLOURS)
        show_key(display, view, table, FIELD)
    features = pv.PVDReader(FileName=os.path.join(folder(), "features.pvd"))
    pv.RenameSource("features", features)
    spheres = pv.Glyph(Input=features, GlyphType="Sphere")
    pv.RenameSource("spheres", spheres)
    spheres.GlyphType.Radius = 1
    spheres.GlyphType.ThetaResolution = spheres.GlyphType.PhiResolution = 24
    spheres.ScaleArray = ["POINTS", "radius"]
    spheres.OrientationArray = ["POINTS", "No orientation array"]
    spheres.ScaleFactor = 1
    spheres.GlyphMode = "All Points"
    display = pv.Show(spheres, view)
    display.Opacity = 0.5
    if TAUS is not None:
        last = len(TAU_COLOURS) - 1
        taus = [TAUS[0] * (TAUS[1] / TAUS[0]) ** (i / last) for i in range(last + 1)]
        show_key(display, view, colour(display, "tau", taus, TAU_COLOURS), "tau, in seconds")
    scene = pv.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = STRONGEST_TIME
    look(view, surface)
    return view, scene


def main():
    view, scene = show()
    # a window of ParaView has a view of its own, and no arguments
    if len(sys.argv) > 1 and sys.argv[1].endswith(".png"):
        if len(sys.argv) > 2:
            scene.AnimationTime = float(sys.argv[2])
        view.ViewSize = [1200, 900]
        pv.LoadPalette("WhiteBackground")
        pv.Render(view)
        pv.SaveScreenshot(sys.argv[1], view)
    else:
        pv.Render(view)


main()
)";

typedef std::vector<std::array<double, 3>> Colours;

Colours colour_samples(const Rendering::Colour_map& map)
{
  const std::size_t n = 17;
  Colours result;
  for (std::size_t i = 0; i < n; ++i) {
    const Rendering::Srgb8 c = Rendering::encoded(map(double(i) / double(n - 1)));
    result.push_back({{c[0] / 255., c[1] / 255., c[2] / 255.}});
  }
  return result;
}

// Numbers, lists and texts are written alike in Python and in JSON, in any locale.
std::string python(const nlohmann::json& value)
{
  return value.is_null() ? "None" : value.dump(-1, ' ', true);
}

nlohmann::json range_of_taus(const std::vector<Shown_feature>& features)
{
  double least = 0, most = 0;
  for (const Shown_feature& f : features) {
    if (!(f.tau > 0)) continue;
    least = least > 0 ? (std::min)(least, f.tau) : f.tau;
    most = (std::max)(most, f.tau);
  }
  if (!(least > 0)) return nullptr;
  if (least == most) return {least / 2, most * 2}; // a table of colours needs an extent
  return {least, most};
}

} // namespace

std::string paraview_script(const Shown_scene& scene)
{
  nlohmann::json field, top = 1.;
  if (!scene.fields.empty()) {
    field = xml_characters(scene.fields.front().name); // as the reader of surface.pvd finds it
    const double end = top_of_scale(*scene.fields.front().values);
    if (end > 0) top = end;
  }
  const double time = scene.features.empty() ? 0 : double(scene.features.front().frame) * scene.sequence.frame_duration();
  const std::vector<std::pair<std::string, std::string>> values = {
      {"@FIELD@", python(field)},
      {"@FIELD_TOP@", python(top)},
      {"@FIELD_COLOURS@", python(colour_samples(Rendering::field_colours()))},
      {"@TAUS@", python(range_of_taus(scene.features))},
      {"@TAU_COLOURS@", python(colour_samples(Rendering::duration_colours()))},
      {"@STRONGEST_TIME@", python(time)},
      {"@UP@", python(scene_up_axis(scene, std::nullopt))}};
  std::string text = script;
  for (const auto& value : values) text.replace(text.find(value.first), value.first.size(), value.second);
  return text;
}

} // namespace Programs
