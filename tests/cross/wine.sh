#!/bin/sh
# wine.sh FOLDER PROGRAM [ARGUMENT...]: runs a program of Windows by Wine, which keeps its files in FOLDER. They are made
# by the first that asks, while others wait.
export WINEPREFIX="$1" WINEDEBUG=-all
shift
(
    flock 9
    [ -e "$WINEPREFIX/made" ] || { wine wineboot --init >/dev/null 2>&1 && touch "$WINEPREFIX/made"; }
) 9>"$WINEPREFIX.lock"
exec wine "$@"
