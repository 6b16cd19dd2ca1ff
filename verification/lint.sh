#!/usr/bin/env bash
# What `make lint` does once everything is built: the format of all sources, and clang-tidy (see
# .clang-tidy) on those of model/ and figures/. cppcheck was tried and found nothing that is.
set -uo pipefail
build=$1
mapfile -t all < <(git ls-files '*.cpp' '*.hpp' '*.ipp')
clang-format --dry-run -Werror "${all[@]}" || exit 1

# clang cannot read gcc's precompiled headers, and has not its quadruple precision.
mkdir -p "$build/lint"
sed 's/-include [^ ]*cmake_pch.hxx//; s/-Winvalid-pch//; s/-DROTOR_QUADMATH//' "$build/compile_commands.json" \
  >"$build/lint/compile_commands.json"
# What only the browser's compiler builds has no command there; what other precisions are made of is
# looked at in double.
git ls-files 'model/**.cpp' 'figures/**.cpp' ':!figures/explore/main.cpp' \
  ':!model/simulation/extended/in_extended.cpp' ':!model/simulation/extended/in_quadruple.cpp' \
  ':!model/simulation/extended/event_method.cpp' | xargs -P "$(nproc)" -n 1 \
  clang-tidy -p "$build/lint" --quiet --warnings-as-errors='*' 2>/dev/null
