#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Every input that is shipped can be read. Usage: inputs.sh TAMP ROOT
set -euo pipefail

tamp=$1
cd "$2"
count=0
failed=0
while read -r file; do
  count=$((count + 1))
  "$tamp" params --check "$file" || failed=1
done < <(find apps tests meshes -name '*.prm' 2> /dev/null | sort)
echo "$count inputs read"
[ "$count" -gt 0 ] && [ "$failed" -eq 0 ]
