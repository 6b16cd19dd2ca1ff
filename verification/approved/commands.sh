# Functions for the commands of the transcripts.
export LC_ALL=C

# Messages first, and then the output, whatever reads it.
rotor() {
  local output status=0
  output=$(mktemp)
  "$rotor" "$@" >"$output" || status=$?
  cat "$output"
  rm "$output"
  return $status
}

# Blanks the version, and numbers except those within names (q1_m) and after "paper" and "Fig.".
numbers() { sed -E 's/[0-9]+(\.[0-9]+){2}(-dev)? \([^)]+\)/(version)/;/^(paper|Fig\.)/!s/(^|[^A-Za-z0-9_.])[-+−]?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?([^A-Za-z0-9_]|$)/\1N\4/g'; }

# Writes a scene, or a sweep, and runs the program on it.
scene() { printf '%b\n' "$1" >scene.toml && shift && rotor run scene.toml "$@"; }
sweep() { printf '%b\n' "$1" >sweep.toml && shift && rotor sweep sweep.toml "$@"; }

# The texts of a picture in their order, without tic labels. Numbers of the paper are kept.
texts() {
  sed -n 's/<\/text>/\n/;s/^.*<text>//;s/<[^>]*>//g;s/&#160;/ /g;/\n/s/^\s*\([^\n]*\)\n.*/\1/p' "$1" |
    sed -E '/^[-−+0-9. ]*$/d;' | numbers | sed -E '/^(N(·N)?)?$/d' | uniq
}

# Draws a figure as make does: draw fig03.svg published corrected.
draw() {
  local svg=$1 data= set; shift
  for set; do data="$data data_$set = '$set/${svg%.svg}.csv';"; done
  "$sources"/figures/draw.sh $svg "$data" "$sources/figures/paper/${svg%.svg}.gp"
}

# A checkout with two figures on a simulated machine: Debian's base system with the packages in $packages.
checkout() {
  mkdir -p bin figures/paper
  for program in make bash sh awk sed expand uniq grep mkdir touch; do
    ln -s "$(unset -f make; command -v $program)" bin
  done
  printf '#!/bin/sh\nfor name; do case " $there " in *" $name "*) echo "ii $name";; esac; done\n' >bin/dpkg-query
  chmod +x bin/dpkg-query
  ln -s "$sources"/Makefile .
  cp -r "$sources"/figures/make figures
  touch figures/paper/fig03.toml figures/paper/fig04.toml
}
make() {
  said=$(env -i PATH="$PWD/bin" there="$packages" $exported make "$@" 2>&1) && failed= || failed=1
  echo "$said" | sed -E 's/Makefile:[0-9]+/Makefile/'
  [ -z "$failed" ]
}
