# Campaigns for the tests here, in the folder of the cluster. Sourced.
# shellcheck shell=bash

# campaign NAME WAVES SEED : about 15 ms a wave
campaign() {
    cat >"$1.toml" <<END
seed = $3
[waves]
source = 'spectrum-compatible'
count = $2
duration = '40.96 s'
time_step = '0.01 s'
match = 'each'
[waves.target]
spectrum = 'mlit-ch1'
time_scale = 0.632
[waves.envelope]
shape = 'jennings'
rise = '4 s'
level_end = '20 s'
end = '36 s'
[[bodies]]
name = 'type-b'
mass = '12.6 t'
base_width = '0.9 m'
centre_height = '1.045 m'
inertia = 'uniform-block'
[levels]
measure = 'pga'
values = ['300 gal', '600 gal', '1200 gal']
END
}

blocks_of() { find "$1.h5.parts" -name '*.block' 2>/dev/null | wc -l; }
more_blocks_than() { [ "$(blocks_of "$1")" -gt "$2" ]; }

# The file that one unbroken run makes is the measure of all.
expect_same() {
    "$OVERTURN" run "$1.toml" -o "unbroken-$1.h5" >unbroken.log 2>&1 || fail "the unbroken run of $1"
    cmp "$1.h5" "unbroken-$1.h5" || fail "$1.h5 differs from an unbroken run's"
    [ ! -e "$1.h5.parts" ] || fail "$1.h5.parts is still there"
}
