#!/bin/sh
# wine.sh FOLDER PROGRAM [ARGUMENT...]: runs a program of Windows by Wine, which keeps its files in FOLDER. They are made
# by the first that asks, while others wait. What the program says goes through a file: Wine's services live on for some
# seconds after it, and whoever reads a pipe would wait for them to close it too.
export WINEPREFIX="$1" WINEDEBUG=-all
shift
(
    flock 9
    [ -e "$WINEPREFIX/made" ] || { wine wineboot --init >/dev/null 2>&1 && touch "$WINEPREFIX/made"; }
) 9>"$WINEPREFIX.lock"
said=$(mktemp)
wine "$@" >"$said" 2>&1
status=$?
cat "$said"
rm "$said"
exit $status
