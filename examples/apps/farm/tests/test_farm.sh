#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests of shd-farm with local ranks.
# Usage: test_farm.sh CASE FARM FOLDER
set -euo pipefail
. "$(dirname "$0")/launch.sh"
case=$1 farm=$2 folder=$3
for tool in mpirun:openmpi-bin pgrep:procps; do
  command -v "${tool%:*}" >/dev/null || { echo "skipped: ${tool%:*} is absent, ${tool#*:}"; exit 77; }
done
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
picture=(--size 500x300 --window 32)
windows=160

fail() {
  echo "FAILED: $*"
  exit 1
}
expect_equal() { cmp "$1" "$2" || fail "$1 and $2 differ"; }
expect_text() { grep -q -- "$1" "$2" || { cat "$2"; fail "no '$1' in $2"; }; }
alone() { "$farm" "${picture[@]}" --single 16384 -o alone.exr "$@"; }

# begin_job FILE RANKS OPTIONS...: in the background, as $job; returns when a quarter of the windows is kept
begin_job() {
  local file=$1 ranks=$2
  shift 2
  launch "$ranks" "$farm" "${picture[@]}" -o "$file" "$@" >job.log 2>&1 &
  job=$!
  wait_for_windows "$file.journal" $((windows / 4)) "$job" || { cat job.log; exit 1; }
}

# end_job: its status as $status
end_job() {
  status=0
  wait "$job" || status=$?
}

slow=(--supersampling 12 --samples 16 --size 750x450 --window 48)  # seconds, so that a rank can be killed half-way

case_ranks() {
  alone
  for ranks in 1 2 3 5; do
    launch "$ranks" "$farm" "${picture[@]}" -o "on$ranks.exr"
    expect_equal "on$ranks.exr" alone.exr
  done
  launch 3 "$farm" "${picture[@]}" --through-root -o root.exr
  expect_equal root.exr alone.exr
  launch 2 "$farm" "${picture[@]}" --threads 2 --no-reserve -o threads.exr
  expect_equal threads.exr alone.exr
  "$farm" "${picture[@]}" --single 64 -o bands.exr
  expect_equal bands.exr alone.exr
  [ ! -e on2.exr.part ] && [ ! -e on2.exr.journal ] || fail "files are left"
}

case_frames() {
  launch 3 "$farm" --size 200x150 --window 64 --frames 5 -o turn.exr
  for frame in 0 1 2 3 4; do
    "$farm" --size 200x150 --window 64 --frames 5 --frame "$frame" --single 200 -o array.exr
    expect_equal "turn.000$frame.exr" "array.000$frame.exr"
  done
  ! cmp -s turn.0000.exr turn.0001.exr || fail "the camera stands still"
  rm turn.0002.exr
  launch 2 "$farm" --size 200x150 --window 64 --frames 5 -o turn.exr >again.log
  expect_text 'turn.0004.exr was finished' again.log
  expect_equal turn.0002.exr array.0002.exr
}

# The last rank is killed, or rank 0, or the launcher. Each job is resumed.
case_resume() {
  picture=("${slow[@]}")
  alone
  for victim in last first launcher; do
    file=$victim.exr
    begin_job "$file" 3
    case $victim in
      last) kill -KILL "$(ranks_of "$job" | tail -n 1)" ;;
      first) kill -KILL "$(ranks_of "$job" | head -n 1)" ;;
      launcher) kill -KILL "$(pgrep -P "$job" -x mpirun || echo "$job")" ;;
    esac
    end_job
    [ "$status" -ne 0 ] || fail "the status is 0 after the kill: $victim"
    [ "$victim" = launcher ] || expect_text 'signal 9' job.log
    # Ranks without a launcher end by themselves, or finish the picture before they notice.
    for _ in $(seq 100); do
      if [ "$victim" = launcher ] && [ -e "$file" ]; then
        expect_equal "$file" alone.exr
        return
      fi
      [ -e "$file.part" ] || fail "the job has ended before the kill: $victim"
      flock -n "$file.part" true && break || sleep 0.1
    done
    [ ! -e "$file" ] || fail "a part has the final name"
    kept=$(($(wc -l <"$file.journal") - 1))
    launch 2 "$farm" "${picture[@]}" -o "$file" | tee resumed.log
    expect_text "160 windows: $kept from earlier jobs" resumed.log
    expect_equal "$file" alone.exr
  done
}

