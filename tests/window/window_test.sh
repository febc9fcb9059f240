# What the tests in a real window share: a display of their own, a session on it, what its study
# holds. To be sourced with `program` and `source` (the project's root) set.
#
# shellcheck shell=bash

work=$(mktemp -d)
clean_up() {
  # shellcheck disable=SC2046 # one word for each job
  kill -KILL $(jobs -p) 2>/dev/null || true
  rm -rf "$work"
}
trap clean_up EXIT
cd "$work" || exit 1

fail() {
  echo "FAILED: $*" >&2
  [ -f output ] && sed 's/^/  program: /' output >&2
  exit 1
}

# open_display [SIZE]: sets DISPLAY and `server`. A small one: all is drawn by software.
open_display() {
  : >display
  Xvfb -displayfd 3 -noreset -screen 0 "${1:-640x512}x24" 3>display 2>/dev/null &
  server=$!
  for _ in $(seq 100); do
    [ -s display ] && break
    sleep 0.1
  done
  DISPLAY=:$(cat display)
  export DISPLAY
  export LP_NUM_THREADS=0 # pictures of this size gain nothing from threads, which take a ninth of a test
}

# pixel X Y: its colour, such as #E2E2E2.
pixel() {
  import -silent -window root -crop "1x1+$1+$2" -depth 8 txt:- | grep -o '#[0-9A-F]\{6\}' | head -1
}

query() { sqlite3 -cmd '.timeout 2000' study.sqlite "$1" 2>/dev/null || echo none; }

# until_query "SQL" EXPECTED ACTION...: repeats the actions, in turn, until the answer is there.
until_query() {
  local sql=$1 expected=$2
  shift 2
  for _ in $(seq 300); do
    for action in "$@"; do
      [ "$(query "$sql")" = "$expected" ] && return 0
      # shellcheck disable=SC2086 # an action is a command of xdotool with its arguments
      xdotool $action
      sleep 0.3
    done
  done
  fail "expected $expected from: $sql; got $(query "$sql")"
}

expect() {
  local got
  got=$(sqlite3 -cmd '.timeout 2000' study.sqlite "$1" 2>&1) || true
  [ "$got" = "$2" ] || fail "expected $2 from: $1; got $got"
}

# The program, `session`, ends by itself with this status.
await_exit() {
  local status=0
  timeout 60 tail --pid="$session" -f /dev/null || fail "the program did not end"
  wait "$session" || status=$?
  [ "$status" -eq "$1" ] || fail "expected exit status $1, got $status"
}

# leave_by ACTION: repeats the action until the program has ended well. A page or a window that is not
# on the screen yet, as on a busy machine, does not hear the first.
leave_by() {
  for _ in $(seq 100); do
    kill -0 "$session" 2>/dev/null || break
    # shellcheck disable=SC2086 # an action is a command of xdotool with its arguments
    xdotool $1
    sleep 0.3
  done
  await_exit 0
}

# protocols/short.json: the shipped study with one trial of practice and four that count; screen.json.
make_short_study() {
  mkdir protocols
  cp -r "$source/stimuli" .
  sed -e 's/"levels": \[0, 100, 300\]/"levels": [0, 300]/' \
      -e 's/"levels": \[5, 10, 15\]/"levels": [10]/' \
      -e 's/"levels": \[0, 45, 85\]/"levels": [0, 45]/' \
      -e 's/"repetitions": 3/"repetitions": 1/' -e 's/"every": 27/"every": 3/' \
      "$source/protocols/causality.json" |
    sed -e '/"practice": \[/,/^    \]/c\    "practice": [{"delay_ms": 300, "speed_deg_s": 10, "viewpoint_deg": 45}]' \
    >protocols/short.json
  make_screen
}

make_screen() {
  "$program" screen --width-cm 37.6 --height-cm 30.1 --distance-cm 57 --file screen.json >/dev/null
}
