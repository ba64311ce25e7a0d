#!/usr/bin/env bash
# Puts the course onto The Littlest JupyterHub. Run it on that server, as an administrator, in a checkout of the course:
#     sudo deploy/tljh.sh [FOLDER-OF-THE-EXCHANGE]
set -euo pipefail
cd "$(dirname "$0")/.."
exchange=${1:-}
user=/opt/tljh/user/bin
config=/opt/tljh/config/jupyterhub_config.d
[ -x "$user/pip" ] || { echo "There is no $user: install The Littlest JupyterHub first (https://tljh.jupyter.org)." >&2; exit 1; }

"$user/pip" install --constraint requirements.lock ".[hub,network]"
"$user/coursekit" hub-prepare /srv/coursekit
mkdir -p "$config"
install -m 644 deploy/hub_config.py "$config/coursekit.py"
if [ -n "$exchange" ]; then
  mkdir -p "$exchange"
  install -m 644 /dev/stdin "$config/coursekit_exchange.py" <<< "c.Spawner.environment[\"COURSEKIT_EXCHANGE\"] = \"$exchange\""
fi
tljh-config reload hub
COURSEKIT_SHARED=/srv/coursekit COURSEKIT_EXCHANGE="$exchange" "$user/coursekit" hub-check