case_corrupt() {
  picture=("${slow[@]}")
  begin_job bad.exr 2
  kill -KILL "$(ranks_of "$job" | tail -n 1)"
  end_job
  alone
  cp bad.exr.part good.part
  cp bad.exr.journal good.journal
  # Bytes of tiles, and lines of the journal: changed, torn, of a window that does not exist.
  printf 'damage' | dd of=bad.exr.part bs=1 seek=9000 conv=notrunc 2>/dev/null
  sed -i '3s/^......../0000ffff/;4s/[0-9a-f]$/-/' bad.exr.journal
  printf '00000007 0123' >>bad.exr.journal
  launch 2 "$farm" "${picture[@]}" -o bad.exr >repaired.log 2>&1
  expect_text '3 damaged lines' repaired.log
  expect_equal bad.exr alone.exr
  for damage in 'truncate -s 5000 bad.exr.part' 'rm bad.exr.part' 'truncate -s 0 bad.exr.journal' \
    'truncate -s 77 bad.exr.journal' 'sed -i 1s/shd/SHD/ bad.exr.journal'; do
    rm bad.exr
    cp good.part bad.exr.part
    cp good.journal bad.exr.journal
    $damage
    launch 2 "$farm" "${picture[@]}" -o bad.exr >repaired.log 2>&1 || { cat repaired.log; fail "$damage"; }
    expect_equal bad.exr alone.exr
  done
  # A checkpoint of another picture is refused and kept.
  rm bad.exr
  cp good.part bad.exr.part
  cp good.journal bad.exr.journal
  ! launch 2 "$farm" "${picture[@]}" --orbit 1,2 -o bad.exr >refused.log 2>&1 || fail "another picture is resumed"
  expect_text 'begun with another scene or other options' refused.log
  cmp bad.exr.journal good.journal || fail "the refused journal has changed"
}

# A limit on the size of files is a full disk: at the beginning, where space is reserved, and half-way.
case_disk() {
  picture=(--size 2048x2048 --window 128)  # 32 MiB; MPI has files of some MiB of its own
  alone
  for options in "" --no-reserve; do
    status=0
    # shellcheck disable=SC2086
    (ulimit -f 20480; launch 2 "$farm" "${picture[@]}" $options -o full.exr) >full.log 2>&1 || status=$?
    [ "$status" -ne 0 ] || fail "no error on a full disk"
    expect_text 'full.exr.part: cannot .* (the disk or the quota is full)' full.log
    expect_text 'the same command resumes it' full.log
    [ ! -e full.exr ] || fail "a part has the final name"
    launch 2 "$farm" "${picture[@]}" $options -o full.exr >resumed.log
    expect_equal full.exr alone.exr
    [ -z "$options" ] || ! grep -q ': 0 from earlier jobs' resumed.log || fail "no window was kept"
    rm full.exr
  done
  mkdir disk
  if ! mount -t tmpfs -o size=20m shd-farm disk 2>/dev/null; then
    echo "no small disk: mount needs root"
    return
  fi
  trap 'umount "$folder/disk"' EXIT
  ! launch 2 "$farm" "${picture[@]}" --no-reserve -o disk/full.exr >full.log 2>&1 || fail "no error on a full disk"
  expect_text 'No space left on device' full.log
  mount -o remount,size=80m disk
  launch 2 "$farm" "${picture[@]}" --no-reserve -o disk/full.exr
  expect_equal disk/full.exr alone.exr
}

# A rank that is stopped, as on a node that hangs.
case_stopped() {
  picture=("${slow[@]}")
  alone
  for victim in tail head; do
    begin_job "$victim.exr" 3 --timeout 2
    kill -STOP "$(ranks_of "$job" | "$victim" -n 1)"
    begin=$SECONDS
    end_job
    [ "$status" -ne 0 ] || fail "no error with a stopped rank"
    [ $((SECONDS - begin)) -le 20 ] || fail "the job ended after $((SECONDS - begin)) s"
    expect_text 'has not answered for 2 s, the job ends' job.log
    launch 3 "$farm" "${picture[@]}" -o "$victim.exr"
    expect_equal "$victim.exr" alone.exr
  done
}

case_refused() {
  while read -r text options; do
    status=0
    # shellcheck disable=SC2086
    "$farm" $options >refused.log 2>&1 || status=$?
    [ "$status" -ne 0 ] && [ "$status" -lt 128 ] || fail "$options: status $status"
    expect_text "${text//_/ }" refused.log
  done <<'END'
--size:_"0x10"_is_not_WIDTHxHEIGHT,_each_1..65536 --size 0x10
is_not_WIDTHxHEIGHT --size 10x65537
is_not_WIDTHxHEIGHT --size 10
is_not_WIDTHxHEIGHT --size 1.5x2
--window:_"8"_is_not_a_whole_number_16..4096 --window 8
--samples:_"3"_is_not_1,_2,_4,_8_or_16 --samples 3
--frame:_2_is_not_in_0..1 --frames 2 --frame 2
--supersampling:_16_times --size 5000x10 --supersampling 16
does_not_end_with_.exr -o picture.png
--verbose_is_not_an_option --verbose
--size_needs_a_value --size
"90,90"_is_not_AZIMUTH,ELEVATION --orbit 90,90
none.obj --model none.obj
cannot_be_opened -o none/farm.exr
END
  launch 1 "$farm" "${picture[@]}" -o twice.exr
  ! launch 1 "$farm" "${picture[@]}" --orbit 1,2 -o twice.exr >refused.log 2>&1 || fail "a finished picture is replaced"
  expect_text 'a picture of another scene or other options' refused.log
}

"case_$case"
echo "$case: passed"
