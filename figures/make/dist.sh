#!/usr/bin/env bash
# One archive of this commit, which builds without git, with the finished page, figures and maps in its folder
# `results`: dist.sh BUILD POINTS FORMAT. The same commit and results give the same bytes.
set -euo pipefail
build=$1 maps=$1/maps format=$3
[ "$2" = 400 ] || maps+=/$2
changed=$(git status --porcelain)
[ -z "$changed" ] || { printf 'make dist: these files differ from the commit:\n%s\n' "$changed" >&2; exit 1; }
name=rotor-$(sed -n 's/^version: //p' CITATION.cff)
folder=$build/dist/$name
rm -rf "$build/dist"
mkdir -p "$folder/results/figures" "$folder/results/maps"
git archive HEAD | tar -x -C "$folder"
cp "$build/report/index.html" "$build/report/claims.csv" "$folder/results"
cp "$build/figures"/*."$format" "$folder/results/figures"
cp "$maps"/*."$format" "$folder/results/maps"
tar --sort=name --owner=0 --group=0 --numeric-owner --mode=u+rw,go-w --mtime="@$(git show -s --format=%ct HEAD)" \
  -C "$build/dist" -c "$name" | gzip --no-name --best >"$build/$name.tar.gz.new"
mv "$build/$name.tar.gz.new" "$build/$name.tar.gz"
rm -r "$build/dist"
echo "$build/$name.tar.gz"
