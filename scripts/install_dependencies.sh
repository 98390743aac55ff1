#!/usr/bin/env bash
# install_dependencies.sh LIST...   installs the Debian packages of these lists that are missing; fast if there are none.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")"
mapfile -t packages < <(grep -hv '^#' "$@")

missing=()
installed="$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' 2>/dev/null || true)"
for package in "${packages[@]}"; do
  grep -qx "$package installed" <<<"$installed" || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || {
    echo "These packages are missing, and neither root nor sudo is available: ${missing[*]}" >&2
    exit 1
  }
  as_root=(sudo)
fi

echo "Installing ${#missing[@]} Debian packages (three to six minutes on a fresh machine): ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
