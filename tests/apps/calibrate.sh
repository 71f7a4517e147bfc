#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# tamp calibrate finds parameters that are known, or says that the data cannot
# tell; killed and resumed, or on other threads, it leaves the same bytes.
# Usage: calibrate.sh TAMP adjusted|cells|law|die|die_cells|resume|refused
source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"
part=$2

# measure FOLDER SEED NOISE: a curve of tamp probe as a test rig gives it.
measure() {
  awk -F, -v seed="$2" -v noise="$3" '
    function normal() {
      return sqrt(-2 * log(1 - rand())) * cos(6.283185307 * rand())
    }
    BEGIN {
      srand(seed)
      print "relative_density[-],pressure[MPa],lateral_pressure[MPa]"
    }
    /^#/ { next }
    /^step/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
    {
      printf "%.6f,%.6g,%.6g\n", $column["relative_density[-]"],
        $column["stress_zz[Pa]"] / 1e6 * (1 + noise * normal()),
        $column["stress_xx[Pa]"] / 1e6 * (1 + noise * normal())
    }' "$1/curve.csv"
}

# result FOLDER NAME: a key result of a run, whatever its unit.
result() {
  local name=${2//[/\\[}
  sed -n "s|^ *\"$name\[[^]]*\]\": \([^,]*\),*\$|\1|p" "$1/run.json"
}

# told FOLDER PARAMETER TRUTH: within 10 %, or said to be not known.
told() {
  local name=$2
  awk -v best="$(result "$1" "$name best")" -v truth="$3" -v name="$name" \
    -v known="$(result "$1" "$name known within 10 %")" '
    BEGIN {
      off = best / truth - 1
      printf "%s: %.4g, off by %.1f %%, known: %s\n", name, best, 100 * off,
        known
      exit !(known == "" || best == "" || known == 1 && (off > 0.1 || off < -0.1))
    }' && fail "$1: $name is off by more than 10 %, and was said to be known"
  return 0
}

# near FOLDER PARAMETER TRUTH SHARE: not farther off than this share.
near() {
  awk -v best="$(result "$1" "$2 best")" -v truth="$3" -v share="$4" \
    'BEGIN { off = best / truth - 1; exit !(off < share && off > -share) }' ||
    fail "$1: $2 is farther off than $4"
}

cat > cell.prm << 'END_OF_INPUT'
include granules.prm
subsection Path
  set Stages = uniaxial to strain 0.25; unload to 10 % of peak
end
END_OF_INPUT
cat > law.prm << 'END_OF_INPUT'
subsection Material
  set Type = modified cam-clay
end
subsection Path
  set Stages = uniaxial to strain 0.5; unload to 10 % of peak
end
END_OF_INPUT
compression='Material/Modified Cam-Clay/Compression index'
yield='Material/Modified Cam-Clay/Initial yield pressure'

fit_law() {
  "$tamp" calibrate law.prm --data law.csv --fit "$compression = 0.2 .. 0.9" \
    --fit "$yield = 0.3 MPa .. 10 MPa" --no-plots -q "$@"
}

case $part in
  # Another packing than the one that gave the data; 2 % noise.
  cells)
    fit=(--fit 'Contact/Limiting contact pressure = 10 MPa .. 200 MPa'
      --fit 'Contact/Friction coefficient = 0.1 .. 0.9')
    "$tamp" probe cell.prm -o truth --no-plots -q --set 'Grains/Count = 400' \
      --set 'Packing/Seed = 9' --set 'Packing/Friction during packing = 0.3' \
      --set 'Contact/Limiting contact pressure = 80 MPa' \
      --set 'Contact/Friction coefficient = 0.4'
    for seed in 1 2 3; do
      measure truth "$seed" 0.02 > data.csv
      "$tamp" calibrate cell.prm --data data.csv "${fit[@]}" \
        --set 'Grains/Count = 100' -o "fit_$seed" --no-plots -q \
        --runs 21 --packings 4
      told "fit_$seed" 'Contact/Limiting contact pressure' 80e6
      told "fit_$seed" 'Contact/Friction coefficient' 0.4
      # Known or not, cells of 100 grains are this good: four times the errors
      # seen.
      near "fit_$seed" 'Contact/Limiting contact pressure' 80e6 0.12
      near "fit_$seed" 'Contact/Friction coefficient' 0.4 0.3
    done
    # The best run again, to the bit: its peak stress is that of curve.csv.
    "$tamp" probe fit_1/best.prm -o again --no-plots -q
    peak=$(awk -F, '!/^#/ && $1 == 0 { p = $3 } END { print p }' fit_1/curve.csv)
    grep -qF "$peak" again/run.json || fail "best.prm gives another peak"
    # Killed after 15 runs, and resumed on another number of threads.
    mkdir killed
    cp -r fit_3/{run.json,input.prm,log.txt,packings} killed
    awk '/^#/ || n++ < 16' fit_3/calibration.csv > killed/calibration.csv
    "$tamp" calibrate cell.prm --data data.csv "${fit[@]}" --threads 1 \
      --set 'Grains/Count = 100' -o killed --no-plots -q --runs 21 --packings 4 \
      --resume
    for file in calibration.csv best.prm curve.csv residuals.csv; do
      cmp fit_3/$file killed/$file
    done
    ;;
  # p_y over density, known in its two entries; another packing, 2 % noise.
  adjusted)
    pressures='Contact/Limiting contact pressures'
    adjusted=(--set 'Contact/Normal law = thornton-ning-adjusted'
      --set 'Contact/Densities of limiting contact pressures = 0.65, 0.8'
      --set 'Packing/Friction during packing = 0.3' --no-plots -q)
    said='no property of the grains and no prediction for other paths'
    "$tamp" probe cell.prm -o truth "${adjusted[@]}" \
      --set 'Packing/Seed = 9' --set 'Grains/Count = 120' \
      --set "$pressures = 20, 120 MPa"
    grep -q "$said" truth/summary.txt || fail 'summary.txt: no word of a fit'
    grep -q "$said" truth/log.txt || fail 'log.txt: no word of a fit'
    measure truth 1 0.02 > data.csv
    "$tamp" calibrate cell.prm --data data.csv -o fit "${adjusted[@]}" \
      --set "$pressures = 50, 50 MPa" --runs 15 --packings 3 \
      --fit "$pressures[1] = 5 MPa .. 100 MPa" \
      --fit "$pressures[2] = 20 MPa .. 400 MPa"
    told fit "$pressures[1]" 20e6
    told fit "$pressures[2]" 120e6
    near fit "$pressures[1]" 20e6 0.3
    near fit "$pressures[2]" 120e6 0.2
    grep -q "$said" fit/summary.txt || fail 'the fit is not labelled'
    grep -q "$said" fit/best.prm || fail 'best.prm is not labelled'
    grep -q 'set Limiting contact pressures *= [0-9.e+]*, [0-9.e+]* # \[Pa\]' \
      fit/best.prm || fail 'best.prm holds no list'
    "$tamp" probe fit/best.prm -o again --no-plots -q
    peak=$(awk -F, '!/^#/ && $1 == 0 { p = $3 } END { print p }' fit/curve.csv)
    grep -qF "$peak" again/run.json || fail "best.prm gives another peak"
    ;;
  law)
    "$tamp" probe law.prm -o truth --no-plots -q \
      --set "$compression = 0.5" --set "$yield = 2 MPa"
    for seed in 1 2 3; do
      measure truth "$seed" 0.02 > law.csv
      fit_law -o "fit_$seed"
      told "fit_$seed" "$compression" 0.5
      told "fit_$seed" "$yield" 2e6
      [ "$(result "fit_$seed" "$yield known within 10 %")" = 1.0 ] ||
        fail "with lateral pressure the data tell the yield pressure"
    done
    # A parameter that the curve does not feel.
    "$tamp" calibrate law.prm --data law.csv -o flat --no-plots -q \
      --set "$compression = 0.5" --set "$yield = 2 MPa" \
      --fit "Material/Modified Cam-Clay/Integration tolerance = 1e-6 .. 1e-5"
    grep -q 'the data cannot tell' flat/summary.txt ||
      fail 'nothing is said of a parameter that the data do not feel'
    # With plots, if there is a gnuplot.
    "$tamp" calibrate law.prm --data law.csv -o plots -q \
      --fit "$compression = 0.2 .. 0.9"
    has plots/{best.prm,calibration.csv,curve.csv,measured.csv,residuals.csv}
    has plots/{run.json,summary.txt,input.prm,log.txt}
    has plots/plots/{calibration,residuals,misfit,lateral}.gp
    ;;
  # A die with friction at its wall, which the transmission of force tells.
  die)
    cat > die.prm << 'END_OF_INPUT'
