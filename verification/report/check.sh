#!/usr/bin/env bash
# What `make check-report` does: checks the page in a browser, the functions of its scripts, and the
# spelling of page and README.
set -uo pipefail
build=$1
page=$build/report/index.html
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
failed=0
if [ -n "$browser" ] && [ -d "$build/check-report/node_modules/playwright-core" ]; then
  node verification/report/check_page.mjs "$page" "$browser" "$build/rotor" || failed=1
else
  echo "check-report: Chromium or playwright-core is missing: make deps-report installs both" >&2
  failed=1
fi

tests=$(node --test verification/report/script.test.mjs) || { echo "$tests" >&2; failed=1; }

if ! command -v hunspell >/dev/null; then
  echo "check-report: there is no hunspell: make deps-report installs it" >&2
  exit 1
fi
# Words outside code and pictures, checked against English and technical terms.
misspelt() { hunspell -l -d en_GB -p verification/report/words.txt | sort -u | tr '\n' ' '; }
of_page=$(perl -0pe 's/<(style|script|svg|math|pre|code|sub)\b.*?<\/\1>//gs; s/&shy;//g; s/<[^>]*>/ /g; s/&\w+;/ /g; s/\bEqs?\.//g; s/\S*\d\S*//g' "$page" | misspelt)
of_readme=$(perl -0pe 's/```.*?```//gs; s/`[^`]*`//g; s/^    .*//gm; s/\]\([^)]*\)//g; s/\bEqs?\.//g; s/\S*[\d_]\S*//g' README.md | misspelt)
[ -z "$of_page" ] || { echo "check-report: not in the dictionary, on the page: $of_page" >&2; failed=1; }
[ -z "$of_readme" ] || { echo "check-report: not in the dictionary, in README.md: $of_readme" >&2; failed=1; }
exit $failed
