#!/usr/bin/env bash
# Builds targets of CMake, silently where nothing is to do:
#   build.sh FOLDER [-jN] [--without-digits] [--with NAME] [--preset NAME] TARGET...
# FOLDER is configured where it is new, or packages have changed since. With --without-digits a new one gets a `rotor`
# that estimates no digits, which compiles faster; later calls without that add them for good. --with builds an
# optional program, see ROTOR_WITH, that needs the packages of deps-NAME.
set -euo pipefail
cd -P "${0%/*}/../.."
folder=$1 jobs=() digits=ON with='' preset=release
shift
while [[ $1 = -* ]]; do
  case $1 in
    -j*) jobs=("$1") ;;
    --without-digits) digits=any ;;
    --with) with=$2; shift ;;
    --preset) preset=$2; shift ;;
    *) echo "build.sh: there is no option $1" >&2; exit 1 ;;
  esac
  shift
done

refuse() { echo "$*" >&2; exit 1; }
unescaped='[][;"\*?<>|&'\''`^$#]' # by CMake or by Ninja
[[ ! $PWD =~ $unescaped ]] || refuse "The path of this checkout, $PWD, has a ${BASH_REMATCH[0]}, which CMake or Ninja cannot handle; move the checkout"
figures/make/packages.sh check deps ${with:+deps-$with}
{ mkdir -p "$folder" && [ -w "$folder" ]; } 2>/dev/null || refuse "$folder: cannot be written"

cache=$folder/CMakeCache.txt
configured() {
  [ "$folder/build.ninja" -nt /var/lib/dpkg/status ] && [ "$folder/build.ninja" -nt CMakePresets.json ] &&
    grep -qx "ROTOR_WITH:STRING=$with" "$cache" && { [ $digits = any ] || grep -qx ROTOR_DIGITS:BOOL=ON "$cache"; }
}
home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$cache" 2>/dev/null) || true
[ "${home:-$PWD}" = "$PWD" ] || refuse "$folder was made for another path, $home; remove it: make clean"
exec {lock}<"$folder" # one at a time
flock $lock
if ! configured; then
  options=(-D "ROTOR_WITH=$with" -U 'GSL_*') # what was known of optional packages is forgotten
  [ $digits = any ] && [ -e "$cache" ] || options+=(-D ROTOR_DIGITS=${digits/any/OFF})
  log=$(cmake --preset "$preset" -B "$folder" "${options[@]}" 2>&1) ||
    refuse "$log${with:+$'\n'Install the packages of deps-$with anew.}"
fi
cmake --build "$folder" --target "$@" "${jobs[@]}" | sed -u '/no work to do\|Re-checking\|Re-running\|^-- \|Drawing/d'
