# SPDX-License-Identifier: MIT
# compile_jobs: one compiler for each core, but only one for each 2 GiB of free memory, which is what one may take.
compile_jobs() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/^MemAvailable/ {print int($2 / 2097152)}' /proc/meminfo)
  if [ "$memory" -lt 1 ]; then memory=1; fi
  echo $((cores < memory ? cores : memory))
}

# install_packages NAME...: installs the Debian packages that are missing, after a line about their size. Needs root or
# sudo only if one is missing. For demo.sh and gallery.sh.
install_packages() {
  local package status missing=() as_root=() log
  for package in "$@"; do
    status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  [ "$(id -u)" = 0 ] || as_root=(sudo)
  log=$(mktemp)
  echo "== Installing ${missing[*]}"
  "${as_root[@]}" apt-get update -q >"$log" 2>&1 || { cat "$log"; return 1; }
  LC_ALL=C apt-get install --assume-no --no-install-recommends "${missing[@]}" 2>/dev/null |
    grep -E 'newly installed|^Need to get|^After this' | sed 's/^/   /' || true
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}" \
    >"$log" 2>&1 || { cat "$log"; return 1; }
  rm -f "$log"
}
