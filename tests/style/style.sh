#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Checks of style. Usage: style.sh rooms|licence|guards|format|ceilings ROOT,
# style.sh one_definition ROOT OBJECT...
# Prints file:line and what is wrong; exit 1 if anything is.
set -euo pipefail
export LC_ALL=C

check=$1
root=$2
cd "$root"

# All C++ sources, or those below the folders named.
sources() {
  find "$@" -type f \( -name '*.h' -o -name '*.cc' \) | sort
}
rooms=(dem fem coupling apps)

# What a file of a room may include, as an extended regular expression. The
# standard library is what has no slash and no ending.
standard='[a-z0-9_]+'
# deal.II's own: PETSc, Trilinos, MPI and Boost come with it.
deal='deal\.II/[^>]*|petsc[^>]*|Teuchos[^>]*|Epetra[^>]*|Amesos[^>]*|Sacado[^>]*'
deal+='|AztecOO[^>]*|ml_[^>]*|boost/[^>]*|mpi\.h'
# Whatever is not of the program itself.
any="$standard|[b-z][^>]*|[A-Z][^>]*"
allowed_in() {
  local room
  case $1 in
    dem/kernel/*) echo "$standard|Eigen/[^>]*|dem/[^>]*|hwy/[^>]*" ;;
    dem/*) echo "$standard|Eigen/[^>]*|dem/[^>]*" ;;
    fem/*) echo "$standard|fem/[^>]*|$deal" ;;
    coupling/*)
      echo "$standard|Eigen/[^>]*|(dem|fem|coupling)/[^>]*|$deal|vtk[^>]*|(hdf5|fcntl|unistd|zlib)\.h" ;;
    apps/input/*) echo "$any|apps/input/[^>]*" ;;
    apps/output/*) echo "$any|apps/(input|output)/[^>]*" ;;
    apps/run/*) echo "$any|apps/(input|output|run)/[^>]*" ;;
    apps/*/*)
      room=$(cut -d / -f 2 <<< "$1")
      echo "$any|apps/(input|output|run|$room)/[^>]*|apps/command[a-z_]*\.h" ;;
    *) echo "[^>]*" ;;
  esac
}

check_rooms() {
  local file found=0 wrong
  while read -r file; do
    wrong=$(awk -v allowed="^($(allowed_in "$file"))\$" -v file="$file" '
      /^[ \t]*#[ \t]*include/ {
        if (match($0, /"[^"]*"/)) {
          printf "%s:%d: include by full path in <>: %s\n", file, NR, $0
          next
        }
        match($0, /<[^>]*>/)
        name = substr($0, RSTART + 1, RLENGTH - 2)
        if (name !~ allowed)
          printf "%s:%d: this room may not include <%s>\n", file, NR, name
      }' "$file")
    if [ -n "$wrong" ]; then
      echo "$wrong"
      found=1
    fi
  done < <(sources "${rooms[@]}")
  return $found
}

check_licence() {
  local found=0 file
  while read -r file; do
    if ! head -n 3 "$file" | grep -q 'SPDX-License-Identifier: BSD-3-Clause'
    then
      echo "$file:1: the line 'SPDX-License-Identifier: BSD-3-Clause' is missing"
      found=1
    fi
  done < <(
    sources "${rooms[@]}" tests
    find "${rooms[@]}" tests . -maxdepth 3 -type f \
      \( -name CMakeLists.txt -o -name '*.sh' -o -name '*.cmake' \) \
      ! -path './build*' ! -path './results/*' | sort -u
  )
  return $found
}

check_guards() {
  local found=0 file guard
  while read -r file; do
    guard=$(sed 's|[/.]|_|g' <<< "$file")
    if ! grep -q "^#ifndef $guard\$" "$file" ||
      ! grep -q "^#define $guard\$" "$file"; then
      echo "$file:2: the header guard should be $guard"
      found=1
    fi
  done < <(sources "${rooms[@]}" tests | grep '\.h$')
  return $found
}

# A missing clang-format 14 is a skipped test (77), not a passed one.
check_format() {
  local program=''
  for name in clang-format-14 clang-format; do
    if command -v "$name" > /dev/null &&
      "$name" --version | grep -q 'version 14\.'; then
      program=$name
      break
    fi
  done
  if [ -z "$program" ]; then
    echo "SKIPPED: clang-format 14 is not installed; the format is unchecked"
    return 77
  fi
  sources "${rooms[@]}" tests |
    xargs "$program" --style=file --dry-run -Werror
}

# Soft: warns, never fails.
check_ceilings() {
  local file lines ceiling
  while read -r file; do
    ceiling=400
    [[ $file == *.h ]] && ceiling=200
    lines=$(wc -l < "$file")
    if [ "$lines" -gt "$ceiling" ]; then
      echo "warning: $file has $lines lines; the soft ceiling is $ceiling"
    fi
    awk -v file="$file" '
      /^{/ { start = NR; name = last }
      /^}/ {
        if (start && NR - start - 1 > 50 &&
            name !~ /^(class|struct|enum|namespace|    *:|    *[,{])/)
          printf "warning: %s:%d: a function has %d lines; the soft ceiling is 50\n",
            file, start, NR - start - 1
        start = 0
      }
      /^[A-Za-z}]/ { last = $0 }' "$file"
  done < <(sources "${rooms[@]}")
  return 0
}

# Every definition in the objects of the kernel that a linker may pick for the
# whole program bears the name of the object's own instruction set: else code
# for AVX-512 could end up in a program on a machine that has none.
check_one_definition() {
  local object name set count found=0
  if [ $# -eq 0 ]; then
    echo "style.sh: one_definition wants the objects of the kernel" >&2
    return 2
  fi
  for object in "$@"; do
    name=$(sed 's|.*kernel_\([a-z0-9]*\)\..*|\1|' <<< "$object")
    case $name in
      scalar) set=N_SCALAR ;;
      avx2) set=N_AVX2 ;;
      avx512) set=N_AVX3 ;;
      neon) set=N_NEON ;;
      *)
        echo "$object: no instruction set is known by this name"
        return 1
        ;;
    esac
    # Capital letters are seen by the linker, u is unique, v and w are weak.
    count=$(nm -C --defined-only "$object" |
      awk -v set="::$set[A-Z0-9_]*::" -v own="tamp::dem::kernel_$name()" \
        -v object="$object" '
        $2 ~ /^[A-Zuvw]$/ {
          type = $2
          sub(/^[^ ]* [^ ]* /, "")
          ++seen
          if ($0 != own && $0 !~ set) {
            printf "%s: not of its instruction set alone: %s %s\n",
              object, type, $0 > "/dev/stderr"
            ++wrong
          }
        }
        END { print wrong + 0, seen + 0 }')
    [ "${count% *}" -eq 0 ] || found=1
    if [ "${count#* }" -lt 2 ]; then
      echo "$object: its loops are missing"
      found=1
    fi
  done
  return $found
}

case $check in
  one_definition) check_one_definition "${@:3}" ;;
  rooms | licence | guards | format | ceilings) "check_$check" ;;
  *)
    echo "style.sh: unknown check '$check'" >&2
    exit 2
    ;;
esac
