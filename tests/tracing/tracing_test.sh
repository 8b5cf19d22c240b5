#!/bin/bash
# Requirement R-1404: whatever breaks the trace from requirement to test is found and told with its place: a citation
# that is missing or of nothing, a requirement that lost its tests or has none; and how tests ended becomes the state of
# what they show.
# tracing_test.sh SOURCE_TREE
set -euo pipefail
source=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "tracing: $1" >&2; exit 1; }
trace() { /usr/bin/python3 -B "$tree/tests/traceability.py" "$@"; }

# A tree of what the trace is made from, small enough to be read here.
tree=$scratch/tree
plant() {
    rm -rf "$tree"
    mkdir -p "$tree/tests/room" "$tree/src/qualify"
    cp "$source/tests/traceability.py" "$tree/tests"
    cat > "$tree/tests/requirements.md" <<'END'
# Requirements

## First

| number | requirement | source | checks |
|---|---|---|---|
| R-101 | One holds. | design | M-01 |
| R-102 | Two holds. | the paper, Eq. 1 | |
| R-103 | Three holds. | design | |
| R-104 | Four holds. | design | |

## Not shown yet

- R-104: a test of
  two lines is missing.
END
    cat > "$tree/tests/room/one_test.cpp" <<'END'
// Requirement R-101: it holds, said in
// two lines.
TEST(One, Holds) {}
// R-102: what it shows of two.
TEST(One, HoldsToo) {}
END
    cat > "$tree/tests/room/two_test.sh" <<'END'
#!/bin/bash
# Requirement R-103, R-101: three holds.
# two_test.sh PROGRAM
END
    echo '{"M-01", "shows"}' > "$tree/src/qualify/mechanics.cpp"
    trace --check || fail "a sound trace is said to be broken"
}

# expect_fault CHECKED... is refused with a line that holds the first argument.
expect_fault() {
    ! trace --check > "$scratch/out" 2> "$scratch/err" || fail "not found: $1"
    grep -qF -- "$1" "$scratch/err" || fail "expected '$1', said was: $(cat "$scratch/err")"
    ! trace > "$scratch/out" 2> "$scratch/err" || fail "the matrix is told as if it were whole: $1"
}
page=tests/requirements.md one=tests/room/one_test.cpp two=tests/room/two_test.sh

plant; sed -i 's/ R-101:/:/' "$tree/$one"
expect_fault "$one:1:1: cites no requirement"
plant; sed -i 1d "$tree/$one"
expect_fault "$one:1:1: cites no requirement"
plant; sed -i '/^#!/!d' "$tree/$two"
expect_fault "$two:1:1: cites no requirement"
plant; sed -i 's/R-102: what/What/' "$tree/$one"
expect_fault "$page:8:3: R-102: shown by no test"
plant; sed -i 's/HoldsToo/DISABLED_HoldsToo/' "$tree/$one"
expect_fault "$page:8:3: R-102: shown by no test"
plant; sed -i 's/^TEST.*//' "$tree/$one"
expect_fault "$page:8:3: R-102: shown by no test"
plant; sed -i 's/R-103/R-102/' "$tree/$two"
expect_fault "$page:9:3: R-103: shown by no test"
plant; sed -i 's/^| R-103.*/&\n| R-105 | Five holds. | design | |/' "$tree/$page"
expect_fault "$page:10:3: R-105: shown by no test"
plant; sed -i 's/R-102: what/R-202: what/' "$tree/$one"
expect_fault "$one:5:1: One.HoldsToo: R-202 (no such requirement)"
plant; sed -i 's/R-103,/R-203,/' "$tree/$two"
expect_fault "$two:1:1: R-203 (no such requirement)"
plant; sed -i 's/^| R-103/| R-102/' "$tree/$page"
expect_fault "$page:9:3: R-102: stated twice (first in line 8)"
plant; sed -i 's/^\(| R-103.*\) | |$/\1 |/' "$tree/$page"
expect_fault "$page:9:1: no requirement (a row is"
plant; sed -i 's/R-102: what/R-104: what/' "$tree/$one"
expect_fault "$page:14:3: R-104: said not to be shown"
plant; sed -i 's/^- R-104/- R-109/' "$tree/$page"
expect_fault "$page:14:3: R-109 (no such requirement)"
plant; sed -i 's/^- R-104.*//' "$tree/$page"
expect_fault "$page:10:3: R-104: shown by no test"
plant; sed -i 's/| M-01 |/| |/' "$tree/$page"
expect_fault "src/qualify/mechanics.cpp:1:3: M-01: in no row"
plant; sed -i 's/M-01 |/M-01, M-02 |/' "$tree/$page"
expect_fault "$page:7:3: M-02 (no such check"

# What was not shown stands at the top, whole; a test under several stands in each.
plant
matrix=$scratch/matrix
trace > "$matrix"
grep -qFx -- '- R-104: a test of two lines is missing.' <(sed -n '1,/^## First/p' "$matrix") ||
    fail "what is not shown is hidden"
grep -qFx '*design*; qualify: M-01' "$matrix" || fail "the check is not told"
grep -qFx -- '- `tests/room/one_test.cpp`: it holds, said in two lines.' "$matrix" ||
    fail "what a file shows is not told"
[ "$(grep -cF 'One.HoldsToo: what it shows of two.' "$matrix")" = 2 ] ||
    fail "a test that shows two is not told under both"
grep -qFx -- '- `tests/room/two_test.sh`: three holds. (1 test, under R-103)' "$matrix" ||
    fail "a file that shows two is not told under both"

# States: all passed, one failed among them, nothing run; instances of one test count together, the worst is told.
ended() {
    echo '<testsuite>'
    while read -r name status; do echo "<testcase name=\"$name\" status=\"$status\"/>"; done
    echo '</testsuite>'
}
states() { ended > "$scratch/results.xml"; trace --results "$scratch/results.xml" > "$scratch/states"; }
state() { grep -qFx "### $1" "$scratch/states" || fail "expected '$1', said was: $(grep '^###' "$scratch/states")"; }
states <<< $'room/One.Holds run\nroom/All/One.HoldsToo/a run\nroom/All/One.HoldsToo/b run\nroom/two run'
state "R-101 (shown)"; state "R-102 (shown)"; state "R-103 (shown)"; state "R-104 (not shown yet)"
grep -qFx 'Of 4 requirements: 3 shown, 0 failed, 0 not run, 1 not shown yet.' "$scratch/states" ||
    fail "states are not counted"
states <<< $'room/One.Holds run\nroom/All/One.HoldsToo/a run\nroom/All/One.HoldsToo/b fail\nroom/two notrun'
state "R-101 (failed, 1 of 3 tests)"; state "R-102 (failed, 1 of 1 tests)"; state "R-103 (not run)"
grep -qF -- '- **FAILED** One.HoldsToo' "$scratch/states" || fail "a failure is not told"
states <<< $'room/One.Holds run\nroom/One.HoldsAlike run\nother/One.HoldsToo run'
state "R-101 (shown, 2 of 3 tests not run)"; state "R-102 (not run)"
# With results, too, a broken trace is told, behind what can be told.
sed -i 's/R-102: what/R-202: what/' "$tree/$one"
! trace --results "$scratch/results.xml" > "$scratch/states" 2> "$scratch/err" ||
    fail "a broken trace passes with results"
grep -q '^### R-101' "$scratch/states" && grep -qF 'R-202 (no such requirement)' "$scratch/err" ||
    fail "a broken trace hides the results"
echo "tracing: all is well"
