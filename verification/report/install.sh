#!/usr/bin/env bash
# What `make deps-report` does: installs a browser, Node.js to drive it, and a dictionary: install.sh BUILD
set -euo pipefail
folder=$1/check-report
figures/make/packages.sh install deps-report
# Node.js from elsewhere includes npm and conflicts with Debian's.
command -v npm >/dev/null || figures/make/packages.sh install node
mkdir -p "$folder"
cp verification/report/package*.json "$folder"
cd "$folder"
npm ci --ignore-scripts --no-audit --no-fund
