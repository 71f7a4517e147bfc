# SPDX-License-Identifier: BSD-3-Clause
# For tests of wrong inputs: a folder of their own, and expect. Reads $1.
source "$(dirname "${BASH_SOURCE[0]}")/begin.sh"
failures=0

# expect CODE TEXT... -- COMMAND: the exit code, and one message on stderr with
# all the texts.
expect() {
  local code=$1 texts=() status=0 text
  shift
  while [ "$1" != -- ]; do
    texts+=("$1")
    shift
  done
  shift
  "$@" > out.txt 2> err.txt || status=$?
  local wrong=''
  [ "$status" -eq "$code" ] || wrong="exit code $status, expected $code"
  [ "$(wc -l < err.txt)" -eq 1 ] || wrong+="; expected exactly one message"
  for text in "${texts[@]}"; do
    grep -qF -- "$text" err.txt || wrong+="; the message lacks '$text'"
  done
  if [ -n "$wrong" ]; then
    echo "FAILED: $*: $wrong"
    sed 's/^/  stderr: /' err.txt
    failures=$((failures + 1))
  else
    echo "passed: $(head -c 200 err.txt)"
  fi
}
