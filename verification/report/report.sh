#!/usr/bin/env bash
# What `make report` does once everything is built and drawn: gathers what stands beside the page, and
# writes it. `report.sh BUILD archive` leaves out what differs from machine to machine.
set -euo pipefail
build=$1
report=$build/report
mkdir -p "$report/figures/published" "$report/figures/consistent"
cp -p "$build"/figures/fig*.{csv,svg} "$report/figures/published"
cp -p "$build"/figures/consistent/fig*.{csv,svg} "$report/figures/consistent"
"$build/rotor" run --scene verification/report/accident.toml --rows 1201 --from 29.095 \
  --trace "$report/accident.csv" >"$report/accident.txt"
"$build/report-numbers" "$report" reference-data reference-data/assumptions.csv "$report/claims.csv" \
  >"$report/claims.txt" || true # verdicts that are not expected: `make verify` says which, and fails
for study in maps work-precision:bench stability:stress-results; do
  from=$build/${study#*:} to=$report/${study%:*}
  rm -rf "$to"
  if compgen -G "$from/*.svg" >/dev/null; then
    mkdir -p "$to"
    cp -p "$from"/*.svg "$from"/*.csv "$to"
  fi
done
(cd "$report" && sha256sum claims.csv accident.csv figures/*/*.csv >SHA256SUMS)
commit=$(git rev-parse HEAD 2>/dev/null || echo unknown)
date=$(git show -s --format=%cs HEAD 2>/dev/null || echo unknown)
[ -z "$(git status --porcelain 2>/dev/null)" ] || commit="$commit with changes"
"$build/report-page" . "$build" "$commit" "$date" "${2:-this-machine}"
echo "$report/index.html"
