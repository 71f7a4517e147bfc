# SPDX-License-Identifier: BSD-3-Clause
# Figures 1 to 12 from data/. Needs of_friction, of_limit, of_granules,
# of_cells (those of them that are cells) and packings, lists of names. A band is
# that of all packings, the line their mean.
set terminal pngcairo size 640,460 enhanced font "Sans,11"
set grid lc rgb "#dddddd"
set style fill transparent solid 0.25 noborder
set datafile missing "NaN"
array colour[6] = [0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0x56b4e9, 0x000000]
MPa = 1e-6

title_of(name) = \
  name[1:2] eq "mu" ? "{/Symbol m} = ".name[3:*] : \
  name eq "py1" ? "p_y = 1 GPa" : \
  name eq "die" ? "p_y = 50 MPa, die with walls" : \
  name eq "granules_mdr" ? "p_y = 50 MPa, law mdr" : \
  name[1:8] eq "granules" ? "p_y = ".name[9:*]." MPa" : name
title_of_limit(name) = name eq "mu0.3" ? "p_y = 0.5 GPa" : title_of(name)
data(figure, name) = "data/".figure."_".name.".dat"

if (system("ls data/scaling_?.csv 2> /dev/null") ne "") {
  set output "fig01.png"
  set logscale xy
  set format x "10^{%L}"
  set xlabel "scaling number (strain rate^2 density R_{min}^2 / p_y)^{1/2}"
  set ylabel "axial stress at a strain of 10 % [MPa]"
  set yrange [14:40]
  set ytics (15, 20, 25, 30, 35, 40)
  set key top left
  set datafile separator comma
  plot for [p in packings] "data/scaling_".p.".csv" using 2:($5 * MPa) \
    with linespoints pt 7 ps 0.7 title "packing ".p
  set datafile separator whitespace
  unset logscale
  set format x
  set yrange [*:*]
  set ytics auto
}

# Bands first, lines on top.
do for [pair in "fig02:of_friction fig04:of_limit"] {
  figure = pair[1:5]
  runs = figure eq "fig02" ? of_friction : of_limit
  set output figure.".png"
  set key top left
  set xlabel "axial strain (engineering) [-]"
  set ylabel "axial stress [MPa]"
  plot for [k=1:words(runs)] data(figure, word(runs, k)) index 0 \
      using 1:($2 * MPa) with filledcurves closed lc rgb colour[k] notitle, \
    for [k=1:words(runs)] data(figure, word(runs, k)) index 1 \
      using 1:($2 * MPa) with lines lw 2 lc rgb colour[k] \
      title (figure eq "fig02" ? title_of(word(runs, k)) \
                               : title_of_limit(word(runs, k)))
}
do for [figure in "fig03 fig05"] {
  runs = figure eq "fig03" ? of_friction : of_limit
  set output figure.".png"
  set key top left
  set xlabel "axial stress [MPa]"
  set ylabel "lateral stress [MPa]"
  plot for [k=1:words(runs)] data(figure, word(runs, k)) index 0 \
      using ($1 * MPa):($2 * MPa) with filledcurves closed \
      lc rgb colour[k] notitle, \
    for [k=1:words(runs)] data(figure, word(runs, k)) index 1 \
      using ($1 * MPa):($2 * MPa) with lines lw 2 lc rgb colour[k] \
      title (figure eq "fig03" ? title_of(word(runs, k)) \
                               : title_of_limit(word(runs, k)))
}
do for [figure in "fig06 fig07 fig08 fig09"] {
  of_mu = figure eq "fig06" || figure eq "fig08"
  runs = of_mu ? of_friction : of_limit
  set output figure.".png"
  set key top left
  set xlabel "axial strain (engineering) [-]"
  set ylabel (figure eq "fig06" || figure eq "fig07" \
    ? "mechanical coordination number Z_m [-]" : "plastic contacts [-]")
  plot for [k=1:words(runs)] data(figure, word(runs, k)) index 0 \
      using 1:2 with filledcurves closed lc rgb colour[k] notitle, \
    for [k=1:words(runs)] data(figure, word(runs, k)) index 1 \
      using 1:2 with lines lw 2 lc rgb colour[k] \
      title (of_mu ? title_of(word(runs, k)) : title_of_limit(word(runs, k)))
}

runs = of_granules
set key top right
set xlabel "pressure [MPa]"
set xrange [0:*]
set ylabel "void ratio [-]"
set output "fig10.png"
plot for [k=1:words(runs)] data("fig10", word(runs, k)) index 0 \
    using ($1 * MPa):2 with filledcurves closed lc rgb colour[k] notitle, \
  for [k=1:words(runs)] data("fig10", word(runs, k)) index 1 \
    using ($1 * MPa):2 with lines lw 2 lc rgb colour[k] \
    title title_of(word(runs, k))

# Loading only, on a logarithmic axis: densification before the first load is
# off to the left.
set key top left
set ylabel "relative density [-]"
set logscale x
set xrange [0.01:60]
set yrange [0.35:0.95]
set output "fig11.png"
loading = "awk 'NF == 0 { ++block; next } \
  block >= 2 && $1 > last { last = $1; print }' "
set arrow 1 from 0.0115,0.359 to 0.0115,0.555 lw 2
set label 1 "stage I: from 0.359\nwithout load" at 0.014,0.44
plot for [k=1:words(runs)] "< ".loading.data("fig11", word(runs, k)) \
    using ($1 * MPa):2 with lines lw 2 lc rgb colour[k] \
    title title_of(word(runs, k))
unset arrow 1
unset label 1
unset logscale x
set xrange [0:*]
set yrange [*:*]

# What finite elements write has no coordination number.
set key bottom right
set ylabel "mechanical coordination number Z_m [-]"
set output "fig12.png"
runs = of_cells
plot for [k=1:words(runs)] data("fig12", word(runs, k)) index 0 \
    using ($1 * MPa):2 with filledcurves closed lc rgb colour[k] notitle, \
  for [k=1:words(runs)] data("fig12", word(runs, k)) index 1 \
    using ($1 * MPa):2 with lines lw 2 lc rgb colour[k] \
    title title_of(word(runs, k))
