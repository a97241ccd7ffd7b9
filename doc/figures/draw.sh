#!/usr/bin/env bash
# Runs the programs from which the figures are made, and draws them: the last step of the target `figures`.
#
# draw.sh PROGRAMS FIGURE_PROGRAMS FIGURES: the folders of detect_features and make_animation, of scale_data, measure_data,
# body_pictures and simplification_pictures, and of what is written.

set -euo pipefail

programs="$1"
figure_programs="$2"
figures="$3"
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)"

data="$(mktemp -d)"
trap 'rm -rf "$data"' EXIT
mkdir -p "$figures"

say() { printf '%s\n' "$*"; }
make() { "$programs/make_animation" "$@" > /dev/null; }
detect() { "$programs/detect_features" --quiet "$@"; }

say "features of the running figure"
make figure --vertices 30000 -o "$data/large"
detect "$data/large.obj" "$data/large.pc2" \
  --rest average --png "$figures/running_figure.png" --frame 12 --frame 18 --frame 24 --png-size 1600x720
make figure -o "$data/figure"
figure=("$data/figure.obj" "$data/figure.pc2" --rest average)
detect "${figure[@]}" -o "$data/figure.json"
detect "${figure[@]}" --threshold 1e9 --png "$figures/deformation.png" \
  --frame 6 --frame 9 --frame 12 --frame 15 --frame 18 --png-size 1280x380 --view 60,10
detect "${figure[@]}" --plot "$figures/plot.svg"
detect "${figure[@]}" --view-map "$figures/view_map.png"

say "the running figure with other parameters"
picture=(--frame 12 --png-size 300x350 --view 60,10)
detect "${figure[@]}" "${picture[@]}" --png "$data/default.png"
detect "${figure[@]}" "${picture[@]}" --png "$data/threshold.png" --threshold 0.5
detect "${figure[@]}" "${picture[@]}" --png "$data/alpha.png" --alpha 0
detect "${figure[@]}" "${picture[@]}" --png "$data/sigma.png" --sigma-range :4%
detect "${figure[@]}" "${picture[@]}" --png "$data/tau.png" --tau-range 0.08:
detect "${figure[@]}" "${picture[@]}" --png "$data/no_suppression.png" --no-suppression
for preset in calibrated published; do
  detect "${figure[@]}" --frame 12 --png-size 420x420 --view 60,10 --png "$data/$preset.png" --preset "$preset"
done

say "the bending cylinder"
make cylinder -o "$data/cylinder"
detect "$data/cylinder.obj" "$data/cylinder.pc2" --rest "$data/cylinder.obj" \
  --png "$figures/bending_cylinder.png" --png-size 1600x620
for rate in 15 30 60 120; do
  make cylinder --fps "$rate" -o "$data/rate"
  for preset in calibrated published; do
    detect "$data/rate.obj" "$data/rate.pc2" --fps "$rate" --rest "$data/rate.obj" --preset "$preset" \
      -o "$data/rate_${preset}_$rate.json"
  done
  detect "$data/rate.obj" "$data/rate.pc2" --fps "$rate" --rest "$data/rate.obj" --tau-range 0.0333333:0.333333 \
    -o "$data/rate_range_$rate.json"
done

say "numbers and pictures"
"$figure_programs/scale_data" "$data"
"$figure_programs/measure_data" "$data"
"$figure_programs/body_pictures" "$figures"
"$figure_programs/simplification_pictures" "$figures/simplification.png"

say "drawings"
PYTHONDONTWRITEBYTECODE=1 python3 "$here/draw_figures.py" "$data" "$figures"
say "written to $figures"
