# How a case asks: what the program says, its exit code, and who holds lines afterwards, as libgpiod and as the kernel's debugfs tell.
after() {
  echo "exit code $1"
  guest used
  echo "lines in use by debugfs: $(grep -c '|' /sys/kernel/debug/gpio)"
}
run() { guest "$@"; after $?; }
# Starts the program in the background, and waits until it has said a word.
start() {
  word=$1
  : >/said  # not what the last one said
  shift
  guest "$@" >/said 2>&1 &
  while ! grep -q "$word" /said; do usleep 20000; kill -0 $! 2>/dev/null || break; done
}
ended() { { wait $!; } 2>/dev/null; code=$?; sed "${1:-}" /said; after $code; }
