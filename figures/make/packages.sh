#!/usr/bin/env bash
# Packages of Debian that packages.txt lists for targets: packages.sh check|install TARGET...
# Where there is no dpkg, `check` leaves it to CMake to find what is missing.
set -euo pipefail
list=${0%/*}/packages.txt command=$1
shift
for target; do
  packages=($(awk -v target="$target:" '$1 == target { sub(/#.*/, ""); $1 = ""; print }' "$list"))
  if [ ${#packages[@]} = 0 ]; then
    echo "$target: must be one of:" $(sed -n 's/^\(deps[a-z-]*\):.*/\1/p' "$list" | uniq) >&2
    exit 1
  fi
  if [ "$command" = install ] && ! command -v apt-get >/dev/null; then
    echo "This installs with apt-get, which this system does not have. Needed are the equivalents of: ${packages[*]}" >&2
    exit 1
  fi
  command -v dpkg-query >/dev/null || continue
  installed=$(dpkg-query -W -f='${db:Status-Abbrev}${Package}\n' "${packages[@]}" 2>/dev/null) || true
  missing=()
  for package in "${packages[@]}"; do
    grep -qx "ii *$package" <<<"$installed" || missing+=("$package")
  done
  if [ ${#missing[@]} -gt 0 ] && [ "$command" = check ]; then
    echo "Missing packages: ${missing[*]} (make $target installs them)" >&2
    exit 1
  elif [ ${#missing[@]} -gt 0 ]; then
    sudo=$([ "$(id -u)" -eq 0 ] || echo sudo)
    $sudo apt-get update -q
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
  fi
done
