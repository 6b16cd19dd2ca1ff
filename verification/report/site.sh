#!/usr/bin/env bash
# What `make site` does: collects the page, the pictures, the data and the maps in a folder that any
# static host can serve, and archives it with a checksum. The same commit gives the same bytes.
set -euo pipefail
build=$1
site=$build/site
rm -rf "$site"
mkdir -p "$site/rotor"
verification/report/report.sh "$build" "$site/rotor" archive >/dev/null
touched=$(git show -s --format=%ct HEAD 2>/dev/null || echo 0)
tar --create --sort=name --format=ustar --mtime="@$touched" --owner=0 --group=0 --numeric-owner \
  --mode=u=rwX,go=rX --directory "$site" rotor | gzip --no-name --best >"$site/rotor.tar.gz"
(cd "$site" && sha256sum rotor.tar.gz >rotor.tar.gz.sha256)
echo "$site/rotor/index.html"
cat "$site/rotor.tar.gz.sha256"
