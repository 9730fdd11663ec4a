# Opens the window on a virtual screen and checks that it shows records and model.
shows_window() { # the command that opens it, with the records of the demonstration
    local screen shown=no colours=0 server opened
    Xvfb -displayfd 3 -screen 0 1440x900x24 3>screen >/dev/null 2>&1 &
    server=$!
    for _ in $(seq 50); do [ -s screen ] && break; sleep 0.1; done
    screen=:$(cat screen)
    DISPLAY=$screen "$@" >window.said 2>&1 &
    opened=$!
    # Plots have many colors, because the edges of lines and letters are smoothed. An empty screen has one color. The window had 273 colors
    # without records, and 12,546 with those of the demonstration.
    for _ in $(seq 90); do
        sleep 1
        colours=$(import -display "$screen" -window root png:- 2>/dev/null | convert png:- -format %k info: 2>/dev/null)
        [ "${colours:-0}" -gt 1000 ] && shown=yes && break
    done
    kill $opened 2>/dev/null
    kill $server
    echo "${colours:-0} colours; it said: $(cat window.said)"
    [ $shown = yes ]
}
check_window() { # name, command...
    local name=$1
    shift
    if has Xvfb && has import; then check "$name" shows_window "$@"; else skip "$name" "needs Xvfb and ImageMagick (Debian: xvfb imagemagick)"; fi
}
