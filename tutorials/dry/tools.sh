# What the Allrun scripts of this folder share; to be sourced. Expects etc/bashrc beside Allwmake two folders up from the
# tutorial.

start=$SECONDS
root="${CHESIL_DIR:-$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)}"
if [ -z "${CHESIL_DIR:-}" ]
then
    set +eu
    . "$root/etc/bashrc"
    set -eu
fi

step() { printf '\n== %s  (%d s so far)\n' "$*" "$((SECONDS - start))"; }

# pebbleModels <folder> <segments ...> <sides ...>: shapes of the pebbles in the photo of tutorials/quickStart,
# <folder>/polybezier<n>.chesil, polygon<n>.chesil, ellipse.chesil, circle.chesil. Those that are no polybezier are made
# from the finest polybezier
pebbleModels()
{
    local folder="$1" segments="$2" sides="$3" n finest=0
    for n in $segments
    do
        chesilFit "$root/tutorials/quickStart/pebbles.png" -segments "$n" -scale 1e-3 \
            -output "$folder/polybezier$n.chesil" > "log.fit$n"
        finest=$((n > finest ? n : finest))
    done
    for n in $sides
    do
        ../pebbleShapes "$folder/polybezier$finest.chesil" -polygon "$n" -output "$folder/polygon$n.chesil"
    done
    ../pebbleShapes "$folder/polybezier$finest.chesil" -ellipse -output "$folder/ellipse.chesil"
    ../pebbleShapes "$folder/polybezier$finest.chesil" -circle -output "$folder/circle.chesil"
}

# newRun <case> <run>
newRun()
{
    mkdir -p "$2"
    cp -r "$1"/constant "$1"/system "$2"
}

# shapeGroups <run> <name ...>: constant/shapes, of files in ./shapes
shapeGroups()
{
    local run="$1" name
    shift
    for name in "$@"
    do
        echo "$name { type templates; file \"../../shapes/$name.chesil\"; }"
    done > "$run/constant/shapes"
}

# parameters <run> "<name> <value>" ...: constant/run
parameters()
{
    local run="$1"
    shift
    printf '%s;\n' "$@" > "$run/constant/run"
}

# runAll <run ...>: as many at a time as there are processors; a line as each ends, exit status 1 if one failed
runAll()
{
    printf '%s\n' "$@" | xargs -P "$(nproc)" -I{} bash -c '
        chesilDEM -case {} > {}/log.chesilDEM 2>&1 && status="$(grep "^End:" {}/log.chesilDEM)" || status=FAILED
        echo "   {}: $status"
        [ "$status" != FAILED ] || { tail -n 5 {}/log.chesilDEM; exit 1; }'
}

# Twice the paper's, for the last grains to come to rest [s]
consolidation=2

# biaxialRun <grains.csv> <shapes> <run> "<name> <value>" ...: a packed sample between four smooth walls that press on it
# by 0.1 MPa until then
biaxialRun()
{
    local grains="$1" shapes="$2" run="$3"
    shift 3
    newRun "$root/tutorials/dry/biaxial/case" "$run"
    cp "$grains" "$run/constant/packed.csv"
    cp "$shapes" "$run/constant/shapes"
    parameters "$run" "$@"
    echo "endTime $consolidation;" > "$run/constant/end"
    touch "$run/constant/step"
    # As high as the grains reach
    awk -F, '$1 == "shape" { for (i = 1; i <= NF; ++i) column[$i] = i; next } /^#/ { next }
        { top = $column["y"] + $column["size"]; if (top > most) most = top }
        END { printf "loading\n{\n    type isotropic; lower (0 0 0); upper (1 %.9g 0); pressure 1e5; speed 0.5; material wall;\n}\n", most }' \
        "$grains" > "$run/constant/walls"
    # Without gravity, grains that nothing holds fly on until they hit something, now and then: so they come to rest
    echo "viscous 10;" > "$run/constant/drag"
}

# shorten <run> <speed of the lid, m/s> <duration, s>: from then on, at the same pressure from the sides
shorten()
{
    local run="$1" speed="$2" duration="$3"
    : > "$run/constant/drag"
    cat > "$run/constant/walls" <<END
walls
{
    // They stay where the pressure has put them
    left    { point (0 0 0); normal (1 0 0);  pressure 1e5; speed 0.5; between (floor lid); material wall; }
    right   { point (1 0 0); normal (-1 0 0); pressure 1e5; speed 0.5; between (floor lid); material wall; }
    floor   { point (0 0 0); normal (0 1 0);  material wall; }
    lid     { point (0 3 0); normal (0 -1 0); velocity (0 -$speed 0); material wall; }
}
END
    echo "endTime $(awk "BEGIN { print $consolidation + $duration }");" > "$run/constant/end"
}
