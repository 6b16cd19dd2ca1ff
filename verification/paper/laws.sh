#!/bin/sh
# Compares the runs of laws.toml and region.toml with the laws: laws.sh LAWS.csv [REGION.csv] prints reference-data/laws.csv
set -e
export LC_ALL=C
cat <<'HEAD'
# The accuracy of the laws of model/theory on the random rotors of verification/paper/laws.toml, from `make laws`; not from the
# paper. share: of the unbalance, kappa e_x1/(mu r), from and up to; rolling_speed, peak_force: the run's value over the
# law's, of runs that roll; other quantities: whether the run ends as the law predicts; agree: share within 10 %, or that does.
# speed_deficit: (1 - the ratio of rolling speeds)/share; agree: share of the runs that lose more speed than the law says.
# trusted_...: rotors of region.toml in the tested region, by the outcome predicted; agree: share with this outcome, and speed
# and force within 10 %. rolling_is_trusted: of the rotors of region.toml that roll, the share in the region. trusted_worst_box: the
# trusted rotors predicted to roll in that box with the least share, of boxes with at least 200 of them. A box bounds two quantities by
# thirds of their ranges on a logarithmic scale, numbered from 0; the column boxes has their number and the worst one.
equations,quantity,share_from,share_to,runs,q05,q25,median,q75,q95,agree,boxes
HEAD
# A text in quotes may have commas.
cat "$@" | sed '/^#/d; s/"[^"]*"/-/g' | awk -F, '
  $1 ~ /^equations/ { delete column; for (i = 1; i <= NF; ++i) { column[$i] = i; heading[i] = $i }; next }
  function of(name) { return $column[name] }
  function row(quantity, from, to, ratio) { printf "%s,%s,%s,%s,%s\n", $1, quantity, from, to, ratio }
  function near(run, law) { return of(run) >= 0.9*of(law) && of(run) <= 1.1*of(law) }
  of("refusal") != "" { next }
  "law_trusted" in column {
    for (i = 2; i < column["outcome"]; ++i) {
      if (!(i in least) || $i < least[i]) least[i] = $i
      if (!(i in largest) || $i > largest[i]) largest[i] = $i
    }
    if (of("law_trusted") == "true") {
      right = of("outcome") == of("law_outcome") && (of("outcome") != "rolling" ||
        near("rolling_onset_speed_Hz", "law_rolling_speed_Hz") && near("peak_force_to_rolling_N", "law_peak_force_N"))
      row("trusted_" of("law_outcome"), "", "", right)
      if (of("law_outcome") == "rolling") { trusted[++n] = $0; is_right[n] = right }
    }
    if (of("outcome") == "rolling") row("rolling_is_trusted", "", "", of("law_trusted") == "true")
    next
  }
  {
    touches = of("touch_downs_to_rolling") > 0
    row("touches", "", "", touches == (of("law_contact_after_loss_s") != ""))
    rolls = of("outcome") == "rolling"
    if (of("law_outcome") == "rolling") row("rolls_above_both_frictions", "", "", rolls)
    whirl = of("law_whirl_friction")
    if (touches && whirl != "" && of("friction") < whirl) row("rolls_below_the_whirl_friction", "", "", rolls)
    if (touches && whirl != "" && of("friction") < whirl/3) row("rolls_below_a_third_of_the_whirl_friction", "", "", rolls)
    if (!rolls || of("law_rolling_speed_Hz") == "") next
    share = of("law_unbalance_share")
    from = share < 0.03 ? 0 : share < 0.1 ? 0.03 : share < 0.3 ? 0.1 : 0.3
    to = share < 0.03 ? 0.03 : share < 0.1 ? 0.1 : share < 0.3 ? 0.3 : ""
    speed = of("rolling_onset_speed_Hz")/of("law_rolling_speed_Hz")
    force = of("peak_force_to_rolling_N")/of("law_peak_force_N")
    row("rolling_speed", from, to, speed); row("peak_force", from, to, force)
    if (share >= 0.1) row("speed_deficit", 0.1, "", (1 - speed)/share)
    row("rolling_speed", 0, "", speed); row("peak_force", 0, "", force)
  }
  END {
    for (k = 1; k <= n; ++k) {
      split(trusted[k], value)
      for (i in least) third[i] = int(2.999999*log(value[i]/least[i])/log(largest[i]/least[i]))
      for (i in least) for (j in least) if (i < j)
        for (a = 0; a <= third[i]; ++a) for (b = third[i]; b < 3; ++b)
          for (c = 0; c <= third[j]; ++c) for (d = third[j]; d < 3; ++d) {
            box = value[1] "," i " " a " " b " " j " " c " " d
            ++rotors[box]; good[box] += is_right[k]
          }
    }
    for (box in rotors) if (rotors[box] >= 200) {
      equations = substr(box, 1, index(box, ",") - 1); ++boxes[equations]
      if (!(equations in worst)) worst[equations] = box
      share = good[box]/rotors[box] - good[worst[equations]]/rotors[worst[equations]]
      if (share < 0 || share == 0 && box < worst[equations]) worst[equations] = box
    }
    for (equations in worst) {
      split(substr(worst[equations], length(equations) + 2), side, " ")
      text = sprintf("%d: %s %d to %d; %s %d to %d", boxes[equations], heading[side[1]], side[2], side[3], heading[side[4]], side[5], side[6])
      for (k = 1; k <= rotors[worst[equations]]; ++k)
        printf "%s,trusted_worst_box,,,%d,%s\n", equations, k <= good[worst[equations]], text
    }
  }' | sort -t, -k1,1 -k2,2 -k3,3g -k4,4 -k5,5g | awk -F, '
  function quantile(share) { return sprintf("%.3f", ratio[1 + int(share*(n - 1) + 0.5)]) }
  function print_row() {
    if (!n) return
    printf "%s,%d,", key, n
    if (key ~ /,(rolling_speed|peak_force|speed_deficit),/)
      printf "%s,%s,%s,%s,%s,", quantile(0.05), quantile(0.25), quantile(0.5), quantile(0.75), quantile(0.95)
    else
      printf ",,,,,"
    printf "%.4f,%s\n", good/n, boxes
  }
  { of = $1 "," $2 "," $3 "," $4 }
  of != key { print_row(); key = of; boxes = $6; n = good = 0 }
  { ratio[++n] = $5; good += $2 == "speed_deficit" ? $5 > 0 : $5 >= 0.9 && $5 <= 1.1 }
  END { print_row() }'
