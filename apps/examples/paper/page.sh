#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Writes the page to stdout, in the folder with trends.csv, reference.csv,
# states.csv and figures. Usage: page.sh
set -euo pipefail
home=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

# figure N TITLE PAPER HERE: what the paper says, what is done here.
figure() {
  local file
  file=$(printf 'fig%02d.png' "$1")
  printf '\n### Figure %d: %s\n\nThe paper: %s\n\nHere: %s\n' "$@"
  [ ! -s "$file" ] || printf '\n![figure %d](%s)\n' "$1" "$file"
  trends "$1"
}
# trends N: the tested trends of figure N, all without N.
trends() {
  awk -F'|' -v figure="${1:-}" '
    FNR == NR {
      split($0, t, ",")
      number[t[1]] = number[t[1]] " " t[3] (t[4] ? "" : " **no**") " |"
      ++count[t[1]]
      holds[t[1]] += t[4]
      packings = count[t[1]] > packings ? count[t[1]] : packings
      next
    }
    count[$1] && (figure == "" || $2 == figure) {
      if (!begun++) {
        printf "\n| trend | the paper says | number | must be |"
        for (k = 1; k <= packings; ++k)
          printf " packing %d |", k
        printf " holds for |\n|---|---|---|---|"
        for (k = 1; k <= packings; ++k)
          printf "---|"
        print "---|"
      }
      printf "| %s | %s | %s | %s |%s %d of %d |\n", $1, $3, $4, $5,
             number[$1], holds[$1], count[$1]
    }' trends.csv "$home/trends.txt"
}
# The trends that do not hold for all packings, with the reason; one without a
# known reason says so.
reasons() {
  awk -F'|' '
    FILENAME == "trends.csv" {
      split($0, t, ",")
      count[t[1]] += 1
      holds[t[1]] += t[4]
      next
    }
    FILENAME ~ /reasons.txt$/ { reason[$1] = $2; next }
    count[$1] > holds[$1] {
      printf "- %s, %s (%d of %d packings): %s\n", $1, $3, holds[$1],
             count[$1], $1 in reason ? reason[$1] : "no reason is known."
    }' trends.csv "$home/reasons.txt" "$home/trends.txt"
}
# Of the packings of figures 2 to 9.
densities() {
  awk -F, '
    $1 ~ /^(mu|py)/ && $4 == "start" {
      if (!($1 in line))
        order[++runs] = $1
      line[$1] = line[$1] sprintf(" %.4f |", $9)
      ++count[$1]
    }
    END {
      printf "| run |"
      for (k = 1; k <= count[order[1]]; ++k)
        printf " packing %d |", k
      printf "\n|---|"
      for (k = 1; k <= count[order[1]]; ++k)
        printf "---|"
      for (r = 1; r <= runs; ++r)
        printf "\n| %s |%s", order[r], line[order[r]]
      print ""
    }' states.csv
}
# What a line of reference.csv is of, for the next two.
of_line='
  function unit() { return $3 == "axial" ? 1e-6 : 1 }
  function what(    place) {
    place = $2
    sub(/loading start 0/, "100 kPa", place)
    sub(/loading strain/, "strain", place)
    sub(/unloading share 0.02/, "unloaded to 2 %", place)
    return $1 " | " place " | " \
           ($3 == "axial" ? "axial stress [MPa]" : $3) " | " \
           sprintf("%.4g ± %s", $4 * unit(),
                   $6 == "relative" ? $5 * 100 " %" : $5)
  }
  function sign(good) { return good ? "" : " **no**" }'
reference() {
  awk -F, "$of_line"'
    NR == 2 {
      print "| run | at | quantity | other code | equilibria: mean |" \
            " smallest to largest | dynamics: mean | smallest to largest |" \
            " t |"
      print "|---|---|---|---|---|---|---|---|---|"
    }
    NR > 1 {
      s = unit()
      printf "| %s | %.4g%s | %.4g to %.4g |", what(), $9 * s, sign($10),
             $11 * s, $12 * s
      if ($14 == "")
        print " | | |"
      else
        printf " %.4g%s | %.4g to %.4g | %s |\n", $14 * s, sign($15), \
               $16 * s, $17 * s, $18
    }' reference.csv
}
# The means that are outside.
outside() {
  awk -F, "$of_line"'
    NR > 1 && ($10 == "0" || $15 == "0") {
      if (!begun++) {
        print "\n| run | at | quantity | other code | equilibria | dynamics |" \
              " t | at its density |"
        print "|---|---|---|---|---|---|---|---|"
      }
      s = unit()
      printf "| %s | %.4g%s | %s | %s | %s |\n", what(), $9 * s, sign($10), \
             $14 == "" ? "" : sprintf("%.4g%s", $14 * s, sign($15)), $18, \
             $19 == "" ? "" : sprintf("%.4g%s", $19 * s, sign($20))
    }' reference.csv
}
# plastic RUN: its mean share of plastic contacts at 100 kPa.
plastic() {
  awk -F, -v run="$1" '
    $1 == run && $4 == "start" { n += 1; sum += $14 / $13 }
    END { printf n ? "%.3f" : "not run", n ? sum / n : 0 }' states.csv
}
# within COLUMN: how many of how many.
within() {
  awk -F, -v column="$1" '
    NR > 1 && $column != "" {
      ++n
      good += $column
    }
    END { printf "%d of %d", good, n }' reference.csv
}
# literal COLUMN FORMAT PLACE...: of the run of Table I to the letter.
literal() {
  awk -F, -v column="$1" -v form="$2" -v place="$3 $4 $5" '
    $1 == "literal" && $3 " " $4 " " $5 == place {
      printf form, $column
      exit
    }' \
    states.csv
}

