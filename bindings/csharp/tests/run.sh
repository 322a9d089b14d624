#!/usr/bin/env bash
# run.sh MCS MONO: builds the assembly and its tests by Mono's compiler, with and without spans, and runs them.
set -euo pipefail
mcs=$1
mono=$2
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for spans in "" -define:CONTDYN_SPANS; do
    "$mcs" -unsafe -warnaserror $spans -target:library -out:Contdyn.dll "$here"/../src/*.cs
    "$mcs" -warnaserror $spans -out:Tests.exe -r:Contdyn.dll -r:System.Core "$here"/*.cs
    "$mono" Tests.exe "$here/../.."
done
"$mcs" -warnaserror -out:Calls.exe -r:Contdyn.dll "$here"/../benchmarks/Calls.cs
