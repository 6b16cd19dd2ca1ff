# What the commands of the transcripts have besides the shell's own.

rotor() { "$rotor" "$@"; }

# Blanks numbers, except those within names (q1_m) and options (--until 3).
numbers() { sed -E 's/(^|[^A-Za-z0-9_.])[-+−]?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?([^A-Za-z0-9_]|$)/\1N\4/g'; }

# A checkout with two figures and two maps, on a machine of its own: Debian's base system, and the
# packages that $packages names.
checkout() {
  mkdir -p bin figures/paper figures/maps
  for program in make bash sh awk sed tail grep mkdir test touch id; do
    ln -s "$(unset -f make; command -v $program)" bin
  done
  printf '#!/bin/sh\nfor name; do case " $packages " in *" $name "*) echo "ii $name";; esac; done\n' >bin/dpkg-query
  chmod +x bin/dpkg-query
  ln -s "$sources"/Makefile "$sources"/model "$sources"/verification "$sources"/reference-data .
  ln -s "$sources"/figures/paper/fig0[34].* "$sources"/figures/paper/style.gp figures/paper
  ln -s "$sources"/figures/maps/speed-friction.* "$sources"/figures/maps/rounding.* \
    "$sources"/figures/maps/map.gp "$sources"/figures/maps/shares.awk figures/maps
}
make() {
  said=$(env -i PATH="$PWD/bin" packages="$packages" make PYTHON=python3 "$@" 2>&1) && failed= || failed=1
  echo "$said" | sed -E 's/Makefile:[0-9]+/Makefile/'
  [ -z "$failed" ]
}
needed=$(sed -n '/^PACKAGES :=/,/[^\\]$/p' "$sources/Makefile" | sed 's/PACKAGES :=//;s/\\//')

# What make would do once the program is there.
plan() { packages=$needed make -n -o build "$@"; }