failed=$(awk -F, '!$4 { print $1 }' trends.csv | sort -u | tr '\n' ' ')
cat << END
# Sheng et al. (2004), figure by figure

Y. Sheng, C. J. Lawrence, B. J. Briscoe, C. Thornton: Numerical studies of uniaxial powder compaction process by 3D DEM,
Engineering Computations 21 (2004). Loading and unloading of periodic cells of grains by the quasi-static map; packings: $packings; bands are those of
all packings, lines their means. Table I with E = 70 GPa, see below. Figures 4, 5, 7 and 9 are for mu = 0.3.

Trends are tested by \`trends.awk\`, for each packing by itself: $(awk -F, '{ n += $4 } END { print n " of " NR }' trends.csv) hold.
Not for all packings: ${failed:-none}.

## Figures
END

while IFS="|" read -r number title paper here; do
  figure "$number" "$title" "$paper" "$here"
done < "$home/figures.txt"

cat << END

## All trends
END
trends
cat << END

## What does not hold, and why

END
reasons
cat << END

Relative density at 100 kPa, by packing:

END
densities
cat << END

## Against an independent code

Same grains, packed to 100 kPa and pressed by slow damped dynamics, one sample a case (mu0.3: mean of two). ref_packed: mu = 0.9, packed with 0.3; ref_py1:
p_y = 1 GPa; ref_elastic: no yield; both mu = 0.3. Strains are engineering strains; \`recovered\` is the strain given back from 15 % (elastic: 10 %). Here twice:
through equilibria, as in all figures above, and by dynamics as that code has it, as far as it is told: from a loose random start of 0.35 under a servo, then
1e-6 of strain in a time step of a quarter of Rayleigh's, with no damping but 0.3 of each force. t: the mean of all packings here less that of the other code, over the
deviation that this difference should have if single samples of the other code scatter as those here.

Within the tolerance: $(within 10) means through equilibria, $(within 15) by dynamics.

$(reference)

Means outside the tolerance:
$(outside)

Why they differ:

- Plastic shares at 100 kPa, p_y = 1 GPa: $(plastic ref_py1) through equilibria, into which grains creep; by dynamics they hit each other, and a contact that has yielded stays so:
  $(plastic packed1.1e-5) at 2e-7 of strain in a time step, $(plastic packed2.2e-5) at 4e-7, $(plastic dyn_py1) at 1e-6, $(plastic packed5.5e-4) at 1e-5. The 0.34 of the other code, which does not tell how fast it packs, is between. With p_y = 0.5 GPa and mu of
  0.3, 0.6 and 0.9: $(plastic ref_mu0.3), $(plastic ref_mu0.6) and $(plastic ref_mu0.9) through equilibria, $(plastic dyn_mu0.3), $(plastic dyn_mu0.6) and $(plastic dyn_mu0.9) by dynamics, 0.95, 0.97 and 0.97 there.
- The packings without yield are looser than the sample of the other code, and stress grows fast with density. With mu of 0.26 instead of 0.3 while they are packed some are
  as dense or denser; the last column is on the line through all nine, over density, at the density of that sample.
- At a strain of 1 % the lateral share of single packings scatters as much as the tolerance allows.

## What cannot be compared

- The figures carry no numbers in the text that we have: only what it says of them is tested.
- Table I is inconsistent as printed. A cell of 0.3 mm would hold $(awk 'BEGIN { printf "%.0f", 1000 * 3.14159265 / 6 * 0.2^3 / 0.3^3 }') times its volume of grains; one of 3 mm is a gas of relative density
  0.155, which packing to 100 kPa closes in any case. Its E of 70 MPa cannot yield at p_y = 0.5 GPa: the overlap would be 417 radii. We take 70 GPa.
- The time step of equation (6) for its example (E = 70 MPa, diameter 10 µm) is 0.168 µs, the text says about 1 µs. The scaling number names R_min a diameter;
  here it is the smallest radius.
- Friction: only the ends, 0.3 and 0.9, of four values are named; neither is the mu of figures 4, 5, 7 and 9, nor the greatest stress.
- Diameters of 136 to 280 µm with a mean of 200 µm are not uniform; here they are uniform from 136 to 264 µm, which have that mean.
- Figures 10 and 11: p_y and mu were adjusted during the run in a way that is not told, to fit a measurement that is not in the text. With constant values the
  curve misses stage III (Q7b), and with p_y raised over density how much of one there is follows from the table chosen (Q7g); as pressure is proportional to p_y (Q7e), p_y from 20 to 200 MPa moves it by a factor of ten, which is room enough
  for any curve in between. Equation (11) is lost in the scan.

### Table I to the letter

\`table1_literal.prm\`, E = 70 MPa: relative density $(literal 9 %.3f loading start 0) at 100 kPa; $(literal 14 %d unloading peak 1) of $(literal 13 %d unloading peak 1) contacts are plastic at 1 MPa (strain $(literal 6 %.3g unloading peak 1)), and unloading to the
100 kPa at which it began leaves $(literal 6 %.3g unloading share 0.1). Without plastic contacts there is nothing to draw in figures 8 and 9; what strain stays is due to friction alone.
END