subsection Material
  set Type = modified cam-clay
end
subsection Die
  set Elements = 2, 3
end
subsection Schedule
  set Stages = press to density 0.5; unload to 10 % of peak
end
END_OF_INPUT
    "$tamp" die die.prm -o truth --no-plots -q --set "$yield = 2 MPa"
    "$tamp" calibrate die.prm --with die --data truth/curve.csv -o fit \
      --no-plots -q --fit "$yield = 0.5 MPa .. 8 MPa"
    told fit "$yield" 2e6
    ;;
  # A die of cells, whose runs all start from the same packings; killed in the
  # middle of a line and resumed it leaves the same bytes.
  die_cells)
    cat > die.prm << 'END_OF_INPUT'
include granules.prm
subsection Die
  set Elements = 1, 1
end
subsection Schedule
  set Stages = press to density 0.66; unload to 30 % of peak
end
END_OF_INPUT
    plastic='Contact/Limiting contact pressure'
    "$tamp" die die.prm -o truth --no-plots -q --set "$plastic = 80 MPa"
    fit_cells() {
      "$tamp" calibrate die.prm --with die --data truth/curve.csv --no-plots -q \
        --fit "$plastic = 20 MPa .. 200 MPa" --runs 9 "$@"
    }
    fit_cells -o fit --threads 2
    told fit "$plastic" 80e6
    near fit "$plastic" 80e6 0.3
    # The best run again, to the bit.
    "$tamp" die fit/best.prm -o again --no-plots -q
    peak=$(awk -F, '!/^#/ && $1 == 0 { p = $3 } END { print p }' fit/curve.csv)
    grep -qF "$peak" again/run.json || fail "best.prm gives another peak"
    mkdir killed
    cp -r fit/{run.json,input.prm,log.txt,packings} killed
    awk '/^#/ || n++ < 4 { print; next } { printf "%s", substr($0, 1, 30); exit }' \
      fit/calibration.csv > killed/calibration.csv
    fit_cells -o killed --threads 1 --resume
    for file in calibration.csv best.prm curve.csv residuals.csv; do
      cmp fit/$file killed/$file
    done
    grep -q 'going on after run 3' killed/log.txt ||
      fail 'the runs in the file were made again'
    # Data that its schedule does not reach.
    expect 3 'back to' 'the measured curve to' -- fit_cells -o short \
      --set 'Schedule/Stages = press to density 0.66; unload to 50 % of peak'
    ;;
  resume)
    "$tamp" probe law.prm -o truth --no-plots -q
    measure truth 1 0.02 > law.csv
    fit_law -o whole --threads 2
    fit_law -o again --threads 1
    cmp whole/calibration.csv again/calibration.csv
    # As if it was killed after 12 runs, in the middle of a line.
    mkdir killed
    cp whole/{run.json,input.prm,log.txt} killed
    awk '/^#/ || n++ < 13 { print; next } { printf "%s", substr($0, 1, 30); exit }' \
      whole/calibration.csv > killed/calibration.csv
    fit_law -o killed --resume
    for file in calibration.csv best.prm curve.csv measured.csv residuals.csv; do
      cmp whole/$file killed/$file
    done
    grep -q 'going on after run 12' killed/log.txt ||
      fail 'the runs in the file were made again'
    # And killed for good.
    fit_law -o stopped --threads 1 2> err.txt &
    run=$!
    until [ "$(grep -c '^[0-9]' stopped/calibration.csv 2> /dev/null)" -ge 3 ] \
      2> /dev/null; do
      kill -0 $run 2> /dev/null || break
      sleep 0.002
    done
    kill -KILL $run 2> /dev/null || true
    wait $run 2> /dev/null || true
    fit_law -o stopped --resume
    cmp whole/calibration.csv stopped/calibration.csv
    cmp whole/best.prm stopped/best.prm
    # Another input is refused, and nothing is touched.
    cp killed/run.json before.json
    expect 2 '--resume' 'another calibration' -- fit_law -o killed --resume \
      --set 'Material/Modified Cam-Clay/Swelling index = 0.1'
    expect 2 'run.json' -- fit_law -o nowhere --resume
    cmp before.json killed/run.json
    # A line that lacks values is named.
    awk '/^2,/ { $0 = "2,1" } 1' whole/calibration.csv > killed/calibration.csv
    expect 2 'calibration.csv:8: expected' -- fit_law -o killed --resume
    ;;
  refused)
    "$tamp" probe law.prm -o truth --no-plots -q
    measure truth 1 0 > law.csv
    try() {
      "$tamp" calibrate law.prm --data "${data:-law.csv}" -o never --no-plots -q \
        "$@"
    }
    expect 2 'LOW .. HIGH' -- try --fit "$yield = 3 MPa"
    expect 2 'lower bound first' -- try --fit "$yield = 3 MPa .. 2 MPa"
    expect 2 'named twice' -- try --fit "$yield = 1 MPa .. 2 MPa" \
      --fit "$yield = 1 MPa .. 2 MPa"
    expect 2 "did you mean 'Initial yield pressure'" -- \
      try --fit 'Material/Modified Cam-Clay/Initial yeild pressure = 1 .. 2'
    expect 2 'a pressure' -- try --fit "$yield = 1 mm .. 2 mm"
    expect 2 'cannot be fitted' -- \
      try --fit 'Packing/Pressure = 1 MPa .. 2 MPa'
    elastic="Material/Elastic/Young's modulus"
    expect 2 'is a list with 2 entries; expected one of them' -- \
      try --set "$elastic = 1, 2 GPa" --fit "$elastic = 1 GPa .. 2 GPa"
    expect 2 'expected one of its entries, [1] to [2]' -- \
      try --set "$elastic = 1, 2 GPa" --fit "$elastic[3] = 1 GPa .. 2 GPa"
    expect 2 'is no list of numbers' -- \
      try --fit "$yield[1] = 1 MPa .. 2 MPa"
    expect 2 '--fit' -- try --fit 'Grains/Count = 100 .. 200'
    expect 2 '--fit' -- try --fit 'Material/Type = 1 .. 2'
    data=no.csv expect 2 "there is no measured curve" -- \
      try --fit "$yield = 1 MPa .. 2 MPa"
    printf 'relative_density[-],pressure\n0.4,1\n' > bad.csv
    expect 2 'bad.csv:1: ' 'pressure[Pa]' -- \
      "$tamp" calibrate law.prm --data bad.csv -o never --no-plots \
      --fit "$yield = 1 MPa .. 2 MPa"
    [ ! -e never ] || fail 'something was written'
    # What the run reads is not overwritten.
    mkdir own
    cp truth/run.json own
    cp law.csv own/measured.csv
    expect 2 '--force would remove' -- "$tamp" calibrate law.prm \
      --data own/measured.csv -o own --force --fit "$yield = 1 MPa .. 2 MPa"
    cmp law.csv own/measured.csv
    ;;
  *) fail "no such part: $part" ;;
esac
exit $((failures > 0))
